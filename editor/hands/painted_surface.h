// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tiles/tile_base.h"
#include "editor/session/session.h"

#include <optional>

namespace trivar {

// A SurfaceHit is a point of an object's surface, where it is seen and where it is at rest.
struct SurfaceHit {
    glm::dvec3 p_world{0}, normal_world{0, 0, 1}; // unit
    SurfacePoint at_rest;
    double scale = 1; // metres in the world per metre on the model, about there
};

// A PaintedSurface answers where rays meet one object as it is shown now. The tree for the rays is
// built when the object's meshes have changed.
class PaintedSurface {
public:
    // Nothing: the object shows no surface, or the ray misses it.
    std::optional<SurfaceHit> hit(const Session& session, Id object, const Ray& ray);
    // Moves points of the object at rest onto its surface as seen; nothing where it has no surface
    // at most `reach` away along their normals. About 2 microseconds each.
    std::vector<std::optional<SurfaceHit>>
    seen(const Session& session, Id object, std::span<const SurfacePoint> at_rest, double reach);

private:
    using RestMeshes = std::vector<std::pair<Ref<Mesh>, glm::dmat4>>; // of the parts, to the model
    RestMeshes rest_;
    Ref<TileBase> at_rest_;
    Ref<EvaluatedObject> shown_;
    Ref<RayScene> scene_;
};

} // namespace trivar
