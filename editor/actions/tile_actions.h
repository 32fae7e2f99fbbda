// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/actions/actions.h"

namespace trivar {

// Mixes the tiles of the layer that was selected last with the other selected objects, or lets them
// become the other one; and makes layers single objects again.
void add_tile_actions(std::vector<Action>& actions);

} // namespace trivar
