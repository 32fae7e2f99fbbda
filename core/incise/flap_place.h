// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace trivar {

enum class IncisionSide { left, right }; // of a stroke, seen from outside

// A FlapPlace is a sector between two incisions that cross: that on these sides of them.
//
//          left  ^ right         (side_of_first, side_of_second), seen from outside:
//          left  | left
//        --------+--------> second
//          left  | right
//          right | right
//              first
struct FlapPlace {
    std::uint32_t first = 0, second = 0; // of the incisions
    IncisionSide side_of_first = IncisionSide::left, side_of_second = IncisionSide::left;
    bool operator==(const FlapPlace&) const = default;
};

} // namespace trivar
