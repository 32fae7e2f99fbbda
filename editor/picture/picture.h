// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluation/evaluate.h"
#include "editor/picture/shown_values.h"
#include "gpu/picture.h"

namespace trivar {

// The picture of an evaluated document for the renderer, seen from a camera. Objects can be picked
// by their id. Values that colours show in place of materials are kept in `values`. Placed objects
// are drawn as the processor deformed them, or are deformed by the renderer.
gpu::Picture picture_of(const Evaluation& evaluated, const Document& document, const Camera& camera,
                        ShownValues& values, gpu::DeformBy by = gpu::DeformBy::processor);

// The width of lines in pixels per pixel of a picture of the usual height.
float wider_lines(const Camera& camera);

// Adds the vertices of an object and the points of its curves, in world space; of tiles those that
// are furthest out.
void add_points(std::vector<glm::dvec3>& points, const EvaluatedObject& object);
// The same, and for a lattice, which has no vertices, its control points: what a window shows.
void add_seen_points(std::vector<glm::dvec3>& points, const EvaluatedObject& object);
// The points of all objects but those that are hidden here, ascending ids.
std::vector<glm::dvec3> points_of(const Evaluation& evaluated, const std::vector<Id>& hidden_here);

// The kept view "picture" if there is one, else a view of the whole scene from the front, somewhat
// from the right and above. An empty scene gives the camera with which a new document starts.
Camera picture_camera(const Evaluation& evaluated, const Document& document, glm::ivec2 size_px);

} // namespace trivar
