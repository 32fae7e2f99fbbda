// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/columns.h"
#include "core/incise/incision.h"
#include "core/incise/narrowing.h"

namespace trivar {

// A SlitRun is a stroke after the drawing was arranged: its points in their order. A loop's run
// continues past its start, so that its first and last pieces overlap.
struct SlitRun {
    struct At {
        std::uint32_t point;
        double s;             // length from the beginning
        double depth = 0;     // of the floor there; of a cut through the body: of its last row
        double thickness = 0; // of the body below it; infinite: it is open there
    };
    enum class Kind { to_floor, through, far_side };
    std::uint32_t incision = 0; // of which it is, or is a part
    double length = 0;
    double from = 0, to = 1; // shares of its incision's length that it covers
    double width = 0;        // of its gap where it is widest, when it is quite open
    std::vector<At> at;
    std::size_t last = 0; // number of the point at `length`
    Kind kind = Kind::to_floor;
    double near_length = 0; // of the far side: of the run on the near side
    // The least share of the depth that was asked for along it, but near its ends, that the body
    // has room for.
    double least_depth = 1;

    bool closed() const { return last > 0 && at.front().point == at[last].point; }
    bool goes_round() const { return closed() && from == 0 && to == 1; } // all of its incision
    bool has_floor() const { return kind == Kind::to_floor; }
    double own_share(double s) const // of its own length
    {
        return (closed() && s > length ? s - length : s) / length;
    }
    double share(double s) const { return from + (to - from) * own_share(s); } // of its incision's
    // Each part of an incision has the whole profile.
    double value(const IncisionProfile& profile, double s) const
    {
        return closed() ? value_round(profile, own_share(s)) : value_at(profile, s / length);
    }
    // A length along it as a share of its incision's length.
    double as_share(double way) const { return way * (to - from) / length; }
};
// A DrawnStroke is the part of an incision that a stroke of a drawing is.
struct DrawnStroke {
    std::uint32_t incision;
    double from = 0, to = 1;
};
std::vector<SlitRun> runs_of(const SlitDrawing& drawing, std::span<const DrawnStroke> strokes,
                             std::span<const Incision> incisions);

// Sets the depth of runs at each point: that of the profile, within the limits of the skin's
// curvature and the body's thickness, without steep steps. `shares`: the factors along their
// lengths that incisions are admitted.
void set_depths(std::vector<SlitRun>& runs, const SlitDrawing& drawing, const Inward& inward,
                const SlitColumns& columns, std::span<const Incision> incisions,
                std::span<const Narrowing> shares);
// Replaces each number along a run by the mean of the minima within a way round it: so none grows,
// and a narrow place gives way to a valley.
void smooth_room(const SlitRun& run, double way, std::vector<double>& room);
double depth_at(const SlitRun& run, double s);
// Returns how far the rim is set back there, and down to which depth.
double bevel_at(const SlitRun& run, const Incision& incision, double s);
// The same for the rim on the far side of a body that is so thick there.
double far_bevel(const Incision& incision, double thickness);

// A SlitPiece is a part of a run that crosses itself nowhere and turns little. The pieces of a run
// overlap: the weight of each rises from `begin` to `full_from` and falls from `full_to` to `end`,
// and the weights add up to 1.
struct SlitPiece {
    std::uint32_t run;
    double begin, end, full_from, full_to;
    double weight(double s) const;
};
std::vector<SlitPiece> pieces_of(const std::vector<SlitRun>& runs, const SlitDrawing& drawing);

} // namespace trivar
