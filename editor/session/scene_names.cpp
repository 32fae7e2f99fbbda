// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/session/scene_names.h"

#include "editor/session/samples.h"

#include <filesystem>

namespace trivar {

std::string title_of(const SceneFile& scene)
{
    if (scene.look_only()) return stem_of(scene) + " (read-only)";
    if (!scene.path().empty()) return std::filesystem::path(scene.path()).filename().string();
    if (scene.original().empty()) return "Untitled";
    const std::string sample = sample_title(scene.original());
    return sample.empty() ? stem_of(scene) + " (copy)" : sample;
}

std::string stem_of(const SceneFile& scene)
{
    const std::string& path = scene.path().empty() ? scene.original() : scene.path();
    return path.empty() ? "untitled" : std::filesystem::path(path).stem().string();
}

} // namespace trivar
