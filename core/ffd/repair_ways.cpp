// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/repair_ways.h"

#include "core/base/index.h"
#include "core/base/unit.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr double evening = 0.03;

std::vector<std::size_t> sorted_once(std::vector<std::size_t> of)
{
    std::sort(of.begin(), of.end());
    of.erase(std::unique(of.begin(), of.end()), of.end());
    return of;
}

// Returns the axes across the columns.
std::array<int, 2> across(int axis)
{
    return {axis == 0 ? 1 : 0, axis == 2 ? 1 : 2};
}

glm::dvec3 world(const Lattice& lattice, const glm::ivec3& i)
{
    return control_point(lattice, i.x, i.y, i.z);
}

// Steps from a column to its neighbour along an axis; false at an end. A periodic axis wraps; a
// twisted one ends, because the columns beyond are upside down.
bool neighbour(const Knots& axis, int& i, int step)
{
    i += step;
    if (axis.closure() == Closure::periodic) i = (i + axis.count()) % axis.count();
    return i >= 0 && i < axis.count();
}

// Moves all points of a column except the ground point to where `place` puts them.
template <class Place>
void move_column(const RepairSite& site, const Lattice& lattice, glm::ivec3 ground,
                 const Place& place, std::vector<PointMove>& moves)
{
    const int axis = site.options().column_axis;
    const auto& d = lattice.displacement;
    glm::ivec3 i = ground;
    for (i[axis] = 0; i[axis] < d.axes[at(axis)].count(); ++i[axis]) {
        if (i[axis] == ground[axis] || site.held(d.index(i.x, i.y, i.z), false)) continue;
        const glm::dvec3 p = world(lattice, i), by = place(i, p) - p;
        if (by != glm::dvec3(0)) moves.push_back({i, by});
    }
}

// Returns the normal of the ground under a column, toward the inside of the volume.
glm::dvec3 ground_normal(const Lattice& lattice, const glm::ivec3& ground, int axis, int sign)
{
    std::array<glm::dvec3, 2> along{};
    const auto axes = across(axis);
    for (std::size_t a = 0; a < 2; ++a) {
        glm::ivec3 low = ground, high = ground;
        const Knots& knots = lattice.displacement.axes[at(axes[a])];
        if (!neighbour(knots, low[axes[a]], -1)) low = ground;
        if (!neighbour(knots, high[axes[a]], 1)) high = ground;
        along[a] = world(lattice, high) - world(lattice, low);
    }
    return unit_or_zero(glm::cross(along[0], along[1]) * (axis == 1 ? -1.0 : 1.0) * double(sign));
}

// Returns the heights nearest to the given ones, in least squares, that rise by at least `gap` per
// layer from the ground (pool adjacent violators).
std::vector<double> rising(const std::vector<double>& heights, double gap)
{
    struct Pool {
        double sum;
        int count;
        double mean() const { return sum / count; }
    };
    std::vector<Pool> pools;
    for (std::size_t k = 0; k < heights.size(); ++k) {
        pools.push_back({heights[k] - gap * static_cast<double>(k + 1), 1});
        while (pools.size() > 1 && pools.back().mean() < pools[pools.size() - 2].mean()) {
            const Pool last = pools.back();
            pools.pop_back();
            pools.back().sum += last.sum;
            pools.back().count += last.count;
        }
    }
    std::vector<double> out;
    for (const Pool& pool : pools)
        for (int i = 0; i < pool.count; ++i)
            out.push_back(std::max(pool.mean(), 0.0) + gap * static_cast<double>(out.size() + 1));
    return out;
}

// A Constraint is a place in a cell where det J is too small, and the value wanted there.
struct Constraint {
    std::size_t cell;
    glm::dvec3 x; // 0 to 1
    double wanted;
};

// Lists the constraints of a cell: at 27 samples, and, if the cell is not good, at the site of its
// least coefficient. There det J is always raised, because not only det J but its coefficients must
// be positive.
std::vector<Constraint> constraints(std::size_t cell, const CellDeterminant& det,
                                    const CellVerdicts& verdicts, bool good, int pass)
{
    const Bernstein& f = det.f;
    const int sign = verdicts.sign;
    // The wanted value is a hundredth of the usual det J, and more with every pass.
    const double usual = std::clamp(sign * det.mean, 0.1 * verdicts.typical, verdicts.typical);
    const double wanted = 0.01 * (1 + (good ? 0 : std::min(pass, 40) / 8.0)) * usual;
    std::vector<Constraint> out;
    for (int k = 0; k < 27; ++k) {
        const glm::dvec3 x = glm::dvec3(k / 9, k / 3 % 3, k % 3) / 2.0;
        if (sign * value(f, x) < wanted) out.push_back({cell, x, wanted});
    }
    if (good) return out;
    const auto least = std::min_element(f.coefficients.begin(), f.coefficients.end(),
                                        [&](double a, double b) { return sign * a < sign * b; });
    const int i = static_cast<int>(least - f.coefficients.begin()), nv = f.degree[1] + 1,
              nw = f.degree[2] + 1;
    const glm::dvec3 x = glm::dvec3(i / nw / nv, i / nw % nv, i % nw) /
                         glm::dvec3(f.degree[0], f.degree[1], f.degree[2]);
    out.push_back({cell, x, std::max(wanted, 1.25 * sign * value(f, x))});
    return out;
}

