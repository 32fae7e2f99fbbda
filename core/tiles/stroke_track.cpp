// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/stroke_track.h"

#include "core/tiles/on_surface.h"
#include "core/tiles/straightest.h"

#include <algorithm>

namespace trivar {

StrokeTrack track_of(const std::vector<StrokeStep>& path, double side, double step)
{
    StrokeTrack out;
    out.side = side;
    double length = 0;
    for (std::size_t i = 0; i < path.size(); ++i) {
        if (i > 0) length += glm::distance(path[i - 1].p, path[i].p);
        out.places.push_back(path[i].at);
        out.lengths.push_back(length);
    }
    if (path.empty()) return out;
    const double gap = glm::distance(path.front().p, path.back().p);
    out.closed = gap <= step && length > 3 * step;
    if (!out.closed) return out;
    out.places.push_back(path.front().at);
    out.lengths.push_back(length + gap);
    return out;
}

std::optional<TrackPoint> point_on(const TileBase& base, const StrokeTrack& track, double length)
{
    if (track.places.size() < 2) return std::nullopt;
    const double total = track.lengths.back();
    if (track.closed) length -= total * std::floor(length / total);
    const double slack = 1e-9 * total;
    if (!(length >= -slack && length <= total + slack)) return std::nullopt;
    const auto after = std::upper_bound(track.lengths.begin() + 1, track.lengths.end() - 1, length);
    const auto i = static_cast<std::size_t>(after - track.lengths.begin());
    const SurfacePlace& from = track.places[i - 1];
    const glm::dvec3 way = base.position(track.places[i]) - base.position(from);
    const glm::dvec3 start = direction_on(way, base.normal(from));
    const double rest = std::max(0.0, length - track.lengths[i - 1]);
    const SurfaceRay ray = straightest(base, from, rest * start);
    if (ray.left > slack) return std::nullopt;
    const SurfacePlace at = inside(ray.at);
    return TrackPoint{at, direction_on(way, base.normal(at))};
}

} // namespace trivar
