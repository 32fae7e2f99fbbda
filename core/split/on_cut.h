// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

#include <functional>
#include <span>

namespace trivar {

// OnCut says which vertices lie on a cut: those at most `within` above or below it. A cut goes
// through them, and a face all of whose corners lie on it belongs to one side.
struct OnCut {
    double within = 0;
    // the way in which heights grow at a point of the mesh, of any length
    std::function<glm::dvec3(const glm::dvec3& p)> up;
};

// The sides of a mesh's vertices and faces where some vertices lie on the cut.
struct SidesOnCut {
    // #V: 1 above, 0 below. A vertex on the cut has the side of its faces, or `both`.
    std::vector<char> above;
    std::vector<char> both;  // #V: on the cut, and faces on both sides use its point
    std::vector<char> sides; // #F: 1 above, 0 below, side_across: the cut goes through it
    // The faces that the cut goes through, and others that have such a vertex; ascending.
    std::vector<std::uint32_t> across, beside;
};

inline constexpr char side_below = 0, side_above = 1, side_across = 2;

// Finds the sides. A face that lies wholly on the cut belongs to the side where the solid is, by
// its normal; one of a sheet to the side of the rest of it. A body that lies wholly on the cut is
// above. O(#C).
SidesOnCut sides_on_cut(const Mesh& mesh, std::span<const double> heights, const OnCut& on);

} // namespace trivar
