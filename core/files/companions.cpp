// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/companions.h"

#include "core/base/text.h"
#include "core/files/file_bytes.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>

namespace trivar {
namespace {

using nlohmann::json;

constexpr std::uintmax_t largest_file = std::uintmax_t{4} << 30;

// Calls use(keyword, rest) for each line.
template <class Use> void each_line(std::string_view text, Use&& use)
{
    constexpr std::string_view blank = " \t";
    for (const std::string_view line : trimmed_lines(text)) {
        const std::size_t word = std::min(line.find_first_of(blank), line.size());
        std::string_view rest = line.substr(word);
        rest.remove_prefix(std::min(rest.find_first_not_of(blank), rest.size()));
        use(line.substr(0, word), rest);
    }
}

// Options stand before a texture's name, and names may hold spaces: the longest end of the words
// that is a file.
void add_last_name(std::set<std::string>& found, const std::string& folder, std::string_view words)
{
    while (!words.empty()) {
        const std::string name(words);
        if (file_inside(folder, name)) {
            found.insert(name);
            return;
        }
        const std::size_t end = std::min(words.find_first_of(" \t"), words.size());
        words.remove_prefix(std::min(words.find_first_not_of(" \t", end), words.size()));
    }
}

std::string decoded(const std::string& uri)
{
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const auto hex = [&](std::size_t at) {
            return at < uri.size() && std::isxdigit(static_cast<unsigned char>(uri[at])) != 0;
        };
        if (uri[i] == '%' && hex(i + 1) && hex(i + 2)) {
            text += static_cast<char>(std::stoi(uri.substr(i + 1, 2), nullptr, 16));
            i += 2;
        } else {
            text += uri[i];
        }
    }
    return text;
}

std::set<std::string> of_gltf(std::string_view text, const std::string& folder)
{
    std::set<std::string> found;
    const json root = json::parse(text, nullptr, false);
    for (const char* list : {"buffers", "images"}) {
        if (!root.is_object() || !root.contains(list) || !root[list].is_array()) continue;
        for (const json& each : root[list]) {
            if (!each.is_object() || !each.contains("uri") || !each["uri"].is_string()) continue;
            const auto uri = each["uri"].get<std::string>();
            for (const std::string& name : {uri, decoded(uri)})
                if (file_inside(folder, name)) {
                    found.insert(name);
                    break;
                }
        }
    }
    return found;
}

std::set<std::string> of_obj(std::string_view text, const std::string& folder)
{
    std::set<std::string> libraries, found;
    each_line(text, [&](std::string_view keyword, std::string_view rest) {
        if (keyword != "mtllib") return;
        if (file_inside(folder, std::string(rest))) {
            libraries.emplace(rest);
            return;
        }
        while (!rest.empty()) { // several, between blanks
            const std::size_t end = std::min(rest.find_first_of(" \t"), rest.size());
            if (file_inside(folder, std::string(rest.substr(0, end))))
                libraries.emplace(rest.substr(0, end));
            rest.remove_prefix(std::min(rest.find_first_not_of(" \t", end), rest.size()));
        }
    });
    for (const std::string& library : libraries)
        each_line(read_bytes((std::filesystem::path(folder) / library).string(), largest_file),
                  [&](std::string_view keyword, std::string_view rest) {
                      const bool map = keyword.starts_with("map_") || keyword == "norm" ||
                                       keyword == "bump" || keyword == "disp";
                      if (map) add_last_name(found, folder, rest);
                  });
    found.insert(libraries.begin(), libraries.end());
    return found;
}

} // namespace

std::vector<std::string> companions_of(const std::string& path)
{
    const std::string extension = extension_of(path);
    if (extension != ".gltf" && extension != ".obj") return {};
    const std::string folder =
        std::filesystem::absolute(path).lexically_normal().parent_path().string();
    const std::string text = read_bytes(path, largest_file);
    const std::set<std::string> found =
        extension == ".gltf" ? of_gltf(text, folder) : of_obj(text, folder);
    return {found.begin(), found.end()};
}

} // namespace trivar
