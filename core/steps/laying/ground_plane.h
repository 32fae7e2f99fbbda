// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/rays/ray_scene.h"
#include "core/stages/stroke_motion.h"

#include <optional>

namespace trivar {

// Returns the distance along a ray from above to the ground, the plane Z 0 of the world; nothing:
// the ray does not come down to it.
std::optional<double> distance_to_ground(const Ray& ray);

// A GroundPlane is the ground as something that strokes fall on. It belongs to no object: its id is
// 0.
class GroundPlane {
public:
    GroundPlane();
    // A level square, wide enough for whatever the stroke lays there, where a matrix takes the
    // space of the stroke to the world. Nothing where the stroke does not come down to the ground.
    // The same input gives the same mesh.
    std::optional<Support> under(const Sketch& sketch, const glm::dmat4& to_world) const;

private:
    Ref<Mesh> square_; // of side 2 round the origin
};

} // namespace trivar
