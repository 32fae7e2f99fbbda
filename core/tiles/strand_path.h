// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tiles/tile_base.h"

#include <vector>

namespace trivar {

// A StrandPoint is a sample of a stroke on the surface, in the space of the model.
struct StrandPoint {
    SurfacePoint at;
    double time_s = 0, pressure = 1;
};

// A StrandPath is a smooth path over a base as a chain of points so close that it is straight
// between them.
struct StrandPath {
    std::vector<StrandPoint> points;
    std::vector<double> lengths; // of the path up to each point; a closed one has its first twice
    bool closed = false;
    double length() const { return lengths.empty() ? 0 : lengths.back(); }
    // Interpolates the path where it is that long; beyond its ends it goes on straight, or round.
    StrandPoint at(double length) const;
};

// Lays a smooth curve through points onto a base. Ends stay where they are. Empty if the points are
// no path, or hardly on the base.
//   step       about the distance of its points, metres
//   smoothing  standard deviation of the bell curve that smooths them, metres
StrandPath strand_path(const TileBase& base, const std::vector<StrandPoint>& points, bool closed,
                       double step, double smoothing);

} // namespace trivar
