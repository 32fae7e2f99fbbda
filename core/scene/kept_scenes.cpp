// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene/kept_scenes.h"

#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/scene/life_sign.h"

#include <algorithm>
#include <ctime>
#include <fmt/format.h>
#include <functional>
#include <unistd.h>

namespace trivar {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view shapes_suffix = " kept shapes";

bool is_shapes_folder(const fs::path& name)
{
    return name.string().starts_with(kept_name) && name.string().ends_with(shapes_suffix);
}

// Says whether a scene contains the text; true if it cannot be read.
bool names(const fs::path& scene, const std::string& text)
{
    try {
        return read_text_file(scene.string()).find(text) != std::string::npos;
    } catch (const Rejected&) {
        return true;
    }
}

} // namespace

std::string absolute_folder(const std::string& path)
{
    if (path.empty()) return std::filesystem::current_path().string();
    return std::filesystem::absolute(path).lexically_normal().parent_path().string();
}

std::vector<std::string> paths_of(const TimedPaths& scenes)
{
    std::vector<std::string> paths;
    for (const auto& [time, path] : scenes) paths.push_back(path);
    return paths;
}

TimedPaths scenes_in(const std::string& folder, std::string_view name)
{
    std::error_code ignored;
    TimedPaths found;
    for (const auto& each : std::filesystem::directory_iterator(folder, ignored))
        if (each.path().filename().string().starts_with(name) &&
            each.path().extension() == kept_extension)
            found.emplace_back(each.last_write_time(ignored), each.path().string());
    std::ranges::sort(found, std::greater());
    return found;
}

void forget_old_scenes(const std::string& folder, std::chrono::hours aside_for)
{
    std::error_code ignored;
    const auto now = std::filesystem::file_time_type::clock::now();
    for (const auto& [time, path] : scenes_in(folder, aside_name))
        if (now - time > aside_for) std::filesystem::remove(path, ignored);
    for (const auto& each : fs::directory_iterator(folder, ignored)) // of killed programs
        if (each.path().filename().string().starts_with(life_sign_name) &&
            now - each.last_write_time(ignored) > aside_for)
            fs::remove(each.path(), ignored);
    remove_unused_shapes(folder);
}

std::string kept_shapes_of(const std::string& scene_path)
{
    return fs::path(scene_path).replace_extension().string() + std::string(shapes_suffix);
}

bool is_kept_shape(const fs::path& file, const fs::path& folder)
{
    const fs::path within = file.lexically_normal().lexically_relative(folder.lexically_normal());
    return std::distance(within.begin(), within.end()) == 2 && is_shapes_folder(*within.begin());
}

void remove_unused_shapes(const std::string& folder)
{
    std::error_code ignored;
    std::vector<fs::path> scenes, shapes;
    for (const auto& each : fs::directory_iterator(folder, ignored))
        if (each.path().extension() == kept_extension)
            scenes.push_back(each.path());
        else if (is_shapes_folder(each.path().filename()) && each.is_directory(ignored))
            shapes.push_back(each.path());
    for (const fs::path& each : shapes) {
        const std::string name = each.filename().string();
        if (std::ranges::none_of(scenes, [&](const fs::path& scene) {
                return kept_shapes_of(scene.filename().string()) == name || names(scene, name);
            }))
            fs::remove_all(each, ignored);
    }
}

std::string free_kept_path(const std::string& folder)
{
    std::error_code ignored;
    for (int i = 1;; ++i) {
        std::string path =
            fmt::format("{}/{}{}-{}{}", folder, kept_name, ::getpid(), i, kept_extension);
        if (!std::filesystem::exists(path, ignored)) return path;
    }
}

std::string brought_back(const std::string& path)
{
    const std::filesystem::path file(path);
    if (!file.filename().string().starts_with(aside_name)) return path;
    std::error_code trouble;
    std::string kept = free_kept_path(file.parent_path().string());
    std::filesystem::rename(file, kept, trouble);
    return trouble ? path : kept;
}

void put_aside(const std::string& path)
{
    const std::time_t now = std::time(nullptr);
    std::tm at{};
    ::localtime_r(&now, &at);
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    const std::string stem =
        fmt::format("{}{}-{:02}-{:02} {:02}.{:02}", aside_name, at.tm_year + 1900, at.tm_mon + 1,
                    at.tm_mday, at.tm_hour, at.tm_min);
    std::error_code ignored;
    auto free = folder / (stem + kept_extension);
    for (int i = 2; std::filesystem::exists(free, ignored); ++i)
        free = folder / fmt::format("{} ({}){}", stem, i, kept_extension);
    std::filesystem::rename(path, free, ignored);
    std::filesystem::last_write_time(free, std::filesystem::file_time_type::clock::now(), ignored);
}

} // namespace trivar
