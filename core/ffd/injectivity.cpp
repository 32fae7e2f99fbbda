// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/injectivity.h"

#include "core/base/parallel.h"
#include "core/ffd/bernstein.h"
#include "core/spline/bezier_cell.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace trivar {
namespace {

using Vectors = std::vector<glm::dvec3>;

// F in every cell, as control points in world space.
std::vector<BezierCell> world_cells(const Lattice& lattice)
{
    std::vector<BezierCell> cells = bezier_cells(lattice.displacement);
    for (BezierCell& cell : cells) {
        auto p = cell.points.begin();
        const glm::dvec3 steps(cell.orders - 1), edge = cell.hi - cell.lo;
        for (int i = 0; i < cell.orders.x; ++i)
            for (int j = 0; j < cell.orders.y; ++j)
                for (int k = 0; k < cell.orders.z; ++k) {
                    const glm::dvec3 uvw = cell.lo + edge * glm::dvec3(i, j, k) / steps;
                    *p++ += glm::dvec3(lattice.rest * glm::dvec4(uvw, 1));
                }
    }
    return cells;
}

// The Bernstein coefficients of the derivative of F by u, v or w.
struct Slope {
    std::array<int, 3> degree{};
    Vectors coefficients;
};

Slope slope(const BezierCell& cell, int axis)
{
    Slope out;
    glm::ivec3 step(0), size = cell.orders;
    step[axis] = 1;
    size -= step;
    for (int a = 0; a < 3; ++a) out.degree[static_cast<std::size_t>(a)] = size[a] - 1;
    const double factor = (cell.orders[axis] - 1) / (cell.hi[axis] - cell.lo[axis]);
    const auto point = [&](glm::ivec3 i) {
        return cell
            .points[static_cast<std::size_t>((i.x * cell.orders.y + i.y) * cell.orders.z + i.z)];
    };
    for (int i = 0; i < size.x; ++i)
        for (int j = 0; j < size.y; ++j)
            for (int k = 0; k < size.z; ++k) {
                const glm::ivec3 at(i, j, k);
                out.coefficients.push_back(factor * (point(at + step) - point(at)));
            }
    return out;
}

Bernstein component(const Slope& s, int c)
{
    Bernstein out{s.degree, {}};
    for (const glm::dvec3& p : s.coefficients) out.coefficients.push_back(p[c]);
    return out;
}

double largest(const Slope& s)
{
    double most = 0;
    for (const glm::dvec3& p : s.coefficients) most = std::max(most, glm::length(p));
    return most;
}

struct Determinant {
    Bernstein f;
    double doubt = 0; // of every coefficient, by rounding
};

Determinant determinant(const BezierCell& cell)
{
    const Slope u = slope(cell, 0), v = slope(cell, 1), w = slope(cell, 2);
    std::array<Bernstein, 3> left, cross;
    for (int c = 0; c < 3; ++c) {
        const int d = (c + 1) % 3, e = (c + 2) % 3;
        left[static_cast<std::size_t>(c)] = component(u, c);
        cross[static_cast<std::size_t>(c)] = difference_of_products(
            component(v, d), component(w, e), component(v, e), component(w, d));
    }
    // A coefficient is a mean, with positive weights, of products of three; each carries a few
    // hundred roundings of 1e-16.
    return {sum_of_products(left, cross), 1e-12 * largest(u) * largest(v) * largest(w)};
}

Verdict verdict_of(const Bernstein& f, double sign, double doubt)
{
    const std::vector<double>& c = f.coefficients;
    if (std::all_of(c.begin(), c.end(), [&](double x) { return sign * x > doubt; }))
        return Verdict::proven_good;
    const std::size_t nv = static_cast<std::size_t>(f.degree[1]) + 1,
                      nw = static_cast<std::size_t>(f.degree[2]) + 1;
    for (const std::size_t i : {std::size_t{0}, c.size() / (nv * nw) - 1})
        for (const std::size_t j : {std::size_t{0}, nv - 1})
            for (const std::size_t k : {std::size_t{0}, nw - 1})
                if (sign * c[(i * nv + j) * nw + k] < -doubt) return Verdict::proven_bad;
    return Verdict::unknown;
}

std::vector<Injectivity::Part> doubtful_parts(const BezierCell& cell, const Determinant& det,
                                              double sign, int depth)
{
    struct Box {
        Bernstein f;
        glm::dvec3 lo, hi;
        int halvings;
    };
    // A zero of det J costs boxes along a whole surface; this many show where it is.
    constexpr int budget = 512;
    std::vector<Injectivity::Part> out;
    std::vector<Box> open{{det.f, cell.lo, cell.hi, 0}};
    for (int used = 0; !open.empty(); ++used) {
        const Box box = std::move(open.back());
        open.pop_back();
        const Verdict verdict = verdict_of(box.f, sign, det.doubt);
        if (verdict == Verdict::proven_good) continue;
        const bool finite = std::isfinite(mean(box.f));
        if (verdict == Verdict::proven_bad || box.halvings == 3 * depth || used >= budget ||
            !finite) {
            out.push_back({box.lo, box.hi, verdict});
            continue;
        }
        const int axis = box.halvings % 3;
        const std::array<Bernstein, 2> half = halves(box.f, static_cast<std::size_t>(axis));
        glm::dvec3 middle_lo = box.lo, middle_hi = box.hi;
        middle_lo[axis] = middle_hi[axis] = (box.lo[axis] + box.hi[axis]) / 2;
        open.push_back({half[1], middle_lo, box.hi, box.halvings + 1});
        open.push_back({half[0], box.lo, middle_hi, box.halvings + 1});
    }
    return out;
}

// A map may jump where a knot is repeated `order` times.
bool continuous_over_a_box(const std::array<Knots, 3>& axes)
{
    return std::all_of(axes.begin(), axes.end(), [](const Knots& axis) {
        const auto& k = axis.values();
        const auto order = static_cast<std::size_t>(axis.order());
        for (std::size_t i = order; i + order < k.size(); ++i)
            if (k[i] > axis.begin() && k[i] < axis.end() && k[i] == k[i + order - 1]) return false;
        return axis.closure() == Closure::open;
    });
}

// F(x) - F(y) = A (I + E)(x - y) with |E| < 1, where A is the mean of J: then only x = y meet.
bool nearly_affine(const std::vector<BezierCell>& cells)
{
    glm::dmat3 a(0);
    for (const BezierCell& cell : cells)
        for (int axis = 0; axis < 3; ++axis) {
            const Slope s = slope(cell, axis);
            for (const glm::dvec3& p : s.coefficients)
                a[axis] += p / static_cast<double>(s.coefficients.size() * cells.size());
        }
    const double volume = glm::determinant(a);
    if (!(std::abs(volume) > 0) || !std::isfinite(volume)) return false;
    const glm::dmat3 inverse = glm::inverse(a);
    glm::dvec3 worst(0);
    for (const BezierCell& cell : cells)
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 unit(0);
            unit[axis] = 1;
            for (const glm::dvec3& p : slope(cell, axis).coefficients) {
                const double off = glm::length(inverse * p - unit);
                if (!(off <= worst[axis])) worst[axis] = off;
            }
        }
    return glm::length(worst) < 1 - 1e-9;
}

} // namespace

