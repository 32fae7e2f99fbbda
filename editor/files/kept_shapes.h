// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/objects/keep_shape.h"
#include "editor/session/session.h"

namespace trivar {

// Whether there is a folder for shapes: the scene's own, or where scenes without a name are kept.
bool keeps_shapes(const Session& session);
// A free file in the scene's folder for shapes, for something of that name. Throws Rejected.
std::string kept_file(Session& session, const std::string& name);
// Returns an object as shown as a model of its own, in the space into which the matrix transforms
// the world.
Model kept_model(const EvaluatedObject& object, const Document& then, const glm::dmat4& from_world);

// The command that deletes a lattice and keeps its contents in their present shape. It names one
// .glb per object, in the scene's folder for them, and writes those that are not there already,
// under free names. Throws Rejected where a file cannot be written.
Command kept_shapes(Session& session, Id lattice);

} // namespace trivar
