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
FarSide far_side(const SlitRun& run, const SlitDrawing& drawing, const SlitColumns& columns);

// A ThroughSlit is a run and the one that it has on the far side. The last row of its walls goes
// from the last point of columns of the near run to points of the far one, which need not be as
// many: each step of `zip` goes on by one point on one of the two.
//
//      near  0-----1-----2          zip: (0, 0) (0, 1) (1, 1) (1, 2) (2, 2) (2, 3), the
//            |`.   |`.   |`.        edges of the last row; between each and the next one
//            |  `. |  `. |  `.      is a triangle
//      far   0-----1-----2-----3
struct ThroughSlit {
    struct Step {
        std::uint32_t near, far; // numbers of points of the runs
    };
    std::uint32_t near, far; // runs
    std::vector<Step> zip;
    std::vector<Step> crossings = {}; // of others that go through, steps of `zip`, ascending
};
// Steps by length, through the crossings: at each the edge between both sides is as straight down
// as can be. `places` are those of the near run's columns on the far side.
std::vector<ThroughSlit::Step> zipped(const SlitSkin& skin, const std::vector<SkinPlace>& places,
                                      const SlitRun& far,
                                      const std::vector<ThroughSlit::Step>& crossings);

// Returns why a run cannot go through, since it crosses itself or meets an earlier one that does,
// other than in a clean crossing; empty: it can.
std::string tangle_of(const std::vector<SlitRun>& runs, std::uint32_t near,
                      const SlitDrawing& drawing, const Inward& inward);
// Finds where a cut crosses others. Why it cannot: on the far side they meet in another way, or
// nowhere; empty: it can.
std::string find_crossings(ThroughSlit& cut, const std::vector<ThroughSlit>& all,
                           const std::vector<SlitRun>& runs, const SlitDrawing& drawing,
                           const SlitColumns& columns);
// Returns why walls cannot join the two runs of a cut; empty: they can.
std::string unjoinable(const std::vector<SlitRun>& runs, const ThroughSlit& cut);

} // namespace trivar
