// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/session/session.h"

namespace trivar {

inline constexpr const char* lattice_action = "Lattice round selection";

inline constexpr const char* tetrahedra_action = "Tetrahedra round selection";

// Puts a box of tetrahedra round the selection, which is then selected itself; false where that is
// refused.
bool put_tetrahedra_round_selection(Session& session);

inline constexpr const char* fitted_tetrahedra_action = "Tetrahedra fitted to selection";

// The same with about 2,000 tetrahedra that follow what they hold. O(number of vertices).
bool fit_tetrahedra_round_selection(Session& session);

// Puts a box round the selection, which is then selected itself; false where that is refused.
bool put_lattice_round_selection(Session& session);

} // namespace trivar
