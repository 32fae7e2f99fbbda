// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>
#include <limits>

namespace trivar::gpu {

// A Copy is one of many drawings of an instance's mesh.
struct Copy {
    glm::dmat4 to_instance{1}; // applied before Instance::to_world
    int id = 0;                // what pick() returns; 0: the instance's id
    // The number that colours show where the picture shows values and the instance has no values by
    // vertex; NaN: none. Colours show the copies' numbers only where every copy has one.
    float value = std::numeric_limits<float>::quiet_NaN();
};

} // namespace trivar::gpu