// Returns the displacement that puts a point as evenly between its neighbours along each axis as
// their sites are; beyond an end, on a straight line. Axes with two points have no middle.
// Displacements suffice, because the rest map is affine.
glm::dvec3 even_place(const Trivariate<glm::dvec3>& f, const glm::ivec3& index)
{
    glm::dvec3 sum(0);
    int lines = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const Knots& knots = f.axes[at(axis)];
        if (knots.unwrapped_count() < 3) continue;
        ++lines;
        glm::ivec3 i = index;
        if (knots.closure() != Closure::open && i[axis] == 0) {
            // The same point one turn further.
            if (knots.closure() == Closure::twisted)
                for (int other = 0; other < 3; ++other)
                    i[other] = f.axes[at(other)].count() - 1 - i[other];
            i[axis] = knots.count();
        }
        // The even place is on the line through two other points: both neighbours, or the next two
        // at an end.
        const int step = i[axis] == 0 ? 1 : i[axis] + 1 == knots.unwrapped_count() ? -1 : 0;
        glm::ivec3 one = i, two = i;
        one[axis] += step == 0 ? -1 : step;
        two[axis] += step == 0 ? 1 : 2 * step;
        const double here = knots.greville(i[axis]), from = knots.greville(one[axis]),
                     to = knots.greville(two[axis]);
        const double x = to == from ? 0.5 : (here - from) / (to - from);
        sum += (1 - x) * f.point(one.x, one.y, one.z) + x * f.point(two.x, two.y, two.z);
    }
    return lines > 0 ? sum / double(lines) : f.point(index.x, index.y, index.z);
}

// Moves the points of the cell until det J is near its wanted value.
void fulfil(const RepairSite& site, const CellGrid::Place& cell,
            const std::vector<std::size_t>& points, const Constraint& c, bool ground_yields,
            int sign, Lattice& lattice)
{
    auto& f = lattice.displacement;
    const glm::dvec3 edge = cell.hi - cell.lo;
    // The place is moved off the knots, where an axis of order 2 has two slopes.
    const glm::dvec3 uvw = cell.lo + edge * glm::clamp(c.x, 0.001, 0.999);
    const std::array<Basis, 3> b{basis(f.axes[0], uvw.x, 1), basis(f.axes[1], uvw.y, 1),
                                 basis(f.axes[2], uvw.z, 1)};
    std::array<glm::dvec3, max_order * max_order * max_order> gradient;
    glm::dmat3 j(lattice.rest);
    std::size_t p = 0;
    for (std::size_t i = 0; i < at(f.axes[0].order()); ++i)
        for (std::size_t k = 0; k < at(f.axes[1].order()); ++k)
            for (std::size_t l = 0; l < at(f.axes[2].order()); ++l, ++p) {
                const glm::dvec3 n(b[0].value[i], b[1].value[k], b[2].value[l]),
                    d(b[0].first_derivative[i], b[1].first_derivative[k], b[2].first_derivative[l]);
                gradient[p] = {d.x * n.y * n.z, n.x * d.y * n.z, n.x * n.y * d.z};
                j += glm::outerProduct(f.points[points[p]], gradient[p]);
            }
    const double det = sign * glm::determinant(j);
    if (!(det < c.wanted)) return;
    const glm::dmat3 cofactor(glm::cross(j[1], j[2]), glm::cross(j[2], j[0]),
                              glm::cross(j[0], j[1]));
    double squares = 0, steepest = 0;
    for (p = 0; p < points.size(); ++p) {
        gradient[p] = cofactor * gradient[p];
        if (site.held(points[p], ground_yields)) gradient[p] = glm::dvec3(0);
        squares += glm::dot(gradient[p], gradient[p]);
        steepest = std::max(steepest, glm::length(gradient[p]));
    }
    // No point moves further than half a cell at once.
    const double furthest = 0.5 * std::cbrt(std::abs(c.wanted) * 100 * edge.x * edge.y * edge.z);
    const double step = std::min((c.wanted - det) / squares, furthest / steepest);
    if (!(step > 0) || !std::isfinite(step)) return;
    for (p = 0; p < points.size(); ++p) f.points[points[p]] += sign * step * gradient[p];
}

} // namespace

