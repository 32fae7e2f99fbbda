// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/piercing.h"

#include "core/base/parallel.h"
#include "core/incise/box_sweep.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace trivar {
namespace {

constexpr double least_certain = 1e-14; // of the largest determinant with such edges
constexpr double least_apart = 1e-12;   // of coordinates: far more than roundings
constexpr std::size_t triangles_per_block = 2048, entries_per_block = 1024;

using TriangleCorners = std::array<glm::dvec3, 3>;
using CornerSides = std::array<int, 3>; // of a plane; 0: not certain

double size_of(const glm::dvec3& v)
{
    return std::abs(v.x) + std::abs(v.y) + std::abs(v.z);
}

// The plane through three points.
class CertainPlane {
public:
    CertainPlane(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
        : a_(a),
          normal_(glm::cross(b - a, c - a)),
          bound_(least_certain * size_of(b - a) * size_of(c - a))
    {
    }
    int side(const glm::dvec3& p) const
    {
        const glm::dvec3 x = p - a_;
        const double det = glm::dot(normal_, x), bound = bound_ * size_of(x);
        return int{det > bound} - int{det < -bound};
    }

private:
    glm::dvec3 a_, normal_;
    double bound_;
};

// Whether the line from p to q, whose ends lie on those sides of a triangle's plane, goes through
// its inside.
bool goes_through(const glm::dvec3& p, const glm::dvec3& q, int side_p, int side_q,
                  const TriangleCorners& t)
{
    if (side_p * side_q >= 0) return false;
    const auto turn = [&](std::size_t i, std::size_t k) {
        return CertainPlane(p, q, t[i]).side(t[k]);
    };
    const int u = turn(0, 1);
    return u != 0 && u == turn(1, 2) && u == turn(2, 0);
}

// Whether a side of `t`, whose corners lie on those sides of the other's plane, goes through its
// inside.
bool goes_through(const TriangleCorners& t, const CornerSides& side, const TriangleCorners& other)
{
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t k = (i + 1) % 3;
        if (goes_through(t[i], t[k], side[i], side[k], other)) return true;
    }
    return false;
}

// The corner `common` of t, or -1, is one of the other's.
CornerSides sides_of(const TriangleCorners& t, int common, const TriangleCorners& other)
{
    const CertainPlane plane(other[0], other[1], other[2]);
    CornerSides out{plane.side(t[0]), plane.side(t[1]), plane.side(t[2])};
    if (common >= 0) out[static_cast<std::size_t>(common)] = 0;
    return out;
}

// Whether all but a common corner are, for certain, on the same side, so that nothing pierces.
bool on_one_side(const CornerSides& side, int common)
{
    const int sum = side[0] + side[1] + side[2];
    return std::abs(sum) == (common < 0 ? 3 : 2);
}

// A bit for each pair of corners: the lowest three are those of the first one of s.
unsigned common_corners(const glm::uvec3& s, const glm::uvec3& t)
{
    const auto with = [&](std::uint32_t p) {
        return unsigned{p == t.x} | unsigned{p == t.y} << 1 | unsigned{p == t.z} << 2;
    };
    return with(s.x) | with(s.y) << 3 | with(s.z) << 6;
}

// Whether two triangles whose corners move straight from one place to another share a side, or a
// plane through their common corner, if there is one, stays between them: then nothing pierces.
bool stay_apart(const std::vector<glm::dvec3>& from, const std::vector<glm::dvec3>& to,
                const glm::uvec3& s, const glm::uvec3& t)
{
    const unsigned common = common_corners(s, t);
    if ((common & (common - 1)) != 0) return true;
    const bool touch = common != 0;
    const std::uint32_t origin = s[touch ? std::countr_zero(common) / 3 : 0];
    std::array<std::array<glm::dvec3, 6>, 2> places; // from the origin; first those of s
    double size = 0;
    for (int i = 0; i < 6; ++i) {
        const glm::uvec3& of = i < 3 ? s : t;
        std::uint32_t v = of[i % 3];
        if (touch && v == origin) v = of[(i + 1) % 3];
        places[0][static_cast<std::size_t>(i)] = from[v] - from[origin];
        places[1][static_cast<std::size_t>(i)] = to[v] - to[origin];
        size = std::max({size, size_of(from[v]), size_of(to[v])});
    }
    const auto parted_along = [&](const glm::dvec3& normal) {
        const double least = least_apart * size * size_of(normal);
        const auto apart = [&](const glm::dvec3& n) {
            return std::ranges::all_of(places, [&](const std::array<glm::dvec3, 6>& p) {
                const auto height = [&](std::size_t i) { return glm::dot(n, p[i]); };
                const double below = std::max({height(0), height(1), height(2)}),
                             above = std::min({height(3), height(4), height(5)});
                return touch ? below < -least && above > least : below + least < above;
            });
        };
        return apart(normal) || apart(-normal);
    };
    glm::dvec3 between(0);
    for (const std::array<glm::dvec3, 6>& p : places)
        between += p[3] + p[4] + p[5] - p[0] - p[1] - p[2];
    if (parted_along(between)) return true;
    for (const std::vector<glm::dvec3>* p : {&from, &to})
        for (const glm::uvec3& of : {s, t})
            if (parted_along(glm::cross((*p)[of.y] - (*p)[of.x], (*p)[of.z] - (*p)[of.x])))
                return true;
    return parted_along({1, 0, 0}) || parted_along({0, 1, 0}) || parted_along({0, 0, 1});
}

} // namespace

