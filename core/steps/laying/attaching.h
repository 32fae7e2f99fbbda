// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/stages/evaluated.h"

#include <optional>

namespace trivar {

// Finds the hosts of a stroke as it lies now: the objects hit by the rays through its samples and
// strip nodes, except beyond an edge that the strip spans. AttachedHost says how the other objects
// under it count. A stroke on the ground alone has no host. `sketch`: the object's, or one in the
// same space (StrokeMotion::sketch). Empty: it lies nowhere, or nothing is hit. O(number of samples
// and nodes).
std::optional<Attachment> attachment_of(const EvaluatedObject& laid, const Sketch& sketch,
                                        bool skip_back_faces);

// Return the transform from the stroke's space to the world as it lies now, and the stroke in that
// space: an edit of an attached stroke is made there.
glm::dmat4 stroke_to_world(const Stage& laid);
Sketch stroke_now(const Stage& laid, const PlacementStep& step);
// Returns the hosts of an attached stroke as they stand in that space now: for another stroke
// there, until its own hits are known. Nothing: it is not attached.
std::optional<Attachment> hosts_now(const Stage& laid, const PlacementStep& step);

} // namespace trivar
