// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/key_numbers.h"
#include "core/silhouette/border_lines.h"
#include "core/silhouette/silhouette_finder.h"

namespace trivar {

// SlabCurves finds the silhouettes and the border of a level slab by slab, of data that are larger
// than memory. Vertices have the numbers that they have in the mesh of the whole, so that curves go
// on from slab to slab: they are those of the whole. It keeps about 100 bytes for each edge that a
// curve crosses.
class SlabCurves {
public:
    // Throws Rejected if the view has no direction.
    SlabCurves(const ViewPoint& view, const SilhouetteOptions& options = {});

    // Adds the slab of the slices up to `end`, from where the last one ended. Its mesh is that of
    // the samples from there up to end + 8, or to the last slice; both ends of a slab but the last
    // are multiples of 8. The field holds some more slices. Throws Rejected for more than 2^32
    // vertices.
    void add(const ScalarField<float>& field, const LevelMesh& level, int end);

    // Returns the curves found; call it once. The spacing is that of points along a line.
    Silhouettes curves();
    Silhouettes border(float spacing = 0.4f) { return border_.lines(spacing); }

private:
    void add_crossings(const ScalarField<float>& field, const LevelMesh& level,
                       std::span<const CrossedTriangle> triangles);

    ViewPoint view_;
    SilhouetteOptions options_;
    SilhouetteFinder finder_;
    std::uint32_t first_vertex_ = 0;                      // of the slab that comes next
    std::vector<std::vector<CrossedTriangle>> triangles_; // by slab
    // Crossed edges: their places on the mesh, and the finished points.
    std::vector<glm::vec3> places_;
    std::vector<SilhouettePoint> points_;
    KeyNumbers number_; // of crossed edges
    BorderEdges border_;
};

} // namespace trivar
