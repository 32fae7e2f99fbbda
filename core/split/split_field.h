// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "core/split/bicubic_cells.h"
#include "core/split/opening_wall.h"
#include "core/split/split_kernel.h"

#include <string>

namespace trivar {

// A SplitObstacle parts a model.
struct SplitObstacle {
    std::string name; // for sentences
    std::vector<RayScene::Entry> bodies;
    double clearance = 0.005; // metres between the obstacle and the walls, at least
    double reach = 0;         // metres from the cut surface; 0, or too small: what the kernel needs
    SplitKernel kernel = SplitKernel::quadratic;
    std::vector<int> objects = {};     // ids, for who asks what opened it
    double margin = round_margin;      // see opening_rectangle()
    SplitEnds ends = SplitEnds::sharp; // of those that are parted by as one, smooth where any is
};

struct OpeningBounds;

// An Opening is the gap that an obstacle asks for. Below the cut surface is 0, above it 1.
struct Opening {
    CutSurface surface;
    std::array<OpeningWall, 2> walls;
    std::array<double, 2> reach{0, 0}; // metres
    SplitKernel kernel = SplitKernel::quadratic;
    std::string name;
    std::vector<int> objects; // of all obstacles that are parted by as one
    double ends = 0;          // metres along v between its walls' ends and the obstacle's
    // the same, to be evaluated fast
    BicubicCells surface_cells;
    std::array<BicubicCells, 2> wall_cells;
    Ref<OpeningBounds> bounds;

    double height(const glm::dvec3& uvw) const // above the cut surface
    {
        return uvw.x - surface_cells.value({uvw.y, uvw.z});
    }
    bool beyond_walls(const glm::dvec2& vw) const
    {
        const glm::dvec2 lo = walls[0].lo(), hi = walls[0].hi();
        return !(vw.x > lo.x && vw.x < hi.x && vw.y > lo.y && vw.y < hi.y);
    }
};

// The reach on a side (0 below, 1 above) that the kernel needs so that nothing folds.
double needed_reach(const Opening& opening, std::size_t side, SplitKernel kernel);

// A SplitField is the function with discontinuities that parts a model:
//
//   X(u, v, w) = u + sum_i s_i W_i(v, w) K(|u - phi_i(v, w)| / R_i),
//
// s_i = -1 below and +1 above cut surface i; v and w stay.
//
//    X - u ^
//      W_1 +           |\.
//          |           |  `-.            K fades from 1 at the surface to 0 at the reach
//        0 +----.------+-----`------->   u - phi
//          |  -R_0 `-. |    R_1
//     -W_0 +         `\|
//
// A line along u is mapped into itself, and X grows along it, so nothing folds and parts on both
// sides never overlap; a point above the surface comes to lie at or above phi + W. Beyond the
// reaches and the rectangles of the walls nothing is moved. [Schein, thesis, chapter 6, with
// sheared cut surfaces in place of planes]
struct SplitField {
    SplitFrame frame;
    std::vector<Opening> openings; // ascending along u

    // The result of moving a point: its new u, and the derivative of that by (u, v, w).
    struct Moved {
        double u;
        glm::dvec3 gradient{1, 0, 0};
    };
    // `sides` (per opening) says on which side the point is counted, `on` whether it is a point of
    // the cut surface, where the distance is exactly 0.
    Moved moved(const glm::dvec3& uvw, std::span<const char> sides, std::span<const char> on) const;
    Box reach() const; // in uvw: nothing beyond it is moved
};

// Makes the field of several obstacles. Obstacles whose cut surfaces would meet are parted by as
// one; their names are joined. Reaches are widened, and a kernel replaced by the hat, where that is
// needed. Throws Rejected, with the names, if there is too little room between two.
SplitField split_field(const std::vector<SplitObstacle>& obstacles, const SplitFrame& frame);

} // namespace trivar
