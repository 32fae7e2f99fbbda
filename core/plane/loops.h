// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace trivar {

// Regions of the plane lie on a grid of whole numbers, em_units to the em: turns and areas of loops
// are exact.
inline constexpr int em_units = 1 << 18;
inline constexpr int most_units = 1 << 23; // greatest coordinate: 32 em

using Loop = std::vector<glm::ivec2>; // closed; its end is joined to its beginning
using Region = std::vector<Loop>;     // the area to the left of its loops: holes run clockwise

// Twice the area of the triangle a b c, positive where it runs counter-clockwise.
inline std::int64_t turn(const glm::ivec2& a, const glm::ivec2& b, const glm::ivec2& c)
{
    const glm::i64vec2 u = glm::i64vec2(b) - glm::i64vec2(a);
    const glm::i64vec2 v = glm::i64vec2(c) - glm::i64vec2(a);
    return u.x * v.y - u.y * v.x;
}

// The area that any of the loops winds round; with `even_odd`, the area inside of an odd number of
// them. Where loops overlap or cross, the result is their union.
Region united(const Region& loops, bool even_odd = false);

// The part of a region that is at least `distance` units from its edge, with sharp corners kept:
// parts narrower than twice that vanish.
Region inset(const Region& region, double distance);

// The same region with no edge longer than `longest` units, edges cut evenly.
Region with_short_edges(const Region& region, double longest);

} // namespace trivar
