// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"
#include "core/ffd/deform.h"
#include "core/kernel/volume_kernel.h"

namespace trivar {

// The axes of a lattice as core/kernel reads them.
struct PackedAxes {
    std::array<int, 3> order{};
    std::vector<glm::vec4> cells; // cell_rows each, axis after axis
    std::array<int, 3> cell_begin{}, cell_count{};
    // Whether order raising is possible: no knot within the domain may repeat `order` times.
    bool raisable = true;
};
// O(#knots). Throws Rejected for orders above 4: core/kernel goes no further.
PackedAxes packed_axes(const std::array<Knots, 3>& axes);

// Displacements by unwrapped index, w fastest: x, y, z and a zero.
std::vector<glm::vec4> packed_points(const Trivariate<glm::dvec3>& displacement);

// Computes how an object lies in a lattice, for core/kernel. Moving or scaling the parameters of an
// animated object changes `embedding` and this, and nothing else.
//   object        box of the object, about; object space
//   origin_world  results are relative to it, so they keep their digits anywhere in the world
// O(#control points).
VolumeFrame volume_frame(const Lattice& lattice, const PackedAxes& axes, const Embedding& embedding,
                         const Box& object, const glm::dvec3& origin_world = glm::dvec3(0));

} // namespace trivar
