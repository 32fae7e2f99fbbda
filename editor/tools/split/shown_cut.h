// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/stages/evaluated.h"

#include <array>

namespace trivar {

// A ShownCut is the place at which a cut is seen, amid the pieces that gaps have moved. World.
// O(#V): the box of the cut object is asked.
struct ShownCut {
    std::array<glm::dvec3, 2> faces; // a point of the cut on what is below it, and above
    glm::dvec3 middle{0};            // amid those that stay
    glm::dvec3 beside{0};            // from the cut's own place to where it is seen
};
ShownCut shown_cut(const Cutting& cutting, std::size_t number, const EvaluatedObject& object);

} // namespace trivar
