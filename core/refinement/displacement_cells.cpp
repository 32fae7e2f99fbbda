// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refinement/displacement_cells.h"

#include "core/base/index.h"
#include "core/ffd/lattice.h"
#include "core/spline/insert.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trivar {
namespace {

AxisSlabs::Span span_of(const Knots& knots, double lo, double hi)
{
    AxisSlabs::Span out;
    const int degree = knots.degree(), s = knots.span(lo);
    out.first = s - degree;
    for (int i = 0; i <= degree; ++i) {
        std::array<double, max_order> arguments{};
        std::fill_n(arguments.begin(), degree - i, lo);
        std::fill_n(arguments.begin() + degree - i, i, hi);
        const auto row = blossom(knots.values(), s, degree, arguments.data());
        std::copy_n(row.begin(), knots.order(), out.bezier.begin() + i * knots.order());
    }
    return out;
}

AxisSlabs::Joint joint_of(const Knots& knots, double at_knot)
{
    const int times = knots.multiplicity(at_knot);
    return times >= knots.order()    ? AxisSlabs::Joint::jump
           : times == knots.degree() ? AxisSlabs::Joint::kink
                                     : AxisSlabs::Joint::smooth;
}

int floor_of_quotient(int a, int b)
{
    return a >= 0 ? a / b : -((b - 1 - a) / b);
}

// Bounds the derivative along an axis, whose control points are difference quotients of neighbours.
double steepest(const Trivariate<glm::dvec3>& f, int axis)
{
    const Knots& knots = f.axes[at(axis)];
    const std::vector<double>& t = knots.values();
    glm::ivec3 counts(f.axes[0].count(), f.axes[1].count(), f.axes[2].count());
    counts[axis] = knots.unwrapped_count() - 1;
    glm::ivec3 step(0);
    step[axis] = 1;
    double most = 0;
    for (int i = 0; i < counts.x; ++i)
        for (int j = 0; j < counts.y; ++j)
            for (int k = 0; k < counts.z; ++k) {
                const int n = axis == 0 ? i : axis == 1 ? j : k;
                const double width = t[at(n + knots.order())] - t[at(n + 1)];
                if (!(width > 0)) continue;
                const glm::dvec3 d = f.point(i + step.x, j + step.y, k + step.z) - f.point(i, j, k);
                most = std::max(most, glm::length(d) * knots.degree() / width);
            }
    return most;
}

} // namespace

AxisSlabs::AxisSlabs(const Knots& knots)
    : order_(knots.order()),
      closure_(knots.closure()),
      period_(knots.end() - knots.begin()),
      breaks_(knots.breaks())
{
    count_ = static_cast<int>(breaks_.size()) - 1;
    for (std::size_t i = 0; i + 1 < breaks_.size(); ++i)
        spans_.push_back(span_of(knots, breaks_[i], breaks_[i + 1]));
    for (const double b : breaks_) joints_.push_back(joint_of(knots, b));
    if (open()) // the constant part joins the rest without a jump
        joints_.front() = joints_.back() = Joint::kink;
}

int AxisSlabs::upper(double x) const
{
    int turn = 0;
    if (open()) {
        if (x < breaks_.front()) return -1;
        if (x > breaks_.back()) return count_;
    } else {
        turn = static_cast<int>(std::clamp(std::floor((x - breaks_.front()) / period_), -1e6, 1e6));
        x -= turn * period_;
    }
    const auto above = std::upper_bound(breaks_.begin() + 1, breaks_.end() - 1, x);
    return turn * count_ + static_cast<int>(above - breaks_.begin()) - 1;
}

int AxisSlabs::lower(double x) const
{
    const int slab = upper(x);
    return x <= begin(slab) ? slab - 1 : slab;
}

double AxisSlabs::begin(int slab) const
{
    if (open()) {
        constexpr double infinity = std::numeric_limits<double>::infinity();
        if (slab < 0) return -infinity;
        return slab > count_ ? infinity : breaks_[at(slab)];
    }
    const int turn = floor_of_quotient(slab, count_);
    return breaks_[at(slab - turn * count_)] + turn * period_;
}

AxisSlabs::Joint AxisSlabs::joint(int slab) const
{
    if (open()) return joints_[at(slab + 1)];
    return joints_[at(slab + 1 - floor_of_quotient(slab + 1, count_) * count_)];
}

