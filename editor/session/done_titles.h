// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/session/session.h"

namespace trivar {

// The title of a step as it was done: where the guard let only a part of a warp or of a move
// through, with that part's number. What it let through is known of steps that are in force and
// evaluated; of others it is the title of what was asked.
StepTitle done_title(const Session& session, const Command& command, const Document& before,
                     const Document& after);

} // namespace trivar
