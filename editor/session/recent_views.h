// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/camera.h"

#include <optional>
#include <string>
#include <vector>

namespace trivar {

// Find and keep the last views of scenes, the newest first, each a line of a person's preferences:
// numbers of the camera, then the path of the scene's file.
std::optional<Camera> view_of(const std::vector<std::string>& lines, const std::string& path);
void remember_view_of(std::vector<std::string>& lines, const std::string& path,
                      const Camera& camera, std::size_t most);

} // namespace trivar
