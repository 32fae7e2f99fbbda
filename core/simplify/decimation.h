// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/simplify/fans.h"

namespace trivar {

// Where the nodes stand, once at rest and once in each pose; about the middle of them all.
using NodePlaces = std::vector<std::vector<glm::dvec3>>; // each #N

struct DecimationTarget {
    std::size_t triangles = 0;     // to stop at, of those that are not left out
    std::vector<double> tolerance; // #N, or empty: none. Root mean square distance, see below
};

struct Decimation {
    std::vector<glm::uvec3> triangles, nodes; // #T as of Fans; nodes.x is `none` for what is gone
    std::vector<bool> changed;                // #T: a corner went elsewhere
    std::vector<Fans::Rail> creases;          // those rails with a sharpness that are left
    std::size_t count = 0;                    // of triangles that are neither gone nor left out
};

inline bool is_gone(const Fans& fans, const Decimation& left, std::size_t triangle)
{
    return fans.nodes[triangle].x != Fans::none && left.nodes[triangle].x == Fans::none;
}

// Half-edges of OpenMesh are collapsed one after another, a node onto a neighbour, as its decimater
// allows it, till the target is met or nothing can be collapsed any more. A collapse costs the sum
// of squared distances from the planes of all triangles that the node stands for, weighted by their
// areas, and from planes along rails that stand on the surface [1]; summed over the poses [2]. The
// least comes first. The tolerance is for the mean in each pose; a node that others were collapsed
// onto has the least tolerance of them all. No triangle turns over, at rest, in a pose or in
// texture coordinates. Rails keep their ends and never meet; the surface stays of one topology. One
// thread; the same bits every time. O(#T log #T).
//   [1] Garland, Heckbert, Surface simplification using quadric error metrics, 1997
//   [2] Mohr, Gleicher, Deformation sensitive decimation, 2003
Decimation decimated(const Mesh& mesh, const Fans& fans, const NodePlaces& places,
                     const DecimationTarget& target, const Progress& progress = {});

} // namespace trivar
