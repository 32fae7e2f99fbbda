// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/file_bytes.h"

#include "core/base/digest.h"
#include "core/base/ordinary_file.h"
#include "core/files/folder_files.h"
#include "core/files/growing_file.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>

namespace trivar {
namespace {

namespace fs = std::filesystem;

} // namespace

std::string read_bytes(const std::string& path, std::uintmax_t max_bytes)
{
    return read_file(path, max_bytes);
}

void write_bytes(const std::string& path, std::string_view bytes)
{
    GrowingFile file(path);
    file.append(bytes);
    file.finish();
}

std::optional<std::string> file_inside(const std::string& folder, const std::string& name)
{
    if (const auto found = FolderFiles(folder).find(name)) return found->path;
    return {};
}

std::string extension_of(const std::string& path)
{
    std::string extension = fs::path(path).extension().string();
    for (char& c : extension)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return extension;
}

std::string file_hash(const std::string& path)
{
    OrdinaryFile file(path);
    Digest digest;
    std::array<char, 1 << 16> block;
    while (const std::size_t count = file.read(block))
        digest.add_bytes(std::as_bytes(std::span(block.data(), count)));
    return digest.hex();
}

bool nested_too_deep(std::string_view json)
{
    constexpr int deepest = 48;
    int depth = 0;
    bool quoted = false;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const char c = json[i];
        if (quoted) {
            if (c == '\\')
                ++i;
            else if (c == '"')
                quoted = false;
        } else if (c == '"') {
            quoted = true;
        } else if (c == '{' || c == '[') {
            if (++depth > deepest) return true;
        } else if (c == '}' || c == ']') {
            --depth;
        }
    }
    return false;
}

} // namespace trivar
