// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"

#include <functional>
#include <vector>

namespace trivar {

// BoxLines are the edges of a box and the lines where a boundary meets its faces. Lines have their
// ends in common or none; a closed one has its first point as its last, too.
struct BoxLines {
    using Line = std::vector<glm::dvec3>;
    std::vector<Line> edges;    // of the box, in pieces: a line of the boundary ends where two meet
    std::vector<Line> boundary; // polylines on the faces
};

// Marches squares of at most `spacing` over the faces; points are on the boundary to 1e-6 of it.
// `inside` is of the boundary. Lines of less than three squares are left out.
BoxLines box_lines(const Box& box, const std::function<bool(const glm::dvec3&)>& inside,
                   double spacing);

} // namespace trivar
