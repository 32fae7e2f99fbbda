// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/stages/evaluated.h"

#include <optional>

namespace trivar {

// What a stroke of an object belongs to as it lies now, so that it keeps its place: what its
// samples' rays and those to the nodes of its strip meet carries it, but for what is seen
// beyond an edge that the strip spans; the rest of what it may fall on counts as AttachedHost says.
// What lies on the ground alone belongs to none of its hosts. The sketch is the object's, or one in
// the same space (Carriage::sketch). Nothing: it lies nowhere, or nothing is met. O(number of
// samples and nodes).
std::optional<Attachment> attachment_of(const EvaluatedObject& laid, const Sketch& sketch,
                                        bool skip_back_faces);

// From the space of the stroke to the world as it lies now, and the stroke there: an edit of an
// attached stroke is made in that space.
glm::dmat4 stroke_to_world(const Stage& laid);
Sketch stroke_now(const Stage& laid, const PlacementStep& step);
// The hosts of an attached stroke as they stand in that space now: for another stroke there, until
// it is known what that meets. Nothing: it is not attached.
std::optional<Attachment> hosts_now(const Stage& laid, const PlacementStep& step);

} // namespace trivar
