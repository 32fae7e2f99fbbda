// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/ref.h"
#include "core/mesh/mesh.h"
#include "core/unwrap/methods.h"

#include <span>

namespace trivar {

struct UnwrapOptions {
    UnwrapMethod method = UnwrapMethod::conformal;
    double seam_angle = 1.05;  // radians; charts end at edges over which faces turn by more
    double spread = 1.05;      // radians; how far the normals of a chart may lean from each other
    double stretch = 2.5;      // factor; charts whose lengths are off by more are divided
    double margin = 1.0 / 512; // free round each chart, as a share of the square
};

struct UnwrapInput {
    Ref<Mesh> mesh;
    double scale = 1; // how large it is beside the others: texels are to be as dense on all
};

struct UnwrapFacts {
    std::size_t charts = 0;
    std::size_t divided =
        0; // charts that were cut in two: they folded, met themselves or were stretched
    std::size_t left_out = 0; // faces that use a point twice; their texture coordinates are 0
    double filled = 0;        // share of the square
    // The greatest factors by which angles and lengths are off, over all triangles without the
    // worst thousandth of their area; 1: exact.
    double angle = 1, length = 1;
    bool operator==(const UnwrapFacts&) const = default;
};

struct Unwrapped {
    std::vector<std::vector<glm::vec2>> uvs;       // by mesh and corner, in [0, 1]^2
    std::vector<std::vector<std::uint32_t>> chart; // by mesh and face; ~0: left out
    UnwrapFacts facts;
};

// Makes texture coordinates for meshes that share one square: cut into disks (chart_tree.h), each
// laid flat (disk.h) as large as it is, and packed (pack.h). A chart that folds, whose rim meets
// itself or that is stretched too much is divided into the two from which it was joined, and so on:
// no triangle of area is turned over, and no two overlap.
//   meshes    with finite positions; at least one face in all
//   progress  called every 20 ms on the thread of the caller (watched.h); its throw cancels
// Cost: about 10 us per triangle. The same bits for any number of threads. Throws Rejected where
// there are no faces and for positions that are no numbers.
Unwrapped unwrapped(std::span<const UnwrapInput> meshes, const UnwrapOptions& options,
                    const Progress& progress = {});

// The mesh with other texture coordinates, one per corner (#C), as its first set. A vertex whose
// corners differ in it becomes as many vertices of one point. Tangents, which belong to the old
// coordinates, are removed.
Mesh with_uvs(const Mesh& mesh, std::span<const glm::vec2> uvs);

} // namespace trivar
