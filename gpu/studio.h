// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/look.h"

namespace trivar::gpu {

// A Studio is a look turned to a sun, ready for the shaders.
struct Studio {
    struct Box {
        glm::vec3 direction, right, up; // unit, world
        glm::vec2 half_size;
        glm::vec3 radiance;
        float softness;
    };
    std::array<Box, 3> boxes; // 0 is the key
    glm::vec3 zenith, horizon, floor;
    glm::vec3 key_irradiance;         // on a plane that faces the key
    std::array<glm::vec3, 9> ambient; // irradiance without the key, in spherical harmonics
};

// Integrates the light that shaders/studio.glsl describes; about 2 ms. Without a ground less light
// comes from below.
Studio studio_for(const Look& look, double sun_azimuth, double sun_elevation, bool ground);

} // namespace trivar::gpu
