// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/hands/handles.h"

namespace trivar {

// The handles of the openings that part the one selected object, by the kinds of their keys:
// "place" of an obstacle; "reach", the distance at which an opening has faded away; "clearance",
// how much of the opening stays free. Their numbers: the opening, ascending along the way in which
// it opens; and the side, -1 or 1, along which they grow. `scale`: of the interface.
std::vector<Handle> opening_handles(const Session& session, double scale);
// The handles of its cuts: "level", the place of a cut; "gap", the distance of its halves. Their
// numbers: the cut, and the side.
std::vector<Handle> cut_handles(const Session& session, double scale);

} // namespace trivar
