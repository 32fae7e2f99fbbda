// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/picture.h"

#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <string_view>

namespace trivar::gpu {

// A rectangular lamp far away, in the studio's own azimuth: 0 is the sun's.
struct Softbox {
    float azimuth, elevation; // radians; the key's are the document's sun
    glm::vec2 half_size;      // at distance 1
    glm::vec3 radiance;       // linear; albedo 0.76 under 1 / pi is where the tone curve bends
    float softness;           // of its edge, at distance 1
};

// A named way to light and stage a scene.
struct Look {
    std::array<Softbox, 3> boxes;     // key, fill, rim
    glm::vec3 zenith, horizon, floor; // radiance of the dome; floor: as lit over a ground
    Backdrop backdrop;
    std::optional<glm::vec3> clay; // every material is matt and has this colour
};

// "studio", "clay", "dark"; any other name gives the studio.
Look look_named(std::string_view name);

} // namespace trivar::gpu
