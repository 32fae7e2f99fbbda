// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/resolution.h"

#include "core/base/index.h"
#include "core/base/mistake.h"
#include "core/base/rejected.h"
#include "core/spline/fit_map.h"
#include "core/spline/insert.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

bool mirrored_by_another(const std::array<Knots, 3>& axes, int axis)
{
    for (int a = 0; a < 3; ++a)
        if (a != axis && axes[at(a)].closure() == Closure::twisted) return true;
    return false;
}

// Adds the missing mirror images to inserted knots and makes nearly mirrored ones exact.
std::vector<double> symmetric(const Knots& knots, std::vector<double> inserted)
{
    const double sum = knots.begin() + knots.end(), near = 1e-9 * (knots.end() - knots.begin());
    const auto lower = [&](double t) { return std::min(t, sum - t); };
    std::ranges::sort(inserted, {}, lower);
    std::vector<double> out;
    for (std::size_t i = 0; i < inserted.size();) {
        const double t = lower(inserted[i]);
        std::size_t below = 0, above = 0;
        for (; i < inserted.size() && lower(inserted[i]) - t <= near; ++i)
            ++(inserted[i] <= sum / 2 ? below : above);
        const bool middle = sum / 2 - t <= near; // its own mirror image
        out.insert(out.end(), middle ? below + above : std::max(below, above),
                   middle ? sum / 2 : t);
        if (!middle) out.insert(out.end(), std::max(below, above), sum - t);
    }
    return out;
}

// Lists the sites between lo and hi; for a closed axis each control point once.
std::vector<double> sites_within(const Knots& knots, double lo, double hi)
{
    std::vector<double> out;
    for (int i = 0; i < knots.count(); ++i)
        if (const double t = knots.into_domain(knots.greville(i)).t; t >= lo && t <= hi)
            out.push_back(t);
    return out;
}

// Lists middles of the spans that meet [lo, hi], until the wanted number of control points has its
// sites there.
std::vector<double> middles(Knots knots, double lo, double hi, int wanted)
{
    std::vector<double> out;
    lo = std::max(lo, knots.begin());
    hi = std::min(hi, knots.end());
    for (int round = 0; round < 8 && lo < hi; ++round) {
        if (static_cast<int>(sites_within(knots, lo, hi).size()) >= wanted) break;
        std::vector<double> next;
        const std::vector<double> breaks = knots.breaks();
        for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
            if (breaks[i] < hi && breaks[i + 1] > lo)
                next.push_back((breaks[i] + breaks[i + 1]) / 2);
        knots = with_inserted(knots, next);
        out.insert(out.end(), next.begin(), next.end());
    }
    return out;
}

// Finds the parameters of the point of the volume nearest to p, starting from the control point
// nearest to it.
glm::dvec3 parameters_near(const Lattice& lattice, const glm::dvec3& p)
{
    const auto& axes = lattice.displacement.axes;
    glm::ivec3 nearest(0);
    double best = 1e300;
    for (int i = 0; i < axes[0].count(); ++i)
        for (int j = 0; j < axes[1].count(); ++j)
            for (int k = 0; k < axes[2].count(); ++k)
                if (const double d = glm::distance(control_point(lattice, i, j, k), p); d < best) {
                    best = d;
                    nearest = {i, j, k};
                }
    glm::dvec3 uvw;
    for (int a = 0; a < 3; ++a)
        uvw[a] = axes[at(a)].into_domain(axes[at(a)].greville(nearest[a])).t;
    // Newton's method runs as long as the distance decreases.
    best = 1e300;
    for (int round = 0; round < 12; ++round) {
        const Jet<glm::dvec3> f = evaluate(lattice, uvw, 1);
        const glm::dmat3 j(f.first[0], f.first[1], f.first[2]);
        const double distance = glm::distance(f.value, p), det = glm::determinant(j);
        if (!(distance < best) || !(std::abs(det) > 0)) break;
        best = distance;
        glm::dvec3 next = uvw + glm::inverse(j) * (p - f.value);
        for (int a = 0; a < 3; ++a) next[a] = axes[at(a)].into_domain(next[a]).t;
        if (!(glm::distance(evaluate(lattice, next).value, p) < best)) break;
        uvw = next;
    }
    return uvw;
}

// Returns `count` values distributed like the given sorted ones, without the ends.
std::vector<double> spread(const std::vector<double>& values, int count)
{
    std::vector<double> out;
    const double step = static_cast<double>(values.size() - 1) / (count + 1);
    for (int i = 1; i <= count; ++i) {
        const double where = step * i;
        const auto below = std::min(static_cast<std::size_t>(where), values.size() - 2);
        const double share = where - static_cast<double>(below);
        out.push_back(values[below] + share * (values[below + 1] - values[below]));
    }
    return out;
}

Knots with_fewer(const Knots& knots, int count)
{
    const auto& t = knots.values();
    if (knots.closure() == Closure::open) {
        // These are the knots inside the domain, and its ends.
        const std::vector<double> inside(t.begin() + knots.degree(),
                                         t.begin() + knots.unwrapped_count() + 1);
        std::vector<double> all(t.begin(), t.begin() + knots.order());
        const std::vector<double> kept = spread(inside, count - knots.order());
        all.insert(all.end(), kept.begin(), kept.end());
        all.insert(all.end(), t.end() - knots.order(), t.end());
        return Knots::general(knots.order(), std::move(all));
    }
    const std::vector<double> turn(t.begin() + knots.degree(),
                                   t.begin() + knots.degree() + knots.count() + 1);
    std::vector<double> period{knots.begin()};
    const std::vector<double> kept = spread(turn, count - 1);
    period.insert(period.end(), kept.begin(), kept.end());
    return Knots::closed(knots.order(), period, knots.end(), knots.closure());
}

