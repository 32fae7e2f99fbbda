// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/cut_drawing.h"
#include "core/incise/incision.h"
#include "core/incise/inward.h"

namespace trivar {

// A CutRun is a stroke after the drawing was arranged: its points in their order.
struct CutRun {
    struct At {
        std::uint32_t point;
        double s;         // length from the beginning
        double depth = 0; // of the floor there
    };
    std::uint32_t incision = 0; // of which it is
    double length = 0;
    std::vector<At> at;
};
std::vector<CutRun> runs_of(const CutDrawing& drawing, std::span<const std::uint32_t> incisions);

// Gives the runs their depth at each point: that of the profile, within what the skin's curvature
// and the body's thickness let be, without steep steps. All depths come times `scale`.
void set_depths(std::vector<CutRun>& runs, const CutDrawing& drawing, const Inward& inward,
                std::span<const Incision> incisions, double scale);
double depth_at(const CutRun& run, double s);

// A CutPiece is a part of a run that crosses itself nowhere and turns little. The pieces of a run
// overlap: the weight of each rises from `begin` to `full_from` and falls from `full_to` to `end`,
// and the weights add up to 1.
struct CutPiece {
    std::uint32_t run;
    double begin, end, full_from, full_to;
    double weight(double s) const;
};
std::vector<CutPiece> pieces_of(const std::vector<CutRun>& runs, const CutDrawing& drawing);

} // namespace trivar
