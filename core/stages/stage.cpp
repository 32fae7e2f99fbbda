// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stages/stage.h"

#include "core/placement/placement.h"

namespace trivar {

Ref<Lattice> Stage::seen_cage() const
{
    return bent_cage ? **bent_cage : Ref<Lattice>(placement, &placement->volume);
}

} // namespace trivar
