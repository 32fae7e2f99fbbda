// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/overlap_map.h"

#include "core/base/index.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr int most_cells = 36; // largest number of cells of a box that is examined part by part

// Extends a closed axis by one turn.
Knots unrolled(const Knots& knots)
{
    if (knots.closure() == Closure::open) return knots;
    std::vector<double> t = knots.values();
    const double period = knots.end() - knots.begin();
    for (int i = 0; i < knots.count(); ++i) t.push_back(t[t.size() - at(knots.count())] + period);
    return Knots::general(knots.order(), std::move(t));
}

bool jumps(const Knots& knots)
{
    const std::vector<double> breaks = knots.breaks();
    for (std::size_t i = 0; i < breaks.size(); ++i) {
        const bool end = i == 0 || i + 1 == breaks.size();
        if ((!end || knots.closure() != Closure::open) &&
            knots.multiplicity(breaks[i]) >= knots.order())
            return true;
    }
    return false;
}

// Says whether the affine part of a map closes with its axes.
bool closes(const Lattice& lattice)
{
    const auto& axes = lattice.displacement.axes;
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b < 3; ++b) {
            const bool must_vanish = axes[at(a)].closure() == Closure::twisted ||
                                     (a == b && axes[at(a)].closure() == Closure::periodic);
            if (must_vanish && glm::dvec3(lattice.rest[b]) != glm::dvec3(0)) return false;
        }
    return true;
}

} // namespace

std::optional<UnrolledMap> UnrolledMap::of(const Lattice& lattice)
{
    const Trivariate<glm::dvec3>& f = lattice.displacement;
    if (!closes(lattice)) return {};
    glm::bvec3 closed(false);
    int twisted = -1;
    ParameterBox domain{};
    for (int a = 0; a < 3; ++a) {
        const Knots& knots = f.axes[at(a)];
        if (jumps(knots)) return {};
        closed[a] = knots.closure() != Closure::open;
        if (knots.closure() == Closure::twisted) twisted = a;
        domain.lo[a] = knots.begin();
        domain.hi[a] = knots.end();
    }
    Trivariate<glm::dvec3> map{{unrolled(f.axes[0]), unrolled(f.axes[1]), unrolled(f.axes[2])}, {}};
    const auto& axes = map.axes;
    for (int i = 0; i < axes[0].count(); ++i)
        for (int j = 0; j < axes[1].count(); ++j)
            for (int k = 0; k < axes[2].count(); ++k) {
                const glm::dvec4 site(axes[0].greville(i), axes[1].greville(j), axes[2].greville(k),
                                      1);
                map.points.push_back(f.point(i, j, k) + glm::dvec3(lattice.rest * site));
                for (int c = 0; c < 3; ++c)
                    if (!std::isfinite(map.points.back()[c])) return {};
            }
    return UnrolledMap(std::move(map), domain, closed, twisted);
}

UnrolledMap::UnrolledMap(Trivariate<glm::dvec3> map, const ParameterBox& domain, glm::bvec3 closed,
                         int twisted)
    : map_(std::move(map)),
      domain_(domain),
      closed_(closed),
      twisted_(twisted),
      cells_(bezier_cells(map_))
{
    for (std::size_t a = 0; a < 3; ++a) breaks_[a] = map_.axes[a].breaks();
    for (const BezierCell& cell : cells_) bounds_.push_back(trivar::bounds(cell));
}

ParameterBox UnrolledMap::turned(ParameterBox box, int axis) const
{
    const double turn = domain_.hi[axis] - domain_.lo[axis];
    box.lo[axis] += turn;
    box.hi[axis] += turn;
    for (int a = 0; a < 3 && axis == twisted_; ++a)
        if (a != axis) {
            const double sum = domain_.lo[a] + domain_.hi[a], lo = box.lo[a];
            box.lo[a] = sum - box.hi[a];
            box.hi[a] = sum - lo;
        }
    return box;
}

std::array<std::array<int, 2>, 3> UnrolledMap::cells_of(const ParameterBox& box) const
{
    std::array<std::array<int, 2>, 3> out{};
    for (int a = 0; a < 3; ++a) {
        const std::vector<double>& b = breaks_[at(a)];
        const int cells = static_cast<int>(b.size()) - 1;
        const int first =
            static_cast<int>(std::upper_bound(b.begin(), b.end(), box.lo[a]) - b.begin()) - 1;
        const int end =
            static_cast<int>(std::lower_bound(b.begin(), b.end(), box.hi[a]) - b.begin());
        out[at(a)][0] = std::clamp(first, 0, cells - 1);
        out[at(a)][1] = std::clamp(end, out[at(a)][0] + 1, cells);
    }
    return out;
}

