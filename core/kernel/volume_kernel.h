// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <glm/glm.hpp>
#include <span>

namespace trivar {

// A VolumeFrame is the input of the formulas on a volume and on an object's place in it; std140,
// field by field as in gpu/shaders/volume_inputs.glsl. p is in object space.
struct VolumeFrame {
    glm::mat4 x_by_p{1};    // maps p - x_middle to -1/2..1/2 over the domain of every axis
    glm::mat4 rest_by_p{1}; // maps p - rest_middle to the place of p before the displacement
    glm::vec4 x_middle{0}, rest_middle{0};   // xyz
    glm::ivec4 cell_begin{0}, cell_count{0}; // of the axes, in the table of cells
    glm::ivec4 closure{0};                   // 0 open, 1 periodic, 2 twisted
    glm::ivec4 stride{0};                    // of u and v, in control points
    float jacobian_scale = 1;                // so that its squares stay in range
    float difference_step = 0;               // object space; see raised.glsl
    glm::vec2 unused{0};
};

inline constexpr int cell_rows = 10; // see axis.glsl

namespace kernel {
using namespace glm;

// A VolumeKernel is the formulas of core/kernel as C++. The shaders include the same text.
template <int ou, int ov, int ow> struct VolumeKernel {
    const VolumeFrame& volume;
    std::span<const vec4> points, cells;

    static constexpr int order_u = ou, order_v = ov, order_w = ow;
    vec3 lattice_point(int at) const { return vec3(points[static_cast<std::size_t>(at)]); }
    vec4 cell_row(int cell, int row) const
    {
        return cells[static_cast<std::size_t>(cell * cell_rows + row)];
    }
    vec3 lattice_between(int first, vec3 at) { return lerped_between(first, at); }

#include "core/kernel/axis.glsl"
#include "core/kernel/volume.glsl"

#include "core/kernel/normal.glsl"

#include "core/kernel/deform.glsl"
#include "core/kernel/raised.glsl"
};

} // namespace kernel
} // namespace trivar