RepairSite::RepairSite(const Lattice& lattice, const RepairOptions& options)
    : options_(options),
      grid_(lattice.displacement.axes),
      count_(lattice.displacement.axes[0].count(), lattice.displacement.axes[1].count(),
             lattice.displacement.axes[2].count()),
      held_(lattice.displacement.points.size())
{
    const auto& axes = lattice.displacement.axes;
    for (std::size_t p = 0; p < held_.size(); ++p) {
        const glm::ivec3 i = index(p);
        const glm::dvec3 uvw(axes[0].greville(i.x), axes[1].greville(i.y), axes[2].greville(i.z));
        for (const Box& box : options.guard.excepted)
            if (box.distance(uvw) == 0) held_[p] = true;
        glm::ivec3 ground = i;
        ground[options.column_axis] = options.ground_layer;
        tallest_ = std::max(tallest_, glm::distance(world(lattice, i), world(lattice, ground)));
    }
}

glm::ivec3 RepairSite::index(std::size_t point) const
{
    const int i = static_cast<int>(point);
    return {i / count_.z / count_.y, i / count_.z % count_.y, i % count_.z};
}

bool RepairSite::held(std::size_t point, bool ground_yields) const
{
    return held_[point] ||
           (!ground_yields && index(point)[options_.column_axis] == options_.ground_layer);
}

std::vector<std::size_t> RepairSite::points_of(const Trivariate<glm::dvec3>& f, int cell) const
{
    const auto [u, v, w] = grid_.spans(at(cell));
    std::vector<std::size_t> out;
    for (int i = 0; i < f.axes[0].order(); ++i)
        for (int j = 0; j < f.axes[1].order(); ++j)
            for (int k = 0; k < f.axes[2].order(); ++k)
                out.push_back(static_cast<std::size_t>(
                    &f.point(u->first + i, v->first + j, w->first + k) - f.points.data()));
    return out;
}

std::vector<glm::ivec3> RepairSite::columns(const Trivariate<glm::dvec3>& f,
                                            const CellVerdicts& verdicts) const
{
    std::vector<std::size_t> grounds;
    for (const int cell : doubtful_cells(verdicts))
        for (const std::size_t p : points_of(f, cell)) {
            glm::ivec3 i = index(p);
            i[options_.column_axis] = options_.ground_layer;
            grounds.push_back(f.index(i.x, i.y, i.z));
        }
    std::vector<glm::ivec3> out;
    for (const std::size_t p : sorted_once(std::move(grounds))) out.push_back(index(p));
    return out;
}

std::vector<int> doubtful_cells(const CellVerdicts& verdicts)
{
    std::vector<int> out;
    for (std::size_t c = 0; c < verdicts.of.size(); ++c)
        if (verdicts.of[c] == Verdict::proven_bad || verdicts.of[c] == Verdict::unknown)
            out.push_back(static_cast<int>(c));
    return out;
}

std::vector<PointMove> smoothed_directions(const RepairSite& site, const Lattice& lattice,
                                           const CellVerdicts& verdicts)
{
    const int axis = site.options().column_axis;
    const auto direction = [&](glm::ivec3 i) {
        const glm::dvec3 p = world(lattice, i);
        i[axis] = site.options().ground_layer;
        return unit_or_zero(p - world(lattice, i));
    };
    std::vector<PointMove> moves;
    for (const glm::ivec3& ground : site.columns(lattice.displacement, verdicts))
        move_column(
            site, lattice, ground,
            [&](const glm::ivec3& i, const glm::dvec3& p) {
                glm::dvec3 sum = 2.0 * direction(i);
                for (const int a : across(axis))
                    for (const int step : {-1, 1}) {
                        glm::ivec3 next = i;
                        if (neighbour(lattice.displacement.axes[at(a)], next[a], step))
                            sum += direction(next);
                    }
                const double length = glm::length(sum);
                const glm::dvec3 foot = world(lattice, ground);
                return length > 0 ? foot + glm::distance(p, foot) / length * sum : p;
            },
            moves);
    return moves;
}

