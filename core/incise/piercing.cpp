// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/piercing.h"

#include "core/base/parallel.h"
#include "core/base/unit.h"
#include "core/incise/box_sweep.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace trivar {
namespace {

constexpr double least_certain = 1e-14; // of the largest determinant with such edges
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

// Two triangles, relative to a point of theirs, while their corners move straight from one place to
// another. A common corner is that point.
struct MovingPair {
    std::array<std::array<glm::dvec3, 6>, 2> places; // when they begin and end; first those of s
    bool touch = false;                              // they have a common corner
    std::array<std::size_t, 2> count{0, 0};          // of the other corners of each
    double size = 0;                                 // of the coordinates

    MovingPair(const std::vector<glm::dvec3>& from, const std::vector<glm::dvec3>& to,
               const glm::uvec3& s, const glm::uvec3& t, unsigned common_corner)
        : touch(common_corner != 0)
    {
        const std::uint32_t common = s[touch ? std::countr_zero(common_corner) / 3 : 0];
        const std::array<const glm::uvec3*, 2> both{&s, &t};
        for (std::size_t which = 0; which < 2; ++which)
            for (int i = 0; i < 3; ++i) {
                const std::uint32_t v = (*both[which])[i];
                if (touch && v == common) continue;
                const std::size_t at = 3 * which + count[which]++;
                places[0][at] = from[v] - from[common];
                places[1][at] = to[v] - to[common];
                size = std::max({size, size_of(from[v]), size_of(to[v])});
            }
    }
    // Whether a plane with that normal, which moves with the point, stays between them.
    bool parted_along(const glm::dvec3& n) const
    {
        const double least = least_apart * size * size_of(n);
        bool all_below = true, all_above = true; // of s, seen from t
        for (const std::array<glm::dvec3, 6>& at : places) {
            std::array<double, 2> lo{1e300, 1e300}, hi{-1e300, -1e300};
            for (std::size_t which = 0; which < 2; ++which)
                for (std::size_t i = 0; i < count[which]; ++i) {
                    const double h = glm::dot(n, at[3 * which + i]);
                    lo[which] = std::min(lo[which], h);
                    hi[which] = std::max(hi[which], h);
                }
            if (touch) {
                all_below = all_below && hi[0] < -least && lo[1] > least;
                all_above = all_above && lo[0] > least && hi[1] < -least;
            } else {
                all_below = all_below && hi[0] + least < lo[1];
                all_above = all_above && hi[1] + least < lo[0];
            }
            if (!all_below && !all_above) return false;
        }
        return true;
    }
    // From the middle of one to that of the other; of directions, so that long sides do not count.
    glm::dvec3 between() const
    {
        std::array<glm::dvec3, 2> sum{glm::dvec3(0), glm::dvec3(0)};
        for (const std::array<glm::dvec3, 6>& at : places)
            for (std::size_t which = 0; which < 2; ++which)
                for (std::size_t i = 0; i < count[which]; ++i) sum[which] += at[3 * which + i];
        if (!touch) return sum[1] - sum[0];
        return unit_or_zero(sum[1]) - unit_or_zero(sum[0]);
    }
    static constexpr double least_apart = 1e-12; // of coordinates: far more than roundings
};

// Whether they share a side, or a plane stays between them while they move, so that nothing pierces.
bool stay_apart(const std::vector<glm::dvec3>& from, const std::vector<glm::dvec3>& to,
                const glm::uvec3& s, const glm::uvec3& t)
{
    const unsigned common = common_corners(s, t);
    if ((common & (common - 1)) != 0) return true;
    const MovingPair pair(from, to, s, t, common);
    if (pair.parted_along(pair.between())) return true;
    for (const auto* p : {&from, &to})
        for (const glm::uvec3& of : {s, t})
            if (pair.parted_along(
                    glm::cross((*p)[of.y] - (*p)[of.x], (*p)[of.z] - (*p)[of.x])))
                return true;
    for (int i = 0; i < 3; ++i) {
        glm::dvec3 axis(0);
        axis[i] = 1;
        if (pair.parted_along(axis)) return true;
    }
    return false;
}

} // namespace

bool pierce(std::span<const glm::dvec3> p, const glm::uvec3& s, const glm::uvec3& t)
{
    for (int i = 0; i < 3; ++i) // most are far from each other at a time
        if (std::max({p[s.x][i], p[s.y][i], p[s.z][i]}) <
                std::min({p[t.x][i], p[t.y][i], p[t.z][i]}) ||
            std::max({p[t.x][i], p[t.y][i], p[t.z][i]}) <
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
