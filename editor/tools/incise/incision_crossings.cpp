// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/incise/incision_crossings.h"

#include "core/base/box.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr double apart_of_segment = 0.5; // lines on the two sides of a thin body do not cross

struct SegmentCrossing {
    double of_a = 0, of_b = 0;
};

// Where two short segments on one skin cross, as shares of both.
std::optional<SegmentCrossing> crossing_of_segments(const SurfacePoint& a0, const SurfacePoint& a1,
                                                    const SurfacePoint& b0, const SurfacePoint& b1)
{
    const glm::dvec3 n = a0.normal + a1.normal, along = a1.p - a0.p, other = b1.p - b0.p;
    if (glm::dot(n, b0.normal) <= 0) return {};
    const glm::dvec3 across = glm::cross(n, along);
    const double from = glm::dot(across, b0.p - a0.p), to = glm::dot(across, b1.p - a0.p);
    if ((from > 0) == (to > 0)) return {};
    const double t = from / (from - to);
    const glm::dvec3 at = b0.p + t * other;
    const double far = glm::dot(along, along);
    const double s = far > 0 ? glm::dot(at - a0.p, along) / far : -1;
    if (s < 0 || s >= 1) return {};
    const double longest = std::max(glm::length(along), glm::length(other));
    if (glm::distance(a0.p + s * along, at) > apart_of_segment * longest) return {};
    return SegmentCrossing{s, t};
}

Box box_of_line(const SeenIncision& cut)
{
    Box out;
    for (const SurfaceHit& each : cut.line) out.add(each.at_rest.p);
    return out;
}

bool boxes_meet(const Box& a, const Box& b, double within)
{
    for (int i = 0; i < 3; ++i)
        if (a.lo[i] > b.hi[i] + within || b.lo[i] > a.hi[i] + within) return false;
    return true;
}

SurfaceHit mixed_hit(const SurfaceHit& a, const SurfaceHit& b, double t)
{
    SurfaceHit out = t < 0.5 ? a : b;
    out.p_world = glm::mix(a.p_world, b.p_world, t);
    out.at_rest.p = glm::mix(a.at_rest.p, b.at_rest.p, t);
    return out;
}

} // namespace

std::vector<IncisionCrossing> crossings_of(const std::vector<std::optional<SeenIncision>>& cuts)
{
    std::vector<IncisionCrossing> out;
    std::vector<Box> boxes;
    for (const auto& each : cuts) boxes.push_back(each ? box_of_line(*each) : Box{});
    constexpr auto steps = static_cast<double>(SeenIncision::steps);
    for (std::size_t a = 0; a < cuts.size(); ++a)
        for (std::size_t b = a + 1; b < cuts.size(); ++b) {
            if (!cuts[a] || !cuts[b]) continue;
            const double step = (cuts[a]->length + cuts[b]->length) / steps;
            if (!boxes_meet(boxes[a], boxes[b], step)) continue;
            for (std::size_t i = 0; i < SeenIncision::steps; ++i) {
                if (!cuts[a]->on_skin[i] || !cuts[a]->on_skin[i + 1]) continue;
                const SurfaceHit &a0 = cuts[a]->line[i], &a1 = cuts[a]->line[i + 1];
                Box near;
                near.add(a0.at_rest.p);
                near.add(a1.at_rest.p);
                if (!boxes_meet(near, boxes[b], step)) continue;
                for (std::size_t k = 0; k < SeenIncision::steps; ++k) {
                    if (!cuts[b]->on_skin[k] || !cuts[b]->on_skin[k + 1]) continue;
                    const SurfaceHit &b0 = cuts[b]->line[k], &b1 = cuts[b]->line[k + 1];
                    if (glm::distance(a0.at_rest.p, b0.at_rest.p) > 2 * step) continue;
                    const auto at =
                        crossing_of_segments(a0.at_rest, a1.at_rest, b0.at_rest, b1.at_rest);
                    if (!at) continue;
                    out.push_back({static_cast<int>(a) + 1, static_cast<int>(b) + 1,
                                   (static_cast<double>(i) + at->of_a) / steps,
                                   (static_cast<double>(k) + at->of_b) / steps,
                                   mixed_hit(a0, a1, at->of_a)});
                }
            }
        }
    return out;
}

} // namespace trivar
