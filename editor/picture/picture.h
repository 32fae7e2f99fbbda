// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/evaluate.h"
#include "editor/picture/shown_values.h"
#include "gpu/picture.h"

namespace trivar {

// What the renderer draws of an evaluated document, seen from a camera. Objects can be picked by
// their id. What colours show besides materials is kept in `values`. Placed objects are drawn as
// they were evaluated, by the processor, or deformed by the renderer from what they were before.
gpu::Picture picture_of(const Evaluation& evaluated, const Document& document, const Camera& camera,
                        ShownValues& values, gpu::DeformBy by = gpu::DeformBy::processor);

// Adds the vertices of an object and the points of its curves, in world space.
void add_points(std::vector<glm::dvec3>& points, const EvaluatedObject& object);
// The same, and of a lattice, which has none, its control points: what a window shows.
void add_seen_points(std::vector<glm::dvec3>& points, const EvaluatedObject& object);
// These of all objects but the ones that are left aside, ascending ids.
std::vector<glm::dvec3> points_of(const Evaluation& evaluated, const std::vector<Id>& hidden_here);

// The kept view "picture" if there is one, else a view of everything from the front, somewhat from
// the right and above. An empty scene gives the camera that a new document starts with.
Camera picture_camera(const Evaluation& evaluated, const Document& document, glm::ivec2 size_px);

} // namespace trivar
