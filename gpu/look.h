// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/picture.h"

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <string_view>

namespace trivar::gpu {

// A Softbox is a rectangular lamp far away; its azimuth is relative to the sun.
struct Softbox {
    float azimuth, elevation; // radians; the key's are the document's sun
    glm::vec2 half_size;      // at distance 1
    // linear; a surface of albedo 0.76 under 1 / pi lies where the tone curve bends
    glm::vec3 radiance;
    float softness; // of its edge, at distance 1
};

// A Look is a named way to light and stage a scene.
struct Look {
    std::array<Softbox, 3> boxes;     // key, fill, rim
    glm::vec3 zenith, horizon, floor; // radiance of the dome; floor: as lit over a ground
    Backdrop backdrop;
    std::optional<glm::vec3> clay; // where set, every material is matt and has this colour
};

// "studio", "clay", "dark"; "paper" and "black" are even grounds for drawings; any other name gives
// the studio.
Look look_named(std::string_view name);

// Whether text over a picture of that look must be light.
bool is_dark(std::string_view name);

} // namespace trivar::gpu
