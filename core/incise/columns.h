// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/cut_drawing.h"
#include "core/incise/incision.h"
#include "core/incise/inward.h"

namespace trivar {

struct CutRun;

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

// Below a cut through the body columns have the smoothed directions of their run; those of a run
// that is `parallel` have one. Then they lean as the cuts do that meet there, as far as all faces
// see them from outside.
CutColumns columns_of(const std::vector<CutRun>& runs, const std::vector<char>& parallel,
                      const CutDrawing& drawing, const Inward& inward,
                      std::span<const Incision> incisions);

} // namespace trivar
