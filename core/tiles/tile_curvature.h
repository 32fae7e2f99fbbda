// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/lazy.h"
#include "core/tiles/limit_base.h"

namespace trivar {

// A TileCurvature says where a base at rest bends least and most: exactly on a limit surface; on
// triangles by an estimate from how normals change over them, averaged over neighbours.
class TileCurvature {
public:
    // Estimates all points' curvature (after S. Rusinkiewicz, "Estimating curvatures and their
    // derivatives on triangle meshes", 2004). About 0.3 microseconds per triangle.
    explicit TileCurvature(const TileBase& base);
    // Keeps the limit surface; nothing is computed until it is asked.
    explicit TileCurvature(Ref<LimitBase> base);

    // Gives the direction in which the surface bends least, whichever way: unit, in the plane of
    // the base's normal; its sign has no meaning. Zero where it bends nearly alike in all
    // directions, as plane and ball do. `base` is the one that it was made from, or the triangles
    // of that. A microsecond.
    glm::dvec3 least(const TileBase& base, const SurfacePlace& at) const;

private:
    Ref<LimitBase> limit_;            // null: there are triangles alone
    std::vector<glm::dmat3> tensors_; // #points: d(normal) of a step, 1/metre
};

} // namespace trivar
