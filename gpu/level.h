// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/picture.h"

#include <array>
#include <optional>
#include <string_view>

namespace trivar::gpu {

// A Level says how much is spent on a picture. Draft: one sample, no ambient occlusion, shadows of
// one softness. Standard: 4 samples. High: 16, and a finer shadow map.
enum class Level { draft, standard, high };
inline constexpr std::array<std::string_view, 3> level_names{"draft", "standard", "high"};
std::optional<Level> level_named(std::string_view name);

void set_level(Picture& picture, Level level);

} // namespace trivar::gpu
