// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/nrrd_fields.h"

#include "core/base/rejected.h"
#include "core/files/file_sentences.h"
#include "core/files/text_scan.h"

#include <algorithm>
#include <cstdlib>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr std::size_t longest_head = 1'000'000;
constexpr long most_names = 100'000;

std::string_view without_end(std::string_view line)
{
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

// The value of the field that names data files; empty if the line is another field.
std::string_view data_file_value(std::string_view line)
{
    for (const std::string_view field : {"data file:", "datafile:"})
        if (line.size() > field.size() &&
            std::equal(field.begin(), field.end(), line.begin(),
                       [](char a, char b) { return a == (b >= 'A' && b <= 'Z' ? b + 32 : b); })) {
            TextScan scan(line.substr(field.size()));
            return scan.rest();
        }
    return {};
}

} // namespace

std::vector<std::string> numbered_names(const std::string& pattern, int first, int last, int step,
                                        const std::string& name)
{
    const auto damaged = [&] {
        throw Rejected(fmt::format("{}: '{}' names no numbered files; it should be such as "
                                   "slice%03d.raw 1 93 1",
                                   name, shown(pattern)));
    };
    const std::size_t percent = pattern.find('%');
    if (percent == pattern.npos || step == 0) damaged();
    std::size_t at = percent + 1, width = 0;
    const bool zeros = at < pattern.size() && pattern[at] == '0';
    for (; at < pattern.size() && pattern[at] >= '0' && pattern[at] <= '9' && width < 10; ++at)
        width = 10 * width + static_cast<std::size_t>(pattern[at] - '0');
    if (at >= pattern.size() || (pattern[at] != 'd' && pattern[at] != 'u') || width > 20) damaged();
    const std::string front = pattern.substr(0, percent), back = pattern.substr(at + 1);
    if (back.find('%') != back.npos) damaged();
    const long count = (static_cast<long>(last) - first) / step + 1;
    if (count < 1 || count > most_names) damaged();
    std::vector<std::string> names;
    for (long k = 0; k < count; ++k) {
        std::string number = std::to_string(first + k * step);
        if (number.size() < width) number.insert(0, width - number.size(), zeros ? '0' : ' ');
        names.push_back(front + number + back);
    }
    return names;
}

NrrdFields nrrd_fields(std::string_view bytes, const std::string& name)
{
    NrrdFields fields;
    TextScan scan(bytes);
    bool list = false;
    while (!scan.done()) {
        const std::string_view line = without_end(scan.line());
        if (bytes.size() - static_cast<std::size_t>(scan.end - scan.at) > longest_head)
            throw Rejected(name + ": the head of this NRRD file does not end; an empty line should "
                                  "follow it");
        if (list) {
            if (!line.empty()) fields.data_files.emplace_back(line);
            continue;
        }
        if (line.empty()) break;
        const std::string_view value = data_file_value(line);
        if (value.empty()) {
            if (line.find('\0') == line.npos) fields.text.append(line).append("\n");
            continue;
        }
        TextScan words(value);
        const std::string first(words.word());
        if (first == "LIST") {
            list = true;
        } else if (first.find('%') != first.npos) {
            std::vector<int> numbers;
            for (words.skip_blanks(); !words.done(); words.skip_blanks()) {
                const auto number = words.integer();
                if (!number || numbers.size() == 4) break;
                numbers.push_back(*number);
            }
            if (numbers.size() < 3 || !words.done()) numbers = {0, 0, 0}; // which is refused
            fields.data_files = numbered_names(first, numbers[0], numbers[1], numbers[2], name);
        } else {
            fields.data_files.emplace_back(value);
        }
    }
    if (list && fields.data_files.empty())
        throw Rejected(name + ": its list of data files is empty");
    fields.text += "\n";
    fields.size = bytes.size() - static_cast<std::size_t>(scan.end - scan.at);
    return fields;
}

} // namespace trivar
