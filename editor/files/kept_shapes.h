// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/keep_shape.h"
#include "editor/session/session.h"

namespace trivar {

// The command that deletes a lattice and keeps its contents in their present shape. It names one
// .glb per object, in the scene's folder for them, and writes those that are not there already,
// under free names. Throws Rejected where a file cannot be written.
Command kept_shapes(Session& session, Id lattice);

} // namespace trivar
