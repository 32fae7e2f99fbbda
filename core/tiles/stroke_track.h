// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tiles/laid_tiles.h"

#include <optional>

namespace trivar {

// A StrokeTrack is the way of a stroke that lays tiles one behind the other: straight from each of
// its samples to the next one.
struct StrokeTrack {
    std::vector<SurfacePlace> places; // of the samples
    std::vector<double> lengths;      // from the first sample to each, metres on the model
    double side = 0;                  // of the stroke's tiles, metres on the model
    bool closed = false; // its ends are no further apart than tiles of the stroke: it goes round
};
// `step` is the distance between tiles.
StrokeTrack track_of(const std::vector<StrokeStep>& path, double side, double step);

struct TrackPoint {
    SurfacePlace at;
    glm::dvec3 ahead{1, 0, 0}; // unit, in the plane of the normal there
};
// The point at a length from the first sample. Closed tracks go round for ever; others have nothing
// beyond their ends. O(log #samples + #edges crossed).
std::optional<TrackPoint> point_on(const TileBase& base, const StrokeTrack& track, double length);

} // namespace trivar
