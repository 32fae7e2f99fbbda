// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/keep_shape.h"
#include "editor/session/session.h"

namespace trivar {

// The command that deletes a lattice and keeps its contents in their present shape. It writes one
// .glb per object into the scene's folder, under a free name, and names these files. The scene must
// have a name. Throws Rejected where a file cannot be written.
Command kept_shapes(const Session& session, Id lattice);

} // namespace trivar
