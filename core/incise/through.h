// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/runs.h"

#include <string>

namespace trivar {

// A FarSide is where the columns below a run leave the body.
struct FarSide {
    std::vector<SkinPlace> places; // by point of the run, to its last
    std::vector<double> depths;    // of these below the near side
    std::string refusal;           // why they are of no use, a sentence
};
FarSide far_side(const CutRun& run, const CutDrawing& drawing, const CutColumns& columns);

// A ThroughCut is a run and the one that it has on the far side. The last row of its walls goes
// from the last point of columns of the near run to points of the far one, which need not be as
// many: each step of `zip` goes on by one point on one of the two.
struct ThroughCut {
    struct Step {
        std::uint32_t near, far; // numbers of points of the runs
    };
    std::uint32_t near, far; // runs
    std::vector<Step> zip;
};
// Steps by length: at each the edge between both sides is as straight down as can be. `places` are
// those of the near run's columns on the far side.
std::vector<ThroughCut::Step> zipped(const CutSkin& skin, const std::vector<SkinPlace>& places,
                                     const CutRun& far);

// Why a run cannot go through, as it crosses itself or an earlier one that does; empty: it can.
std::string tangle_of(const std::vector<CutRun>& runs, std::uint32_t near);
// Why walls cannot join two runs; empty: they can.
std::string unjoinable(const std::vector<CutRun>& runs, std::uint32_t near, std::uint32_t far);

} // namespace trivar
