// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/inward.h"
#include "core/incise/slit_drawing.h"

namespace trivar {

// SlitColumns hold the direction of the wall below each point of a drawing: inward, unless the cut
// leans or goes through the body. At a depth w a column is at position(point) - w outward(point):
//
//      a        b        c       points of the drawing on the skin, w = 0
//    --o--------o--------o--
//       \       |       /
//        o      o      o         w = depth / 2
//         \     |     /
//          o    o    o           w = depth of the floor
class SlitColumns {
public:
    SlitColumns(const SlitDrawing& drawing, const Inward& inward)
        : drawing_(&drawing),
          inward_(&inward)
    {
    }

    glm::dvec3 outward(std::uint32_t point) const;
    void turn(std::uint32_t point, const glm::dvec3& outward);
    // The greatest depth, at most `wanted`, at which `share` is left of the way from one of two
    // columns to the other. Only where a column was turned: others are told by layers.
    double sound_depth(std::uint32_t a, std::uint32_t b, double wanted, double share) const;

private:
    const SlitDrawing* drawing_;
    const Inward* inward_;
    KeyNumbers number_;
    std::vector<glm::dvec3> outward_;
};

} // namespace trivar
