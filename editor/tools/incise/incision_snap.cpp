// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/incise/incision_snap.h"

#include <algorithm>

namespace trivar {
namespace {

constexpr double end_reach_px = 12, line_reach_px = 7; // at scale 1

SurfacePoint mixed_place(const SurfacePoint& a, const SurfacePoint& b, double t)
{
    const glm::dvec3 n = glm::mix(a.normal, b.normal, t);
    const double length = glm::length(n);
    return {glm::mix(a.p, b.p, t), length > 1e-9 ? n / length : a.normal};
}

} // namespace

void add_snaps(IncisionSnaps& snaps, const SeenIncision& cut,
               const std::vector<SurfacePoint>& stroke)
{
    if (cut.on_skin.front()) snaps.ends.push_back({stroke.front(), cut.line.front().p_world});
    if (cut.on_skin.back()) snaps.ends.push_back({stroke.back(), cut.line.back().p_world});
    snaps.lines.emplace_back(cut.line.begin() + static_cast<std::ptrdiff_t>(cut.first),
                             cut.line.begin() + static_cast<std::ptrdiff_t>(cut.last) + 1);
}

void forget_place(IncisionSnaps& snaps, const IncisionSnap& place)
{
    std::erase_if(snaps.ends,
                  [&](const IncisionSnap& each) { return each.p_world == place.p_world; });
    std::erase_if(snaps.lines, [&](const std::vector<SurfaceHit>& line) {
        double nearest = 1e300, length = 0;
        for (std::size_t i = 1; i < line.size(); ++i) {
            const glm::dvec3 a = line[i - 1].p_world, way = line[i].p_world - a;
            const double far = glm::dot(way, way);
            const double t =
                far > 0 ? std::clamp(glm::dot(place.p_world - a, way) / far, 0.0, 1.0) : 0;
            nearest = std::min(nearest, glm::distance(a + t * way, place.p_world));
            length += std::sqrt(far);
        }
        return nearest <= 1e-6 * length;
    });
}

std::optional<IncisionSnap> snap_near(const IncisionSnaps& snaps, const Camera& camera,
                                      glm::dvec2 p_px, double scale)
{
    std::optional<IncisionSnap> out;
    double nearest = end_reach_px * scale;
    for (const IncisionSnap& end : snaps.ends)
        if (const PicturePoint at = project(camera, end.p_world); at.depth_world > 0)
            if (const double away = glm::distance(at.p_px, p_px);
                away < nearest && (!end.crossing || away < line_reach_px * scale)) {
                nearest = away;
                out = end;
            }
    if (out) return out;
    nearest = line_reach_px * scale;
    for (const std::vector<SurfaceHit>& line : snaps.lines)
        for (std::size_t i = 1; i < line.size(); ++i) {
            const PicturePoint a = project(camera, line[i - 1].p_world),
                               b = project(camera, line[i].p_world);
            if (!(a.depth_world > 0) || !(b.depth_world > 0)) continue;
            const glm::dvec2 way = b.p_px - a.p_px;
            const double far = glm::dot(way, way);
            const double t = far > 0 ? std::clamp(glm::dot(p_px - a.p_px, way) / far, 0.0, 1.0) : 0;
            const double away = glm::distance(a.p_px + t * way, p_px);
            if (away >= nearest) continue;
            nearest = away;
            out = IncisionSnap{mixed_place(line[i - 1].at_rest, line[i].at_rest, t),
                               glm::mix(line[i - 1].p_world, line[i].p_world, t), true};
        }
    return out;
}

} // namespace trivar
