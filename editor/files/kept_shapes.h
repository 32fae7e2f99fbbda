// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/keep_shape.h"
#include "editor/session/session.h"

namespace trivar {

// Deletes a lattice and keeps what is seen in it in its present shape: writes one .glb for each
// object into the scene's folder, with a name that is free, and names them. The scene must have a
// name. Throws Rejected where a file cannot be written.
Command kept_shapes(const Session& session, Id lattice);

} // namespace trivar
