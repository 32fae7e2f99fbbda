// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/certificate/volume_bends.h"

#include "core/base/index.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trivar {
namespace {

constexpr double endless_bend = std::numeric_limits<double>::infinity();
constexpr std::array<std::array<int, 2>, 6> axis_pairs{
    {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {2, 0}}};
constexpr double hidden_rounding = 1 + 1e-9; // what rounding may hide

double second_along(const std::array<double, 6>& second, const glm::dvec3& p, const glm::dvec3& q)
{
    double sum = 0;
    for (std::size_t n = 0; n < axis_pairs.size(); ++n) {
        const auto [a, b] = axis_pairs[n];
        const double share = a == b ? p[a] * q[a] : p[a] * q[b] + p[b] * q[a];
        if (share > 0) sum += share * second[n]; // 0 times infinity is 0 here
    }
    return sum;
}

} // namespace

double VolumeBends::Bend::off_chord(const glm::dvec3& step) const
{
    double out = second_along(second, step, step) / 8;
    for (int a = 0; a < 3; ++a)
        if (step[a] > 0 && kink[a] > 0) out += step[a] * kink[a] / 4;
    return out;
}

double VolumeBends::Bend::off_triangle(const glm::dvec3& p, const glm::dvec3& q) const
{
    double out =
        (second_along(second, p, p) + 2 * second_along(second, p, q) + second_along(second, q, q)) /
        8;
    for (int a = 0; a < 3; ++a)
        if (kink[a] > 0) out += (p[a] + q[a]) * kink[a] / 4;
    return out;
}

VolumeBends::Bend greater(const VolumeBends::Bend& a, const VolumeBends::Bend& b)
{
    VolumeBends::Bend out{a.second, glm::max(a.kink, b.kink)};
    for (std::size_t n = 0; n < out.second.size(); ++n)
        out.second[n] = std::max(out.second[n], b.second[n]);
    return out;
}

VolumeBends::VolumeBends(const Lattice& lattice) : cells_(lattice.displacement)
{
    for (int a = 0; a < 3; ++a)
        slopes_[a] = cells_.slopes()[a] + glm::length(glm::dvec3(lattice.rest[a]));
}

const std::array<double, 6>& VolumeBends::cell(const glm::ivec3& slabs)
{
    const auto [known, fresh] = known_.try_emplace({slabs.x, slabs.y, slabs.z});
    if (!fresh) return known->second;
    DisplacementCells::Cell cell;
    cells_.load(slabs, cell);
    const glm::ivec3 n = cells_.orders();
    const auto point = [&](const glm::ivec3& i) {
        return glm::dvec3(cell.points[at((i.x * n.y + i.y) * n.z + i.z)]);
    };
    for (std::size_t pair = 0; pair < axis_pairs.size(); ++pair) {
        const auto [a, b] = axis_pairs[pair];
        if (cell.beyond[a] || cell.beyond[b]) continue; // nothing changes along it
        glm::ivec3 count = n, step_a(0), step_b(0);
        step_a[a] = 1;
        step_b[b] = 1;
        count -= step_a + step_b;
        const double factor = (a == b ? (n[a] - 1) * (n[a] - 2) : (n[a] - 1) * (n[b] - 1)) /
                              (cell.size[a] * cell.size[b]);
        double most = 0;
        for (int i = 0; i < count.x; ++i)
            for (int j = 0; j < count.y; ++j)
                for (int k = 0; k < count.z; ++k) {
                    const glm::ivec3 p(i, j, k);
                    most =
                        std::max(most, glm::length(point(p + step_a + step_b) - point(p + step_a) -
                                                   point(p + step_b) + point(p)));
                }
        known->second[pair] = most * factor * hidden_rounding;
    }
    return known->second;
}

// Bounds the jump of the derivative along an axis between a cell and the one before it: the
// difference is a patch over their common face, bounded by its Bezier points.
double VolumeBends::kink(int axis, const glm::ivec3& slabs)
{
    const auto [known, fresh] = kinks_.try_emplace({axis, slabs.x, slabs.y, slabs.z}, 0);
    if (!fresh) return known->second;
    glm::ivec3 before = slabs;
    --before[axis];
    DisplacementCells::Cell a, b;
    cells_.load(before, a);
    cells_.load(slabs, b);
    const glm::ivec3 n = cells_.orders();
    const auto slope = [&](const DisplacementCells::Cell& cell, glm::ivec3 i) {
        if (cell.beyond[axis]) return glm::dvec3(0); // nothing changes along it
        const auto point = [&] {
            return glm::dvec3(cell.points[at((i.x * n.y + i.y) * n.z + i.z)]);
        };
        const glm::dvec3 there = point();
        --i[axis];
        return (there - point()) * (n[axis] - 1.0) / cell.size[axis];
    };
    double most = 0;
    const int p = (axis + 1) % 3, q = (axis + 2) % 3;
    for (int j = 0; j < n[p]; ++j)
        for (int k = 0; k < n[q]; ++k) {
            glm::ivec3 last, second;
            last[axis] = n[axis] - 1;
            second[axis] = 1;
            last[p] = second[p] = j;
            last[q] = second[q] = k;
            most = std::max(most, glm::length(slope(b, second) - slope(a, last)));
        }
    if (a.mirrored != glm::bvec3(false) || b.mirrored != glm::bvec3(false))
        most = 2 * cells_.slopes()[axis]; // its points run in the opposite direction
    return known->second = most * hidden_rounding;
}

VolumeBends::Bend VolumeBends::over(const Box& uvw)
{
    Bend out;
    glm::ivec3 from(0), to(0);
    double cells = 1;
    std::vector<std::pair<int, int>> inner; // kinks: an axis and the slab after it
    for (int a = 0; a < 3; ++a) {
        const AxisSlabs& axis = cells_.axis(a);
        // A box that only touches a knot plane does not reach beyond it.
        from[a] = axis.upper(axis.snapped(uvw.lo[a]));
        to[a] = std::max(from[a], axis.lower(axis.snapped(uvw.hi[a])));
        cells *= to[a] - from[a] + 1;
        for (int slab = from[a] + 1; slab <= to[a]; ++slab) {
            const AxisSlabs::Joint joint = axis.joint(slab - 1);
            if (joint == AxisSlabs::Joint::jump) out.kink[a] = endless_bend;
            if (joint == AxisSlabs::Joint::kink) inner.emplace_back(a, slab);
        }
    }
    constexpr double most_cells = 1e5;
    if (!(cells <= most_cells)) {
        out.second.fill(endless_bend);
        if (!inner.empty()) out.kink = glm::dvec3(endless_bend);
        return out;
    }
    for (const auto& [axis, slab] : inner) {
        glm::ivec3 lo = from, hi = to;
        lo[axis] = hi[axis] = slab;
        double most = 0;
        for (int i = lo.x; i <= hi.x; ++i)
            for (int j = lo.y; j <= hi.y; ++j)
                for (int k = lo.z; k <= hi.z; ++k) most = std::max(most, kink(axis, {i, j, k}));
        out.kink[axis] += most;
    }
    for (int i = from.x; i <= to.x; ++i)
        for (int j = from.y; j <= to.y; ++j)
            for (int k = from.z; k <= to.z; ++k) {
                const std::array<double, 6>& one = cell({i, j, k});
                for (std::size_t n = 0; n < one.size(); ++n)
                    out.second[n] = std::max(out.second[n], one[n]);
            }
    return out;
}

} // namespace trivar
