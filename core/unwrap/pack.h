// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace trivar {

// The turn, a rotation matrix, after which the box of points, sides along the axes, is the
// smallest, and not higher than it is wide. O(#points log #points), and O(#hull ^ 2).
glm::dmat2 smallest_box_turn(std::span<const glm::dvec2> points);

// The place of an outline in the square: p becomes turn * p + shift.
struct PackedPlace {
    glm::dmat2 turn{1}; // by quarter turns
    glm::dvec2 shift{0};
};
struct Packing {
    std::vector<PackedPlace> places; // of each outline
    double side = 0;                 // of the square that holds them, from 0 on
    double margin = 0; // round each outline, as a share of the side; may be less than asked
};

// Packs the areas inside of closed lines into a square, about the smallest that the way of packing
// finds: the highest first, each where its top is lowest when it falls, in steps of a column, on
// the skyline of those before; lying or standing, and either way up [1].
//   outlines  closed lines
//   margin    share of the square's side that is kept free round each; made smaller if it alone
//             would take a quarter of the square
//   progress  called for every outline that is tried; its throw cancels
// O(#outlines * #columns * their width in columns) for each size of the square.
//   [1] Levy, Petitjean, Ray, Maillot, "Least squares conformal maps", 2002, section 4
Packing packed(std::span<const std::vector<glm::dvec2>> outlines, double margin,
               const Progress& progress = {});

} // namespace trivar
