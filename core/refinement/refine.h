// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/ffd/lattice.h"
#include "core/refinement/born_vertices.h"
#include "core/refinement/methods.h"
#include "core/refinement/next_volume.h"
#include "core/refinement/refine_part.h"

namespace trivar {

struct RefineOptions {
    double tolerance_world = 0;
    SplitPoint split = SplitPoint::equidistributed;
    // composed_net is subdivided where that may save a split
    BoundMethod method = BoundMethod::composed_net;
    RefinementRule rule = RefinementRule::edge_driven;
    std::size_t budget = 4'000'000; // greatest number of triangles of all parts together
};

struct RefinedPart {
    Ref<Mesh> mesh; // in triangles; the given mesh itself where nothing was split
    std::size_t triangles_before = 0, triangles = 0;
    // triangles without area in parameter space: bounded like the others
    std::size_t degenerate = 0;
    // The proven greatest error of any triangle in world units, rounding included. Infinite where
    // the method gives no bound, and after chua_neumann_midpoint.
    double bound = 0;
    std::vector<std::uint32_t> not_certified; // faces of `mesh` whose bound exceeds the tolerance
    // how each new vertex came from earlier ones, in the order of the vertices
    std::vector<BornVertex> born;
    std::vector<float> bound_at; // for each vertex of `mesh`, the greatest bound of its triangles
};

struct RefinementResult {
    std::vector<RefinedPart> parts;
    double bound = 0; // the greatest of the parts
    // the share of the bound that comes from single precision, in vertices and their deformation
    double rounding = 0;
    int depth = 0; // greatest number of splits that one edge went through
    bool out_of_budget = false;
    std::size_t triangles() const;
    std::size_t not_certified() const;
};

// Splits edges until the deformed flat triangles are nowhere further from the deformed surface than
// the tolerance.
//   parts     meshes with their places in the volume
//   lattice   the first volume
//   next      further volumes, one after the other; bounds and tolerance are of the output of the
//             last one (core/refinement/composed_bounds.h)
//   progress  told the share of the edges that need no split; it may fall back when edges are split
// There are no T-junctions, also not between parts whose boundaries meet in parameter space bit by
// bit. New vertices take positions, normals, tangents, colours, texture coordinates, influences and
// morph targets from the flat triangle; seams stay seams. Cost: each new triangle is bounded once,
// 2 to 5 us for a tri-cubic lattice. The same bits for any number of threads. Throws Rejected for a
// tolerance that is not above 0 or is finer than rounding.
RefinementResult refine(const std::vector<RefinePart>& parts, const Lattice& lattice,
                        const RefineOptions& options, const Progress& progress = {},
                        const std::vector<NextVolume>& next = {});
// Bounds the triangles as they are; nothing is split.
RefinementResult bounded(const std::vector<RefinePart>& parts, const Lattice& lattice,
                         const RefineOptions& options, const Progress& progress = {},
                         const std::vector<NextVolume>& next = {});

} // namespace trivar
