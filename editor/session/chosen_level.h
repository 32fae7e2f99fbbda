// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

#include <algorithm>

namespace trivar {

// The level of volume data that a hand works on. It belongs to the person, as the selection does.
struct ChosenLevel {
    Id object = 0;
    int number = 0; // the first is 0
    bool operator==(const ChosenLevel&) const = default;
};

// Returns the chosen level of an object: the first, if no other was chosen; -1: it has none.
inline int chosen_in(const VoxelShape& shape, Id id, const ChosenLevel& chosen)
{
    const int last = static_cast<int>(shape.levels.size()) - 1;
    return chosen.object == id ? std::min(chosen.number, last) : std::min(0, last);
}

} // namespace trivar
