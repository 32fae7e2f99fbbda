// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace trivar::testing {

// The names of the scenes of assets/scenes, or of another folder of assets, in their order.
std::vector<std::string> every_scene(const std::string& folder = "scenes");

// The frame in which the gallery shows a scene; nothing: its first.
std::optional<int> shown_frame(const std::string& scene);

} // namespace trivar::testing
