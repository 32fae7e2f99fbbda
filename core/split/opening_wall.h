// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/split/cut_surface.h"
#include "core/split/split_ends.h"

namespace trivar {

// An OpeningWall is the distance by which one half is moved away from the cut surface: W(v, w), a
// bicubic spline over a rectangle, zero at its border and beyond it:
//
//    W ^        .-------------.         at least `clearance` over the obstacle
//      |     .-'               `-.
//    0 +----'-----|#########|-----`---> v
//          lo     |<-shadow>|     hi    margin * shadow more at both ends of the shadow
struct OpeningWall {
    Surface<double> height; // metres, nowhere negative
    double most = 0;        // greatest control value: W is nowhere larger
    double clear = 0;       // metres: it is certain that the obstacle is nowhere nearer along u

    glm::dvec2 lo() const { return {height.axes[0].begin(), height.axes[1].begin()}; }
    glm::dvec2 hi() const { return {height.axes[0].end(), height.axes[1].end()}; }
};

// Shares of the length of a shadow that an opening begins before it: so that the round ends of an
// obstacle, of infinite slope, are cleared as well; so that a skin is drawn in gently; and so that
// a wall with smooth ends can rise in time.
constexpr double round_margin = 0.12, smooth_margin = 0.3;

// Returns the rectangle in which an obstacle opens a model: its shadow, and along v `margin` times
// the shadow's length more on both sides.
SplitRectangle opening_rectangle(const ObstacleColumns& columns, double clearance, double margin);

// Makes the walls below (0) and above (1) a cut surface.
//   over       the rectangle of (v, w)
//   clearance  metres
//   ends       at the ends along v one row of control points is 0; three if these are smooth
// Each is interpolated at the Greville points and then lifted until it is at least `clearance`
// beyond the obstacle at a grid of columns and at the obstacle's vertices, and until it is certain
// that no triangle of the obstacle is nearer than half of it (see WallCertificate). About 30 ms.
// [Schein, thesis, 6.3, but fitted and lifted instead of control points on the profile.]
std::array<OpeningWall, 2> opening_walls(const ObstacleColumns& columns, const CutSurface& surface,
                                         const SplitRectangle& over, double clearance,
                                         SplitEnds ends);

} // namespace trivar
