// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/cut_drawing.h"
#include "core/incise/inward.h"

namespace trivar {

// CutColumns say which way walls go down below points of a drawing: as Inward does, but where cuts
// lean or go through the body. At a depth w a column is at position(point) - w outward(point).
class CutColumns {
public:
    CutColumns(const CutDrawing& drawing, const Inward& inward)
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
    const CutDrawing* drawing_;
    const Inward* inward_;
    KeyNumbers number_;
    std::vector<glm::dvec3> outward_;
};

} // namespace trivar