double smallest_jacobian(const Lattice& lattice, int samples)
{
    assert(samples >= 2);
    double least = std::numeric_limits<double>::infinity();
    for (const BezierCell& cell : world_cells(lattice))
        for (int i = 0; i < samples; ++i)
            for (int j = 0; j < samples; ++j)
                for (int k = 0; k < samples; ++k) {
                    const glm::dvec3 x = glm::dvec3(i, j, k) / static_cast<double>(samples - 1);
                    glm::dmat3 jacobian = evaluate(cell, x).jacobian;
                    for (int a = 0; a < 3; ++a) jacobian[a] /= cell.hi[a] - cell.lo[a];
                    least = std::min(least, glm::determinant(jacobian));
                }
    return least;
}

Injectivity check_injectivity(const Lattice& lattice, int depth)
{
    const std::vector<BezierCell> cells = world_cells(lattice);
    // Determinants are kept only where they need halving: they are large.
    std::vector<double> volumes(cells.size());
    std::vector<int> signs(cells.size());
    parallel_blocks(cells.size(), 4, [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = begin; c < end; ++c) {
            const Determinant det = determinant(cells[c]);
            const glm::dvec3 edge = cells[c].hi - cells[c].lo;
            volumes[c] = mean(det.f) * edge.x * edge.y * edge.z;
            if (verdict_of(det.f, 1, det.doubt) == Verdict::proven_good) signs[c] = 1;
            if (verdict_of(det.f, -1, det.doubt) == Verdict::proven_good) signs[c] = -1;
        }
    });
    double volume = 0;
    for (const double v : volumes) volume += v;
    const int sign = volume < 0 ? -1 : 1;

    std::vector<std::vector<Injectivity::Part>> parts(cells.size());
    parallel_blocks(cells.size(), 1, [&](std::size_t c, std::size_t) {
        if (signs[c] == sign) return;
        parts[c] =
            signs[c] == -sign
                ? std::vector<Injectivity::Part>{{cells[c].lo, cells[c].hi, Verdict::proven_bad}}
                : doubtful_parts(cells[c], determinant(cells[c]), sign, depth);
    });
    Injectivity out;
    for (const auto& of_cell : parts)
        out.parts.insert(out.parts.end(), of_cell.begin(), of_cell.end());
    for (const Injectivity::Part& part : out.parts)
        if (out.local != Verdict::proven_bad) out.local = part.verdict;
    out.global = continuous_over_a_box(lattice.displacement.axes) && nearly_affine(cells);
    return out;
}

} // namespace trivar