std::vector<PointMove> lowered_heights(const RepairSite& site, const Lattice& lattice,
                                       const CellVerdicts& verdicts, int pass)
{
    const double cap = site.tallest() * std::pow(0.93, pass);
    std::vector<PointMove> moves;
    for (const glm::ivec3& ground : site.columns(lattice.displacement, verdicts)) {
        const glm::dvec3 foot = world(lattice, ground);
        move_column(
            site, lattice, ground,
            [&](const glm::ivec3&, const glm::dvec3& p) {
                // The result rises with the height and stays below the cap; small heights hardly
                // change.
                const double share = glm::distance(p, foot) / cap;
                return foot + (p - foot) * std::pow(1 + std::pow(share, 6), -1.0 / 6);
            },
            moves);
    }
    return moves;
}

std::vector<PointMove> monotone_columns(const RepairSite& site, const Lattice& lattice,
                                        const CellVerdicts& verdicts, int pass)
{
    const int axis = site.options().column_axis, layer = site.options().ground_layer,
              layers = lattice.displacement.axes[at(axis)].count();
    std::vector<PointMove> moves;
    for (const glm::ivec3& ground : site.columns(lattice.displacement, verdicts)) {
        const glm::dvec3 foot = world(lattice, ground),
                         normal = ground_normal(lattice, ground, axis, verdicts.sign);
        const auto height = [&](int k) {
            glm::ivec3 i = ground;
            i[axis] = k;
            return glm::dot(world(lattice, i) - foot, normal);
        };
        double extent = 0;
        for (int k = 0; k < layers; ++k) extent = std::max(extent, std::abs(height(k)));
        const double gap = extent / layers * 0.02 * std::exp2(pass);
        std::vector<double> now(at(layers)), next(at(layers));
        for (int k = 0; k < layers; ++k) next[at(k)] = now[at(k)] = height(k);
        for (const int way : {1, -1}) {
            std::vector<double> side;
            for (int k = layer + way; k >= 0 && k < layers; k += way)
                side.push_back(way * now[at(k)]);
            side = rising(side, gap);
            for (std::size_t n = 0; n < side.size(); ++n)
                next[at(layer + way * static_cast<int>(n + 1))] = way * side[n];
        }
        move_column(
            site, lattice, ground,
            [&](const glm::ivec3& i, const glm::dvec3& p) {
                return p + (next[at(i[axis])] - now[at(i[axis])]) * normal;
            },
            moves);
    }
    return moves;
}

std::vector<PointMove> evened(const RepairSite& site, const Lattice& lattice,
                              const CellVerdicts& verdicts, bool ground_yields)
{
    const auto& f = lattice.displacement;
    std::vector<std::size_t> points;
    for (const int cell : doubtful_cells(verdicts)) {
        const std::vector<std::size_t> of_cell = site.points_of(f, cell);
        points.insert(points.end(), of_cell.begin(), of_cell.end());
    }
    std::vector<PointMove> moves;
    for (const std::size_t p : sorted_once(std::move(points)))
        if (!site.held(p, ground_yields)) {
            const glm::ivec3 i = site.index(p);
            moves.push_back({i, 0.5 * (even_place(f, i) - f.points[p])});
        }
    return moves;
}

std::vector<PointMove> relaxed(const RepairSite& site, const Lattice& lattice,
                               const CellVerdicts& verdicts, std::span<const int> cells, int pass,
                               bool ground_yields)
{
    std::vector<std::vector<Constraint>> of_cells(cells.size());
    each_determinant(site.grid(), lattice, cells, [&](std::size_t i, const CellDeterminant& det) {
        const bool good = verdicts.of[at(cells[i])] == Verdict::proven_good;
        of_cells[i] = constraints(at(cells[i]), det, verdicts, good, pass);
    });
    Lattice now = lattice;
    std::vector<std::size_t> touched;
    for (const std::vector<Constraint>& of_cell : of_cells) {
        if (of_cell.empty()) continue;
        const CellGrid::Place cell = site.grid().place(of_cell[0].cell);
        const std::vector<std::size_t> points =
            site.points_of(now.displacement, static_cast<int>(of_cell[0].cell));
        touched.insert(touched.end(), points.begin(), points.end());
        for (const Constraint& c : of_cell)
            fulfil(site, cell, points, c, ground_yields, verdicts.sign, now);
    }
    touched = sorted_once(std::move(touched));
    // Some smoothing keeps points that were moved for one fold from making another.
    const Trivariate<glm::dvec3> before = now.displacement;
    for (const std::size_t p : touched)
        if (!site.held(p, ground_yields))
            now.displacement.points[p] +=
                evening * (even_place(before, site.index(p)) - before.points[p]);
    std::vector<PointMove> moves;
    for (const std::size_t p : touched)
        if (const glm::dvec3 by = now.displacement.points[p] - lattice.displacement.points[p];
            by != glm::dvec3(0))
            moves.push_back({site.index(p), by});
    return moves;
}

} // namespace trivar
