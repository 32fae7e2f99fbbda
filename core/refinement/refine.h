// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/ffd/lattice.h"
#include "core/refinement/born_vertices.h"
#include "core/refinement/methods.h"
#include "core/refinement/refine_part.h"

namespace trivar {

struct RefineOptions {
    double tolerance_world = 0;
    SplitPoint split = SplitPoint::equidistributed;
    BoundMethod method = BoundMethod::composed_net; // subdivided where that may save a split
    RefinementRule rule = RefinementRule::edge_driven;
    std::size_t budget = 4'000'000; // triangles of all parts
};

struct RefinedPart {
    Ref<Mesh> mesh; // triangles; the mesh that was given where none had to be split
    std::size_t triangles_before = 0, triangles = 0;
    std::size_t degenerate = 0; // of them without area in parameter space: bounded like the others
    // What every triangle's error is proven not to exceed, rounding included; world units.
    // Infinite where a bound says nothing, and after chua_neumann_midpoint.
    double bound = 0;
    std::vector<std::uint32_t> not_certified; // faces of `mesh` whose bound exceeds the tolerance
    std::vector<BornVertex> born; // how its further vertices came from earlier ones, in their order
    std::vector<float> bound_at;  // by vertex of `mesh`: the greatest bound of its triangles
};

struct RefinementResult {
    std::vector<RefinedPart> parts;
    double bound = 0;    // the greatest of the parts
    double rounding = 0; // its share that is single precision's: of vertices and their deformation
    int depth = 0;       // how often an edge was split, over and over
    bool out_of_budget = false;
    std::size_t triangles() const;
    std::size_t not_certified() const;
};

// The meshes with edges split until the deformed flat triangles are nowhere further from the
// deformed surface than the tolerance; no T-junctions, not even between parts whose boundaries meet
// in parameter space bit by bit. Positions, normals, tangents, colours, texture coordinates,
// influences and morph targets of new vertices are those of the flat triangle; seams stay seams.
// Each triangle that comes into being is bounded once, 2 to 5 us tri-cubic; the same bits for any
// number of threads. Throws Rejected for a tolerance that is not above 0, or finer than rounding;
// progress is the share of the edges that need no split, over and over.
RefinementResult refine(const std::vector<RefinePart>& parts, const Lattice& lattice,
                        const RefineOptions& options, const Progress& progress = {});
// What is proven of the triangles as they are: nothing is split.
RefinementResult bounded(const std::vector<RefinePart>& parts, const Lattice& lattice,
                         const RefineOptions& options, const Progress& progress = {});

} // namespace trivar
