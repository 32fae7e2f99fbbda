// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"
#include "core/simplex/simplex_domain.h"

namespace trivar {

// A SimplexCut is a mesh that was cut in pieces along the planes of a domain's cut faces, each
// piece closed, so that it can part there.
struct SimplexCut {
    Mesh mesh;                         // all pieces
    std::vector<glm::dvec3> in_domain; // #V: where functions are taken: a point on a cut lies a
                                       // little to the side of its piece
};

inline constexpr std::size_t most_cut_planes = 64;

// The number of cut faces in further planes than those along which meshes are cut: there they hold
// together. O(number of cut faces times number of planes).
std::size_t cuts_passed_over(const SimplexDomain<3>& domain);

// Cuts along at most 64 planes; faces in further planes are passed over. Where a plane's faces do
// not cut, both pieces stay together, for there the functions do not jump. `to_domain` takes points
// of the mesh to the domain. O(number of planes times number of vertices).
SimplexCut cut_along(const Mesh& mesh, const glm::dmat4& to_domain, const SimplexDomain<3>& domain);

} // namespace trivar
