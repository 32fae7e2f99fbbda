// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace trivar {

// A picture with 16 bits a channel, rows from the top, RGBA, sRGB-encoded.
struct DeepImage {
    glm::ivec2 size_px{0};
    std::vector<std::uint16_t> rgba; // 4 x width x height
};

} // namespace trivar
