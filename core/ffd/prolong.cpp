// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/prolong.h"

#include "core/base/index.h"
#include "core/base/mistake.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

std::ptrdiff_t slice_size(const Trivariate<glm::dvec3>& f)
{
    return std::ssize(f.points) / f.axes[0].count();
}

// Exchanges u and another axis of the function.
Trivariate<glm::dvec3> exchanged(Trivariate<glm::dvec3> f, int axis)
{
    if (axis == 0) return f;
    Trivariate<glm::dvec3> out{f.axes, std::vector<glm::dvec3>(f.points.size())};
    std::swap(out.axes[0], out.axes[at(axis)]);
    for (int i = 0; i < out.axes[0].count(); ++i)
        for (int j = 0; j < out.axes[1].count(); ++j)
            for (int k = 0; k < out.axes[2].count(); ++k) {
                glm::ivec3 from(i, j, k);
                std::swap(from[0], from[axis]);
                out.points[out.index(i, j, k)] = f.points[f.index(from.x, from.y, from.z)];
            }
    return out;
}

// Reverses u: F(-u).
Trivariate<glm::dvec3> mirrored(const Trivariate<glm::dvec3>& f)
{
    std::vector<double> knots = f.axes[0].values();
    std::ranges::reverse(knots);
    for (double& t : knots) t = -t;
    Trivariate<glm::dvec3> out{{Knots::general(f.axes[0].order(), knots), f.axes[1], f.axes[2]},
                               f.points};
    const std::ptrdiff_t size = slice_size(f), count = f.axes[0].count();
    for (std::ptrdiff_t i = 0; i < count; ++i)
        std::copy_n(f.points.begin() + i * size, size, out.points.begin() + (count - 1 - i) * size);
    return out;
}

// Extends the function beyond its end along u by a straight piece. Control points are blossoms at
// `degree` consecutive knots (Ramshaw 1989). If the end becomes a knot of multiplicity degree - 1,
// which leaves one continuous derivative, the last control point is replaced by those of the
// straight piece: P + (mean of the knots - end) F'.
Trivariate<glm::dvec3> prolonged_end(const Trivariate<glm::dvec3>& f, double to)
{
    const Knots& axis = f.axes[0];
    const double end = axis.end();
    if (!(to > end)) return f;
    const int degree = axis.degree();
    const std::ptrdiff_t size = slice_size(f);
    std::vector<double> knots = axis.values();
    const double before = knots[static_cast<std::size_t>(axis.count() - 1)];
    knots.resize(knots.size() - 2);
    knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, to);
    Trivariate<glm::dvec3> out{{Knots::general(axis.order(), knots), f.axes[1], f.axes[2]},
                               {f.points.begin(), f.points.end() - size}};
    const auto last = f.points.end() - size, previous = last - size;
    for (int n = 1; n <= degree; ++n) // n: number of knots at `to`
        for (std::ptrdiff_t s = 0; s < size; ++s) {
            const glm::dvec3 slope = (last[s] - previous[s]) * (degree / (end - before));
            out.points.push_back(last[s] + slope * ((to - end) * n / degree));
        }
    return out;
}

} // namespace

Lattice prolonged(const Lattice& lattice, int axis, double from, double to)
{
    const Knots& knots = lattice.displacement.axes[at(axis)];
    ensure(knots.closure() == Closure::open, "a ring has no end to prolong");
    Trivariate<glm::dvec3> f = exchanged(lattice.displacement, axis);
    if (from < knots.begin()) f = mirrored(prolonged_end(mirrored(f), -from));
    return {exchanged(prolonged_end(f, to), axis), lattice.rest};
}

Lattice prolonged_round(const Lattice& lattice, const Box& uvw)
{
    constexpr double step = 0.25; // relative to the domain
    Lattice out = lattice;
    if (uvw.empty()) return out;
    for (int axis = 0; axis < 3; ++axis) {
        const Knots knots = lattice.displacement.axes[at(axis)];
        if (knots.closure() != Closure::open) continue;
        const double begin = knots.begin(), end = knots.end(), width = step * (end - begin);
        const Reach near = reach(knots); // a point outside by rounding counts as inside
        const double before = std::max(0.0, near.least - uvw.lo[axis]),
                     behind = std::max(0.0, uvw.hi[axis] - near.most);
        out = prolonged(out, axis, begin - std::ceil(before / width) * width,
                        end + std::ceil(behind / width) * width);
    }
    return out;
}

Lattice twice_round(const Lattice& lattice)
{
    const Trivariate<glm::dvec3>& f = lattice.displacement;
    const Knots& axis = f.axes[0];
    ensure(axis.closure() == Closure::open, "an axis is closed");
    std::vector<double> knots(axis.values().begin(), axis.values().end() - 1);
    for (std::size_t i = static_cast<std::size_t>(axis.order()); i < axis.values().size(); ++i)
        knots.push_back(axis.values()[i] + (axis.end() - axis.begin()));
    Lattice out{{{Knots::general(axis.order(), knots), f.axes[1], f.axes[2]}, f.points},
                lattice.rest};
    out.displacement.points.insert(out.displacement.points.end(), f.points.begin() + slice_size(f),
                                   f.points.end());
    return out;
}

} // namespace trivar
