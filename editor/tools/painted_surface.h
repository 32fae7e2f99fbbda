// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tiles/tile_stroke.h"
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

private:
    Ref<EvaluatedObject> shown_;
    Ref<RayScene> scene_;
};

} // namespace trivar
