// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spline/invert.h"

#include "core/base/rejected.h"
#include "core/spline/cell_search.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

bool is_finite(const glm::dvec3& p)
{
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

const Trivariate<glm::dvec3>& checked(const Trivariate<glm::dvec3>& f)
{
    check_shape(f);
    for (const glm::dvec3& p : f.points)
        if (!is_finite(p)) throw Rejected("a control point of the volume is not a number");
    return f;
}

glm::dvec3 middle_of(const BezierCell& cell, const BezierCell& part)
{
    return ((part.lo + part.hi) / 2.0 - cell.lo) / (cell.hi - cell.lo);
}

// One turn further along a closed axis, which is the same place.
glm::dvec3 turned(const std::vector<Knots>& axes, glm::dvec3 uvw, int axis, int turns)
{
    const Knots& k = axes[static_cast<std::size_t>(axis)];
    uvw[axis] += turns * (k.end() - k.begin());
    if (k.closure() != Closure::twisted) return uvw;
    for (int other = 0; other < 3; ++other) {
        const Knots& o = axes[static_cast<std::size_t>(other)];
        if (other != axis) uvw[other] = o.begin() + o.end() - uvw[other];
    }
    return uvw;
}

Located located(const std::vector<Knots>& axes, const BezierCell& cell, const CellSearch& s,
                Located::Status status)
{
    glm::dvec3 uvw = glm::mix(cell.lo, cell.hi, s.x);
    for (int a = 0; a < 3; ++a) { // the seam belongs to the begin
        const Knots& k = axes[static_cast<std::size_t>(a)];
        if (k.closure() != Closure::open && uvw[a] >= k.end()) uvw = turned(axes, uvw, a, -1);
    }
    return {uvw, s.residual, status};
}

} // namespace

Inverter::Inverter(const Trivariate<glm::dvec3>& f)
    : axes_(f.axes.begin(), f.axes.end()),
      cells_(bezier_cells(checked(f)))
{
    for (const BezierCell& cell : cells_) boxes_.push_back(bounds(cell));
    tree_ = BoxTree(boxes_);
    tolerance_ = 1e-12 * glm::distance(tree_.bounds().lo, tree_.bounds().hi);
}

Located Inverter::locate(const glm::dvec3& p_world, std::optional<glm::dvec3> hint) const
{
    if (!is_finite(p_world)) return {glm::dvec3(0), 1e300, Located::Status::not_converged};
    if (hint) {
        const std::vector<Located> all = locate_all(p_world);
        const auto nearer = [&](const Located& a, const Located& b) {
            return apart(a.uvw, *hint) < apart(b.uvw, *hint);
        };
        if (!all.empty()) return *std::min_element(all.begin(), all.end(), nearer);
        return nearest(p_world);
    }
    const std::vector<int> candidates = tree_.near(p_world, tolerance_);
    for (const int c : candidates) {
        const BezierCell& cell = cells_[static_cast<std::size_t>(c)];
        const CellSearch s = search_cell(cell, p_world, glm::dvec3(0.5), tolerance_);
        if (s.residual <= tolerance_) return located(axes_, cell, s, Located::Status::found);
    }
    for (const int c : candidates) {
        const auto found = search_parts(p_world, c, true);
        if (!found.empty()) return found.front();
    }
    return nearest(p_world);
}

std::vector<Located> Inverter::locate_all(const glm::dvec3& p_world) const
{
    std::vector<Located> all;
    if (!is_finite(p_world)) return all;
    for (const int c : tree_.near(p_world, tolerance_))
        for (const Located& one : search_parts(p_world, c, false)) {
            const auto same = [&](const Located& o) { return apart(o.uvw, one.uvw) < 1e-6; };
            if (std::none_of(all.begin(), all.end(), same)) all.push_back(one);
        }
    std::sort(all.begin(), all.end(), [](const Located& a, const Located& b) {
        if (a.uvw.x != b.uvw.x) return a.uvw.x < b.uvw.x;
        return a.uvw.y != b.uvw.y ? a.uvw.y < b.uvw.y : a.uvw.z < b.uvw.z;
    });
    return all;
}

// The cell is halved twice along every axis; what cannot hold p by the box of its control points
// is left out, the rest is searched from its middle.
std::vector<Located> Inverter::search_parts(const glm::dvec3& p, int c, bool first_only) const
{
    constexpr int halvings = 2;
    const BezierCell& cell = cells_[static_cast<std::size_t>(c)];
    std::vector<std::pair<BezierCell, int>> open{{cell, 0}};
    std::vector<Located> found;
    while (!open.empty()) {
        const auto [part, depth] = std::move(open.back());
        open.pop_back();
        if (bounds(part).distance(p) > tolerance_) continue;
        if (depth < halvings) {
            for (int corner = 0; corner < 8; ++corner) {
                const glm::dvec3 lo = glm::dvec3(corner / 4, corner / 2 % 2, corner % 2) / 2.0;
                open.emplace_back(part_of(part, lo, lo + 0.5), depth + 1);
            }
            continue;
        }
        const CellSearch s = search_cell(cell, p, middle_of(cell, part), tolerance_);
        if (s.residual > tolerance_) continue;
        found.push_back(located(axes_, cell, s, Located::Status::found));
        if (first_only) break;
    }
    return found;
}

// The cells in the order of their boxes' distance, until a box is further than what was found.
Located Inverter::nearest(const glm::dvec3& p) const
{
    Located best;
    best.residual = 1e300;
    double reach = tree_.distance(p);
    std::vector<bool> tried(cells_.size());
    for (bool more = true; more;) {
        std::vector<int> next;
        for (const int c : tree_.near(p, reach))
            if (!tried[static_cast<std::size_t>(c)]) next.push_back(c);
        for (const int c : next) {
            const auto at = static_cast<std::size_t>(c);
            tried[at] = true;
            if (boxes_[at].distance(p) > best.residual) continue;
            for (int start = 0; start < 9; ++start) { // the eight corners and the middle
                const glm::dvec3 x =
                    start < 8 ? glm::dvec3(start / 4, start / 2 % 2, start % 2) : glm::dvec3(0.5);
                const CellSearch s = search_cell(cells_[at], p, x, tolerance_);
                if (!(s.residual < best.residual)) continue;
                best = located(axes_, cells_[at], s,
                               s.residual <= tolerance_ ? Located::Status::found
                               : s.settled              ? Located::Status::outside
                                                        : Located::Status::not_converged);
            }
        }
        // Widened at most to what was found: no box beyond can hold a nearer point.
        more = reach < best.residual;
        reach = std::min(best.residual, 2 * reach + 1e3 * tolerance_);
    }
    return best;
}

// Distance in shares of the domain, round closed axes.
double Inverter::apart(const glm::dvec3& a, const glm::dvec3& b) const
{
    std::vector<glm::dvec3> images{b};
    glm::dvec3 size(1);
    for (int axis = 0; axis < 3; ++axis) {
        const Knots& k = axes_[static_cast<std::size_t>(axis)];
        size[axis] = k.end() - k.begin();
        if (k.closure() == Closure::open) continue;
        for (std::size_t i = images.size(); i-- > 0;)
            for (const int turns : {-1, 1}) images.push_back(turned(axes_, images[i], axis, turns));
    }
    double least = 1e300;
    for (const glm::dvec3& image : images) least = std::min(least, glm::length((a - image) / size));
    return least;
}

} // namespace trivar
