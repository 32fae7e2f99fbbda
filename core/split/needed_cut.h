// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"
#include "core/split/cut_surface.h"

#include <functional>
#include <span>

namespace trivar {

// A CutNeed is the rectangle of (v, w) over which a cut must be made: its halves part only there.
struct CutNeed {
    SplitRectangle over;
    std::function<glm::dvec2(std::uint32_t vertex)> at; // (v, w) of a vertex
};

// Returns which of the triangles that a cut goes through must be cut: not those of loops that lie
// wholly beside the rectangle, in a box that is apart from it and from those of all loops that must
// be cut. So no cap reaches over parts that stay whole.
//   across  vertices of these triangles
// Empty: all must be. O(n) for n triangles, and O(k^2) for k loops.
std::vector<char> needed(std::span<const glm::uvec3> across, const Mesh& mesh, const CutNeed& need);

} // namespace trivar