AxisSlabs::Span AxisSlabs::span(int slab) const
{
    if (open()) return spans_[at(std::clamp(slab, 0, count_ - 1))];
    const int turn = floor_of_quotient(slab, count_);
    Span out = spans_[at(slab - turn * count_)];
    out.mirrors_others = closure_ == Closure::twisted && turn % 2 != 0;
    return out;
}

double AxisSlabs::snapped(double x) const
{
    if (!open()) return x;
    const double slack = 1e-6 * period_; // the same slack as in reach()
    if (x < breaks_.front() && x >= breaks_.front() - slack) return breaks_.front();
    if (x > breaks_.back() && x <= breaks_.back() + slack) return breaks_.back();
    return x;
}

DisplacementCells::DisplacementCells(const Trivariate<glm::dvec3>& displacement)
    : f_(displacement),
      axes_{AxisSlabs(f_.axes[0]), AxisSlabs(f_.axes[1]), AxisSlabs(f_.axes[2])}
{
    for (const glm::dvec3& p : f_.points) largest_ = std::max(largest_, glm::length(p));
    for (int a = 0; a < 3; ++a) slopes_[a] = steepest(f_, a);
}

double DisplacementCells::Cell::local(const glm::dvec3& uvw, int a) const
{
    const double t =
        beyond[a] ? (slabs[a] < 0 ? 0 : 1) : std::clamp((uvw[a] - begin[a]) / size[a], 0.0, 1.0);
    return mirrored[a] ? 1 - t : t;
}

void DisplacementCells::load(const glm::ivec3& slabs, Cell& cell) const
{
    cell.slabs = slabs;
    cell.mirrored = glm::bvec3(false);
    std::array<AxisSlabs::Span, 3> spans;
    for (int a = 0; a < 3; ++a) {
        spans[at(a)] = axis(a).span(slabs[a]);
        if (spans[at(a)].mirrors_others)
            for (int other = 0; other < 3; ++other)
                if (other != a) cell.mirrored[other] = !cell.mirrored[other];
    }
    for (int a = 0; a < 3; ++a) {
        if (cell.mirrored[a]) spans[at(a)] = axis(a).span(axis(a).mirrored(slabs[a]));
        cell.beyond[a] = axis(a).beyond(slabs[a]);
        cell.begin[a] = slabs[a] < 0 && cell.beyond[a] ? 0 : axis(a).begin(slabs[a]);
        cell.size[a] = cell.beyond[a] ? 1 : axis(a).end(slabs[a]) - cell.begin[a];
    }
    // The derivatives are contracted along w, in which the points are contiguous, then v, then u.
    const glm::ivec3 n = orders();
    std::array<glm::dvec4, max_order * max_order * max_order> lines, planes;
    const auto place = [&](int i, int j, int k) { return at((i * n.y + j) * n.z + k); };
    for (int i = 0; i < n.x; ++i)
        for (int j = 0; j < n.y; ++j) {
            std::array<glm::dvec4, max_order> row;
            for (int k = 0; k < n.z; ++k)
                row[at(k)] = glm::dvec4(
                    f_.point(spans[0].first + i, spans[1].first + j, spans[2].first + k), 0);
            for (int k = 0; k < n.z; ++k) {
                glm::dvec4 sum(0);
                for (int m = 0; m < n.z; ++m) sum += row[at(m)] * spans[2].bezier[at(k * n.z + m)];
                lines[place(i, j, k)] = sum;
            }
        }
    for (int i = 0; i < n.x; ++i)
        for (int j = 0; j < n.y; ++j)
            for (int k = 0; k < n.z; ++k) {
                glm::dvec4 sum(0);
                for (int m = 0; m < n.y; ++m)
                    sum += lines[place(i, m, k)] * spans[1].bezier[at(j * n.y + m)];
                planes[place(i, j, k)] = sum;
            }
    for (int i = 0; i < n.x; ++i)
        for (int j = 0; j < n.y; ++j)
            for (int k = 0; k < n.z; ++k) {
                glm::dvec4 sum(0);
                for (int m = 0; m < n.x; ++m)
                    sum += planes[place(m, j, k)] * spans[0].bezier[at(i * n.x + m)];
                cell.points[place(i, j, k)] = sum;
            }
}

} // namespace trivar
