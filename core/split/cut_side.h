// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"
#include "core/split/cut_sheet.h"

#include <optional>

namespace trivar {

// Tells whether all of a box in the mesh's space is above the surface (true) or below it (false).
// Nothing: the surface may go through it. Certain, by the bound of how far the surface bends
// between the corners of the box's shadow. O(1) for a plane, else as CutSheet::bends().
std::optional<bool> side_of(const Box& box, const CutSheet& sheet);

} // namespace trivar
