// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limit/surface_point.h"

#include <cstdint>
#include <span>
#include <vector>

namespace trivar {

// A IncisionProfile says how a number runs along a cut, as a share of its greatest value, by x from
// 0 to 1: the share of the cut's length. All of them are 0 at both ends.
struct IncisionProfile {
    enum class Shape { lens, even, custom } shape = Shape::lens;
    // The points (x, share) of a custom profile, by ascending x, share 0 to 1, joined by straight
    // lines.
    std::vector<glm::dvec2> points = {};
    bool operator==(const IncisionProfile&) const = default;
};
double value_at(const IncisionProfile& profile, double x);
// The same along a loop, which has no ends.
double value_round(const IncisionProfile& profile, double x);

// An Incision is one cut in a skin, as a document stores it. Lengths are in units of the mesh. A
// stroke that ends at the point where it began is a loop. Its profile across the stroke, when fully
// open:
//
//     floor v                 floor u                     with a bevel
//     ---.<-width->.---       ---.<-width->.---       ---.            .---    skin
//         \       /               \       /               `.<-width->.'       bevel deep
//          \     /                 \     /                  \       /
//           `. .'                   \___/                    \     /
//             v   depth             floor_width * width       `. .'
struct Incision {
    std::vector<SurfacePoint> stroke; // on the skin at rest, two at least
    double depth = 0.1;               // where the cut is deepest, before the body's limits
    IncisionProfile depth_profile{IncisionProfile::Shape::even, {}};
    // v: its walls meet below; u: a flat floor joins them; through: it goes to the skin on the
    // other side, which opens too; where there is no way through it is cut to its depth, as v.
    enum class Floor { v, u, through } floor = Floor::v;
    double floor_width = 0.5; // of a U floor: share of the width, where there is as much room below

    double width = 0.1; // of the gap in the skin where it is widest, when the cut is quite open
    IncisionProfile opening_profile;
    double reach = 0; // how far beside the cut the skin gives way; 0: three widths

    // Whether the piece that a loop through the body cuts out, the smaller part, stays.
    enum class Piece { kept, left_out } piece = Piece::kept;
    double lean_deg = 0; // of the walls: on their way down they go to the left of the stroke
    // The distance by which the open rim is set back beyond the width, and the depth down to which
    // it is.
    double bevel = 0;
    double roundness = 0; // of the bevel: 0 flat, 1 a quarter of a circle
    bool operator==(const Incision&) const = default;
};

// Returns the width of the gap where it is widest, of a cut of that length when fully open: the
// stated width, or as much as its lips have length for.
double width_of(const Incision& cut, double length);
// Returns how far beside it the skin gives way: the stated reach, else three widths with the bevel,
// at most the length.
double reach_of(const Incision& cut, double length);
double length_of(std::span<const SurfacePoint> stroke);
// The same cut with its stroke from end to start.
Incision reversed(Incision cut);
// Its mirror image in the plane x = 0.
Incision mirrored(Incision cut);

// An IncisionOpening is the state of an incision at a time; nothing of the topology depends on it.
struct IncisionOpening {
    double share = 1;        // of the width: 0 shut, 1 quite open
    double from = 0, to = 1; // shares of the length between which the blade has passed
    bool operator==(const IncisionOpening&) const = default;
};

// The opening of the reversed cut.
IncisionOpening reversed(const IncisionOpening& opening);
// Returns how open it is at x, a share of the length: 0 to 1, with soft ends.
double share_at(const IncisionOpening& opening, double x);

// A WallLayer is the material of the walls above a depth and below that of the layer before.
struct WallLayer {
    double depth = 0; // units of the mesh; that of the last layer does not matter
    std::uint32_t material = 0;
    bool operator==(const WallLayer&) const = default;
};

} // namespace trivar
