// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/volumes/lattice.h"
#include "editor/session/session.h"

namespace trivar {

inline constexpr const char* lattice_action = "Lattice round selection";

// The group in which all objects are; 0: none. At least one.
Id common_parent(const Document& document, const std::vector<Id>& ids);

// A box of control points round objects, in the group that holds them.
AddLattice lattice_round(const Session& session, const std::vector<Id>& ids);

// Puts a box round the selection, which is then selected itself; false where that is refused.
bool put_lattice_round_selection(Session& session);

} // namespace trivar
