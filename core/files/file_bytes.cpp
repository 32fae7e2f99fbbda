// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/file_bytes.h"

#include "core/base/digest.h"
#include "core/base/rejected.h"
#include "core/files/folder_files.h"
#include "core/files/growing_file.h"
#include "core/files/read_model.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>

namespace trivar {
namespace {

namespace fs = std::filesystem;

std::ifstream open_file(const std::string& path)
{
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (!fs::exists(status)) throw Rejected(path + ": there is no such file");
    if (!fs::is_regular_file(status)) throw Rejected(path + ": this is not a regular file");
    std::ifstream file(path, std::ios::binary);
    if (!file) throw Rejected(fmt::format("{}: cannot be opened ({})", path, std::strerror(errno)));
    return file;
}

} // namespace

std::string read_bytes(const std::string& path, std::uintmax_t max_bytes)
{
    std::ifstream file = open_file(path);
    std::error_code error;
    const std::uintmax_t size = fs::file_size(path, error);
    if (error) throw Rejected(fmt::format("{}: cannot be read ({})", path, error.message()));
    if (size > max_bytes)
        throw Rejected(
            fmt::format("{}: has {} bytes, more than the {} allowed", path, size, max_bytes));
    std::string bytes(size, '\0');
    file.read(bytes.data(), static_cast<std::streamsize>(size));
    if (static_cast<std::uintmax_t>(file.gcount()) != size)
        throw Rejected(path + ": cannot be read to its end");
    return bytes;
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
    std::ifstream file = open_file(path);
    Digest digest;
    std::array<char, 1 << 16> block;
    while (file.read(block.data(), block.size()), file.gcount() > 0)
        digest.add_bytes(
            std::as_bytes(std::span(block.data(), static_cast<std::size_t>(file.gcount()))));
    if (file.bad()) throw Rejected(path + ": cannot be read to its end");
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
