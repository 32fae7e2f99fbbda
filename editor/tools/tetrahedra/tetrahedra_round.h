// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/session/session.h"

namespace trivar {

inline constexpr const char* tetrahedra_action = "Tetrahedra round selection";
inline constexpr const char* fitted_tetrahedra_action = "Tetrahedra fitted to selection";

// The shape of the tetrahedra round objects: a box; about 2,000 that follow their shape, or fill
// their convex hull; or those that fill the active object, a closed mesh, exactly. That one then
// bends with them if it is alone, else it is hidden and the others do.
enum class Around { box, fitted, hull, cage };

// Puts tetrahedra round the selection, which are then selected themselves; false, with a notice,
// where that is refused. O(number of vertices).
bool put_tetrahedra_round_selection(Session& session, Around around = Around::box);

} // namespace trivar