std::optional<UnrolledMap::Cut> UnrolledMap::cut(const ParameterBox& box, int halvings) const
{
    const auto range = cells_of(box);
    const Jet<glm::dvec3> f = jet((box.lo + box.hi) / 2.0);
    std::optional<Cut> out;
    double longest = -1;
    for (int a = 0; a < 3; ++a) {
        const auto [first, end] = range[at(a)];
        const double size = box.hi[a] - box.lo[a],
                     cell = breaks_[at(a)][at(first + 1)] - breaks_[at(a)][at(first)];
        if (!(size > cell * std::exp2(-halvings))) continue;
        const double length = size * glm::length(f.first[at(a)]);
        if (!(length > longest)) continue;
        longest = length;
        const double t =
            end - first > 1 ? breaks_[at(a)][at((first + end) / 2)] : (box.lo[a] + box.hi[a]) / 2;
        out = Cut{a, t};
    }
    return out;
}

std::vector<BezierCell> UnrolledMap::parts(const ParameterBox& box) const
{
    const auto range = cells_of(box);
    const std::size_t nv = breaks_[1].size() - 1, nw = breaks_[2].size() - 1;
    std::vector<BezierCell> out;
    if ((range[0][1] - range[0][0]) * (range[1][1] - range[1][0]) * (range[2][1] - range[2][0]) >
        most_cells)
        return out;
    for (int i = range[0][0]; i < range[0][1]; ++i)
        for (int j = range[1][0]; j < range[1][1]; ++j)
            for (int k = range[2][0]; k < range[2][1]; ++k) {
                const BezierCell& cell = cells_[(at(i) * nv + at(j)) * nw + at(k)];
                const glm::dvec3 edge = cell.hi - cell.lo;
                const glm::dvec3 lo = glm::clamp((box.lo - cell.lo) / edge, 0.0, 1.0),
                                 hi = glm::clamp((box.hi - cell.lo) / edge, 0.0, 1.0);
                out.push_back(part_of(cell, lo, hi));
            }
    return out;
}

Box UnrolledMap::bounds(const ParameterBox& box) const
{
    Box out;
    for (const glm::dvec3& p : hull(box)) out.add(p);
    if (!out.empty()) return out;
    const auto range = cells_of(box);
    const std::size_t nv = breaks_[1].size() - 1, nw = breaks_[2].size() - 1;
    for (int i = range[0][0]; i < range[0][1]; ++i)
        for (int j = range[1][0]; j < range[1][1]; ++j)
            for (int k = range[2][0]; k < range[2][1]; ++k)
                out.add(bounds_[(at(i) * nv + at(j)) * nw + at(k)]);
    return out;
}

std::vector<glm::dvec3> UnrolledMap::hull(const ParameterBox& box) const
{
    std::vector<glm::dvec3> out;
    for (const BezierCell& part : parts(box))
        out.insert(out.end(), part.points.begin(), part.points.end());
    return out;
}

bool UnrolledMap::nearly_affine(const ParameterBox& box) const
{
    const Jet<glm::dvec3> f = jet((box.lo + box.hi) / 2.0);
    const glm::dmat3 a(f.first[0], f.first[1], f.first[2]);
    if (!(std::abs(glm::determinant(a)) > 0)) return false;
    // Each axis is measured by its length in the world, so that its parametrization does not
    // matter.
    const glm::dvec3 speed(glm::length(a[0]), glm::length(a[1]), glm::length(a[2]));
    const glm::dmat3 inverse = glm::inverse(a);
    const std::vector<BezierCell> of = parts(box);
    glm::dvec3 worst(0); // 0 for a flat axis, along which no two points differ
    for (const BezierCell& part : of) {
        const glm::dvec3 edge = part.hi - part.lo;
        const std::array<int, 3> step{part.orders.y * part.orders.z, part.orders.z, 1};
        for (int axis = 0; axis < 3; ++axis) {
            if (!(edge[axis] > 0)) continue;
            glm::dvec3 unit(0);
            unit[axis] = 1;
            const double factor = (part.orders[axis] - 1) / edge[axis];
            const int row = step[at(axis)] * part.orders[axis];
            for (int p = 0; p < static_cast<int>(part.points.size()); ++p) {
                if (p % row >= row - step[at(axis)]) continue; // the last point along the axis
                const glm::dvec3 slope =
                    factor * (part.points[at(p + step[at(axis)])] - part.points[at(p)]);
                const double off = glm::length(speed * (inverse * slope - unit)) / speed[axis];
                if (!(off <= worst[axis])) worst[axis] = off;
            }
        }
    }
    return !of.empty() && glm::length(worst) < 1 - 1e-9;
}

} // namespace trivar