// Returns four parameters per control point, with the ends of an open domain, symmetric if the
// knots are.
std::vector<double> samples(const Knots& knots)
{
    const std::vector<double> breaks = knots.breaks();
    const int spans = static_cast<int>(breaks.size()) - 1, each = 4 * knots.count() / spans + 1;
    std::vector<double> out;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
        for (int k = 0; k < each; ++k)
            out.push_back(breaks[i] + (breaks[i + 1] - breaks[i]) * k / each);
    if (knots.closure() == Closure::open) out.push_back(knots.end());
    return out;
}

// Returns the union of two knot vectors, with the higher multiplicity of each knot.
Knots united(const Knots& a, const Knots& b)
{
    std::vector<double> further;
    const std::vector<double> breaks = b.breaks();
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        const double t = breaks[i];
        if (t == a.begin() && a.closure() == Closure::open) continue;
        further.insert(further.end(), at(std::max(0, b.multiplicity(t) - a.multiplicity(t))), t);
    }
    return with_inserted(a, further);
}

} // namespace

AxisKnots with_images(const Lattice& lattice, AxisKnots inserted)
{
    const std::array<Knots, 3>& axes = lattice.displacement.axes;
    for (int axis = 0; axis < 3; ++axis)
        if (mirrored_by_another(axes, axis))
            inserted[at(axis)] = symmetric(axes[at(axis)], std::move(inserted[at(axis)]));
    return inserted;
}

Lattice refined(const Lattice& lattice, const AxisKnots& inserted)
{
    Lattice out = lattice;
    const AxisKnots all = with_images(lattice, inserted);
    for (int axis = 0; axis < 3; ++axis)
        if (!all[at(axis)].empty())
            out.displacement = insert_knots(out.displacement, axis, all[at(axis)]);
    return out;
}

AxisKnots knots_for_sphere(const Lattice& lattice, const glm::dvec3& center_world,
                           double radius_world, int across)
{
    const glm::dvec3 uvw = parameters_near(lattice, center_world);
    const Jet<glm::dvec3> f = evaluate(lattice, uvw, 1);
    AxisKnots out;
    for (int axis = 0; axis < 3; ++axis) {
        const Knots& knots = lattice.displacement.axes[at(axis)];
        const double speed = glm::length(f.first[at(axis)]);
        if (!(speed > 0) || !(radius_world > 0)) continue;
        // The ends of the sphere are left out: control points lie beside the line through its
        // centre.
        const double half = std::min(0.8 * radius_world / speed, knots.end() - knots.begin());
        out[at(axis)] = middles(knots, uvw[axis] - half, uvw[axis] + half, across);
    }
    return with_images(lattice, std::move(out));
}

CoarserLattice coarsened(const Lattice& lattice, int axis, int count)
{
    const Trivariate<glm::dvec3>& f = lattice.displacement;
    const Knots& from = f.axes[at(axis)];
    if (count < from.order() || count >= from.count())
        throw Rejected("an axis of order " + std::to_string(from.order()) + " with " +
                       std::to_string(from.count()) + " control points can be given " +
                       std::to_string(from.order()) + " to " + std::to_string(from.count() - 1) +
                       ", not " + std::to_string(count));
    const Knots to = with_fewer(from, count);
    const std::vector<double> parameters = samples(from);
    FitOptions options;
    options.ends = from.closure() == Closure::open &&
                   from.multiplicity(from.begin()) >= from.order() &&
                   from.multiplicity(from.end()) >= from.order();
    const std::size_t inner = points_inside(f.axes, axis);
    const std::vector<glm::dvec3> values = applied(sampling_map(from, parameters), extent(from),
                                                   std::span<const glm::dvec3>(f.points), inner);
    CoarserLattice out{lattice, 0};
    out.lattice.displacement.points = applied(least_squares_map(to, parameters, options),
                                              {static_cast<int>(parameters.size()), to.closure()},
                                              std::span<const glm::dvec3>(values), inner);
    out.lattice.displacement.axes[at(axis)] = to;
    check_shape(out.lattice.displacement);
    out.deviation = largest_difference(lattice, out.lattice);
    return out;
}

double largest_difference(const Lattice& a, const Lattice& b)
{
    ensure(a.rest == b.rest, "lattices of two boxes are compared");
    Trivariate<glm::dvec3> f = a.displacement, g = b.displacement;
    for (int axis = 0; axis < 3; ++axis) {
        if (axis_of(f, axis) == axis_of(g, axis)) continue;
        Knots both = united(axis_of(f, axis), axis_of(g, axis));
        // If the axis is not clamped, control points beyond its ends say little about the inside.
        if (both.closure() == Closure::open) both = opened(both);
        f = over_knots(f, axis, both);
        g = over_knots(g, axis, both);
    }
    double most = 0, size = 0;
    for (std::size_t i = 0; i < f.points.size(); ++i) {
        most = std::max(most, glm::distance(f.points[i], g.points[i]));
        size = std::max({size, glm::length(f.points[i]), glm::length(g.points[i])});
    }
    return most + 1e-14 * size; // bound of the rounding error
}

} // namespace trivar