bool pierce(std::span<const glm::dvec3> p, const glm::uvec3& s, const glm::uvec3& t)
{
    for (int i = 0; i < 3; ++i) // most are far from each other at a time, or touch
        if (std::max({p[s.x][i], p[s.y][i], p[s.z][i]}) <=
                std::min({p[t.x][i], p[t.y][i], p[t.z][i]}) ||
            std::max({p[t.x][i], p[t.y][i], p[t.z][i]}) <=
                std::min({p[s.x][i], p[s.y][i], p[s.z][i]}))
            return false;
    const unsigned common = common_corners(s, t);
    if ((common & (common - 1)) != 0) return false; // more than one
    const int pair = std::countr_zero(common), at_s = common == 0 ? -1 : pair / 3,
              at_t = common == 0 ? -1 : pair % 3;
    const TriangleCorners a{p[s.x], p[s.y], p[s.z]}, b{p[t.x], p[t.y], p[t.z]};
    const CornerSides of_a = sides_of(a, at_s, b);
    if (on_one_side(of_a, at_s)) return false;
    const CornerSides of_b = sides_of(b, at_t, a);
    if (on_one_side(of_b, at_t)) return false;
    return goes_through(a, of_a, b) || goes_through(b, of_b, a);
}

std::vector<PiercingPair> piercings(const std::vector<glm::dvec3>& p,
                                    const std::vector<glm::uvec3>& triangles,
                                    std::span<const char> asked)
{
    return piercings(std::span(&p, 1), triangles, asked);
}

std::vector<PiercingPair> piercings(std::span<const std::vector<glm::dvec3>> times,
                                    const std::vector<glm::uvec3>& triangles,
                                    std::span<const char> asked)
{
    std::vector<Box> boxes(triangles.size());
    parallel_blocks(triangles.size(), triangles_per_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t)
            for (const std::vector<glm::dvec3>& p : times)
                for (int i = 0; i < 3; ++i) boxes[t].add(p[triangles[t][i]]);
    });
    const BoxSweep sweep(boxes, asked);
    std::vector<std::vector<PiercingPair>> found(sweep.entry_count() / entries_per_block + 1);
    parallel_blocks(
        sweep.entry_count(), entries_per_block, [&](std::size_t begin, std::size_t end) {
            sweep.pairs(begin, end, [&](std::uint32_t s, std::uint32_t t) {
                if (times.size() > 2 &&
                    stay_apart(times.front(), times.back(), triangles[s], triangles[t]))
                    return;
                if (std::ranges::any_of(times, [&](const std::vector<glm::dvec3>& p) {
                        return pierce(p, triangles[s], triangles[t]);
                    }))
                    found[begin / entries_per_block].push_back({std::min(s, t), std::max(s, t)});
            });
        });
    std::vector<PiercingPair> all;
    for (const auto& each : found) all.insert(all.end(), each.begin(), each.end());
    std::ranges::sort(all);
    return all;
}

} // namespace trivar
