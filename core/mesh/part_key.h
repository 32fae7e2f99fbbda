// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>

namespace trivar {

// Which part of its object one is, whichever of the others are shown.
struct PartKey {
    int member = 0; // of a procession
    int mesh = 0;   // of the shape
    int piece = 0;  // that a step made of that mesh
    auto operator<=>(const PartKey&) const = default;
};

} // namespace trivar
