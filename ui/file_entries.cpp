// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/file_entries.h"

#include <algorithm>
#include <cctype>

namespace trivar::ui {
namespace fs = std::filesystem;
namespace {

std::string lower(std::string text)
{
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

} // namespace

bool has_extension(const std::string& name, const std::vector<std::string>& extensions)
{
    const std::string small = lower(name);
    return extensions.empty() ||
           std::any_of(extensions.begin(), extensions.end(),
                       [&](const std::string& e) { return small.ends_with(e); });
}

bool natural_less(const std::string& a, const std::string& b)
{
    const auto digit = [](char c) { return c >= '0' && c <= '9'; };
    const std::string x = lower(a), y = lower(b);
    std::size_t i = 0, j = 0;
    while (i < x.size() && j < y.size()) {
        if (digit(x[i]) && digit(y[j])) { // runs of digits compare as numbers: by length, then text
            while (i + 1 < x.size() && x[i] == '0' && digit(x[i + 1])) ++i;
            while (j + 1 < y.size() && y[j] == '0' && digit(y[j + 1])) ++j;
            std::size_t m = i, n = j;
            while (m < x.size() && digit(x[m])) ++m;
            while (n < y.size() && digit(y[n])) ++n;
            if (m - i != n - j) return m - i < n - j;
            const int order = x.compare(i, m - i, y, j, n - j);
            if (order != 0) return order < 0;
            i = m;
            j = n;
        } else {
            if (x[i] != y[j]) return x[i] < y[j];
            ++i;
            ++j;
        }
    }
    if ((i < x.size()) != (j < y.size())) return j < y.size();
    return a < b;
}

std::vector<FileEntry> entries_of(const fs::path& folder,
                                  const std::vector<std::string>& extensions)
{
    std::vector<FileEntry> entries;
    std::error_code trouble;
    for (fs::directory_iterator it(folder, trouble), end; !trouble && it != end;
         it.increment(trouble)) {
        std::error_code ignored;
        FileEntry entry{it->path().filename().string(), it->is_directory(ignored), 0};
        if (entry.name.empty() || entry.name[0] == '.') continue;
        if (!entry.folder && !has_extension(entry.name, extensions)) continue;
        if (!entry.folder) entry.bytes = it->file_size(ignored);
        if (ignored) entry.bytes = 0;
        entries.push_back(std::move(entry));
    }
    std::sort(entries.begin(), entries.end(), [](const FileEntry& a, const FileEntry& b) {
        return a.folder != b.folder ? a.folder : natural_less(a.name, b.name);
    });
    return entries;
}

} // namespace trivar::ui
