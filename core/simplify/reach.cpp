// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplify/reach.h"

#include "core/base/share_along.h"

#include <algorithm>
#include <cmath>

namespace trivar {

Box box_of(const Triangle3& triangle)
{
    Box box;
    for (const glm::dvec3& p : triangle) box.add(p);
    return box;
}

namespace {

constexpr std::size_t most_pieces = 2000; // plus one per nearby triangle
constexpr std::size_t few = 12;           // triangles that are subtracted one by one
constexpr double smallest_piece = 0.02;   // relative to the distance: smaller pieces fail
constexpr double overlap = 0.25; // of the distance: margin of prisms, so that edges have no gaps

using Polygon = std::vector<glm::dvec3>; // convex

double square(const glm::dvec3& v)
{
    return glm::dot(v, v);
}

double segment_distance_squared(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b)
{
    const glm::dvec3 along = b - a;
    return square(p - a - share_along(p, a, along) * along);
}

double box_distance_squared(const glm::dvec3& p, const Box& box)
{
    return square(glm::max(glm::max(box.lo - p, p - box.hi), glm::dvec3(0)));
}

std::vector<Box> boxes_of(const std::vector<Triangle3>& triangles)
{
    std::vector<Box> boxes;
    for (const Triangle3& triangle : triangles) boxes.push_back(box_of(triangle));
    return boxes;
}

struct Ball {
    glm::dvec3 center;
    double radius;
};
Ball ball_of(const Triangle3& t)
{
    const Ball ball{box_of(t).center(), 0};
    double most = 0;
    for (const glm::dvec3& p : t) most = std::max(most, square(p - ball.center));
    return {ball.center, std::sqrt(most)};
}

// Halves are the two parts of a convex polygon at a plane.
struct Halves {
    Polygon below, above;
};
Halves halves(const Polygon& polygon, const glm::dvec3& normal, double offset)
{
    Halves out;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
        const double at_p = glm::dot(normal, p) - offset, at_q = glm::dot(normal, q) - offset;
        if (at_p <= 0) out.below.push_back(p);
        if (at_p >= 0) out.above.push_back(p);
        if ((at_p < 0 && at_q > 0) || (at_p > 0 && at_q < 0)) {
            const glm::dvec3 cut = p + (q - p) * (at_p / (at_p - at_q));
            out.below.push_back(cut);
            out.above.push_back(cut);
        }
    }
    return out;
}

bool all_within(const Polygon& polygon, const Triangle3& triangle, double distance)
{
    return std::ranges::all_of(polygon, [&](const glm::dvec3& p) {
        return distance_squared(p, triangle) <= distance * distance;
    });
}

// Appends to `left` the part of a polygon that is not above or below a triangle, within a distance
// of it.
void cut_off(const Polygon& polygon, const Triangle3& triangle, double distance,
             std::vector<Polygon>& left)
{
    const glm::dvec3 normal = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    const double size = glm::length(normal);
    double longest = 0;
    for (std::size_t i = 0; i < 3; ++i)
        longest = std::max(longest, square(triangle[(i + 1) % 3] - triangle[i]));
    // The margin is smaller at a sharp corner, where that of the wider prism would lie far outside.
    const double wider = size > 0 ? overlap * distance * size / longest : 0;
    std::vector<Polygon> outside;
    Polygon inside = polygon;
    for (std::size_t i = 0; i < 3 && size > 0 && !inside.empty(); ++i) {
        const glm::dvec3 out = glm::cross(triangle[(i + 1) % 3] - triangle[i], normal);
        const double length = glm::length(out);
        Halves cut = halves(inside, out / length, glm::dot(out / length, triangle[i]) + wider);
        if (cut.above.size() > 2) outside.push_back(std::move(cut.above));
        inside = std::move(cut.below);
    }
    if (size > 0 && inside.size() > 2 && all_within(inside, triangle, distance))
        left.insert(left.end(), outside.begin(), outside.end());
    else
        left.push_back(polygon);
}

} // namespace

double distance_squared(const glm::dvec3& p, const Triangle3& t)
{
    const glm::dvec3 normal = glm::cross(t[1] - t[0], t[2] - t[0]);
    bool above = square(normal) > 0;
    for (std::size_t i = 0; i < 3 && above; ++i)
        above = glm::dot(glm::cross(t[(i + 1) % 3] - t[i], normal), p - t[i]) <= 0;
    if (above) {
        const double height = glm::dot(p - t[0], normal);
        return height * height / square(normal);
    }
    return std::min({segment_distance_squared(p, t[0], t[1]),
                     segment_distance_squared(p, t[1], t[2]),
                     segment_distance_squared(p, t[2], t[0])});
}

Reach::Reach(std::vector<Triangle3> triangles)
    : triangles_(std::move(triangles)),
      boxes_(boxes_of(triangles_)),
      tree_(boxes_)
{
}

bool Reach::covers(const Triangle3& triangle, double distance) const
{
    const Ball ball = ball_of(triangle);
    const std::vector<int> near = tree_.near(ball.center, ball.radius + distance);
    std::size_t pieces_left = most_pieces + near.size();
    return covers(triangle, near, 2 * near.size(), distance, pieces_left);
}

bool Reach::covers(const Triangle3& piece, const std::vector<int>& near, std::size_t near_before,
                   double distance, std::size_t& pieces_left) const
{
    if (pieces_left-- == 0) return false;
    const auto within = [&](const glm::dvec3& p, int i) {
        const auto at = static_cast<std::size_t>(i);
        return box_distance_squared(p, boxes_[at]) <= distance * distance &&
               distance_squared(p, triangles_[at]) <= distance * distance;
    };
    std::array<bool, 3> reached{};
    for (const int i : near) {
        bool all = true;
        for (std::size_t k = 0; k < 3; ++k) {
            if (!all && reached[k]) continue;
            const bool in = within(piece[k], i);
            reached[k] |= in;
            all &= in;
        }
        if (all) return true;
    }
    if (!reached[0] || !reached[1] || !reached[2]) return false;
    // Quarters have fewer triangles near them, except at a corner that many triangles share.
    const bool can_cut = near.size() <= few || 2 * near.size() > near_before;
    if (can_cut && is_cut_away(piece, near, distance)) return true;
    if (ball_of(piece).radius < smallest_piece * distance) return false;
    const glm::dvec3 ab = (piece[0] + piece[1]) / 2.0, bc = (piece[1] + piece[2]) / 2.0,
                     ca = (piece[2] + piece[0]) / 2.0;
    for (const Triangle3& quarter : {Triangle3{piece[0], ab, ca}, Triangle3{ab, piece[1], bc},
                                     Triangle3{ca, bc, piece[2]}, Triangle3{ab, bc, ca}}) {
        const Ball ball = ball_of(quarter);
        std::vector<int> nearer;
        const double reach = ball.radius + distance;
        for (const int i : near)
            if (box_distance_squared(ball.center, boxes_[static_cast<std::size_t>(i)]) <=
                reach * reach)
                nearer.push_back(i);
        if (pieces_left == 0 || !covers(quarter, nearer, near.size(), distance, pieces_left))
            return false;
    }
    return true;
}

bool Reach::is_cut_away(const Triangle3& piece, const std::vector<int>& near, double distance) const
{
    std::vector<Polygon> left{Polygon(piece.begin(), piece.end())}, next;
    for (const int i : near) {
        next.clear();
        for (const Polygon& polygon : left)
            cut_off(polygon, triangles_[static_cast<std::size_t>(i)], distance, next);
        std::swap(left, next);
        if (left.empty()) return true;
    }
    return false;
}

} // namespace trivar
