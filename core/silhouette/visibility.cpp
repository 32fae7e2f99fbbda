// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/silhouette/visibility.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr float first_step = 0.1f, short_steps = 0.2f, long_steps = 1.0f; // voxels
constexpr float no_movement = 1e-9f;
constexpr float near_enough = 0.1f; // of a bump's height, per its slope and length
constexpr float across_a_face = 1e-3f;

float step_after(float way)
{
    return way < short_steps ? 0.1f : way < long_steps ? 0.2f : 0.5f;
}

// The way along a line to the last of the planes lo and hi of each axis that it comes to first.
float way_to_end(const glm::vec3& p, const glm::vec3& direction, const glm::vec3& lo,
                 const glm::vec3& hi)
{
    float way = 1e30f;
    for (int k = 0; k < 3; ++k) {
        if (direction[k] > no_movement)
            way = std::min(way, (hi[k] - p[k]) / direction[k]);
        else if (direction[k] < -no_movement)
            way = std::min(way, (lo[k] - p[k]) / direction[k]);
    }
    return way;
}

// The way along a line to where it comes between two slices; more than any where it does not.
float way_into(float z, float direction, float low, float high)
{
    if (z >= low && z <= high) return 0;
    const float to = (z < low ? low : high) - z;
    return to * direction > 0 && std::abs(direction) > no_movement ? to / direction : 1e30f;
}

// A place on a line of sight: how deep it is in the body, and how fast that changes.
struct Depth {
    float way, depth, slope;
};

// The share of the way between two places at which the cubic through both is greatest; below 0
// where that is at one of them or hardly near the body.
float top_between(const Depth& a, const Depth& b)
{
    const float length = b.way - a.way;
    float top = std::max(a.depth, b.depth), at = -1;
    for (int i = 1; i < 8; ++i) {
        const float t = static_cast<float>(i) / 8, s = 1 - t;
        const float depth = (1 + 2 * t) * s * s * a.depth + t * s * s * length * a.slope +
                            (1 + 2 * s) * t * t * b.depth - s * t * t * length * b.slope;
        if (depth > top) {
            top = depth;
            at = t;
        }
    }
    return top > -near_enough * std::abs(a.slope) * length ? at : -1;
}

} // namespace

bool hides(const LevelBody& body, const glm::vec3& p, const glm::vec3& to_eye, float distance)
{
    const float sign = body.side == LevelSide::above ? 1.0f : -1.0f;
    const glm::vec3 least(0, 0, std::max(0.0f, body.low)),
        greatest(body.field.end().x, body.field.end().y, std::min(body.field.end().z, body.high));
    const float end = std::min(distance, way_to_end(p, to_eye, least, greatest));
    const auto depth_of = [&](float value) { return sign * (value - body.level); };
    Depth before{};
    bool has_before = false;
    float way = std::max(first_step, way_into(p.z, to_eye.z, least.z, greatest.z));
    while (way <= end) {
        const glm::vec3 at = p + way * to_eye;
        const glm::ivec3 brick = body.hulls.brick_of(at);
        const FieldHulls::Range& range = body.hulls.of(brick);
        if (range.least > body.level || range.greatest < body.level) {
            if (depth_of(range.least) > 0) return true;
            const glm::vec3 lo(brick * FieldHulls::brick), hi = lo + float{FieldHulls::brick};
            const float face = std::max(way, way_to_end(p, to_eye, lo, hi));
            way = std::max(face + across_a_face, std::nextafter(face, 2 * face)); // of any size
            has_before = false;
            continue;
        }
        const ScalarJet<float> jet = body.field.at<1>(at);
        const Depth here{way, depth_of(jet.value),
                         sign * (jet.gradient[0] * to_eye.x + jet.gradient[1] * to_eye.y +
                                 jet.gradient[2] * to_eye.z)};
        if (here.depth > 0) return true;
        if (has_before && before.slope > 0 && here.slope < 0)
            if (const float top = top_between(before, here); top > 0)
                for (int i = -2; i <= 2; ++i) {
                    const float share = top + static_cast<float>(i) / 16;
                    const glm::vec3 q = p + (before.way + share * (here.way - before.way)) * to_eye;
                    if (depth_of(body.field.at<0>(q).value) > 0) return true;
                }
        before = here;
        has_before = true;
        if (way == end) break;
        way = std::min(way + step_after(way), end); // a body may begin just before the end
    }
    return false;
}

std::vector<char> hollow_points(const Silhouettes& silhouettes, LevelSide side)
{
    std::vector<char> out;
    out.reserve(silhouettes.points.size());
    for (const SilhouettePoint& point : silhouettes.points)
        out.push_back(side == LevelSide::above ? point.bend > 0 : point.bend < 0);
    return out;
}

std::vector<char> hidden_by(std::vector<char> hidden, const Silhouettes& silhouettes,
                            const ViewPoint& view, std::span<const LevelBody> bodies)
{
    parallel_blocks(hidden.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (hidden[i]) continue;
            const SilhouettePoint& point = silhouettes.points[i];
            const glm::vec3 way(-view.sight(glm::dvec3(point.p)));
            const float length = glm::length(way), distance = view.at.w == 0 ? 1e30f : length;
            hidden[i] = std::ranges::any_of(bodies, [&](const LevelBody& body) {
                return hides(body, point.p, way / length, distance);
            });
        }
    });
    return hidden;
}

std::vector<char> hidden_points(const Silhouettes& silhouettes, const ViewPoint& view,
                                const LevelBody& own, std::span<const LevelBody> others)
{
    std::vector<LevelBody> bodies{own};
    for (const LevelBody& other : others) bodies.push_back(other);
    return hidden_by(hollow_points(silhouettes, own.side), silhouettes, view, bodies);
}

} // namespace trivar
