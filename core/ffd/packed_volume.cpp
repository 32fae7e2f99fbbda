// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/packed_volume.h"

#include "core/base/index.h"
#include "core/base/rejected.h"
#include "core/base/single_precision.h"
#include "core/ffd/axis_cells.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <optional>
#include <string>

namespace trivar {
namespace {

glm::vec4 first_four(const std::array<double, max_order>& row)
{
    return {row[0], row[1], row[2], row[3]};
}

// Makes the cells of the axis for functions of one order less: its knots without the first and the
// last. None if they would be C^-1.
std::optional<AxisCells> lower_cells(const Knots& knots)
{
    const std::vector<double>& t = knots.values();
    for (std::size_t i = 1; i + at(knots.order()) < t.size(); ++i)
        if (t[i] == t[i + at(knots.order()) - 1]) return {};
    return AxisCells(Knots::general(knots.order() - 1, {t.begin() + 1, t.end() - 1}));
}

// Fills rows 5 to 9, see core/kernel/raised.glsl.
void pack_raised(const Knots& knots, const AxisCells::Cell& cell, const AxisCells::Cell* lower,
                 glm::vec4* rows)
{
    rows[5] = {1, 0, 0, 0}; // order 1
    const double width = cell.per_unit > 0 ? 1 / cell.per_unit : 0;
    for (int r = 0; r + 1 < knots.order(); ++r) {
        const double begin = knots.values()[at(cell.first + 1 + r)],
                     length = knots.values()[at(cell.first + knots.order() + r)] - begin;
        rows[8][r] = static_cast<float>((cell.center - begin) / length);
        rows[9][r] = static_cast<float>(width / length);
    }
    if (lower == nullptr) return;
    for (int m = 0; m + 1 < knots.order(); ++m) rows[5 + m] = first_four(lower->power[at(m)]);
}

// Adds an axis to the table.
void pack_axis(PackedAxes& out, std::size_t axis, const Knots& knots)
{
    const AxisCells cells(knots);
    const std::optional<AxisCells> lower =
        knots.order() > 2 ? lower_cells(knots) : std::optional<AxisCells>();
    out.raisable = out.raisable && (lower || knots.order() == 2);
    out.order[axis] = knots.order();
    out.cell_begin[axis] = static_cast<int>(out.cells.size()) / cell_rows;
    out.cell_count[axis] = static_cast<int>(cells.count());
    const double length = knots.end() - knots.begin();
    const auto x = [&](double t) { return (t - knots.begin()) / length - 0.5; };
    std::vector<double> begins = knots.breaks();
    begins.insert(begins.begin(), knots.begin());
    for (std::uint32_t c = 0; c < cells.count(); ++c) {
        std::array<glm::vec4, cell_rows> rows{};
        const AxisCells::Cell& cell = cells[c];
        rows[0] = {x(begins[c]), x(cell.center), cell.per_unit * length, cell.first};
        for (int m = 0; m < knots.order(); ++m) rows[at(1 + m)] = first_four(cell.power[at(m)]);
        pack_raised(knots, cell, lower ? &(*lower)[c] : nullptr, rows.data());
        out.cells.insert(out.cells.end(), rows.begin(), rows.end());
    }
}

// Returns the largest absolute value of an entry.
double largest_entry(const glm::dmat3& m)
{
    double most = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) most = std::max(most, std::abs(m[i][j]));
    return most;
}

// Returns a power of two that scales entries of J of about this size to near 1.
float scale_for(double size)
{
    return size > 0 && std::isfinite(size) ? std::ldexp(1.0f, -std::ilogb(size)) : 1.0f;
}

} // namespace

PackedAxes packed_axes(const std::array<Knots, 3>& axes)
{
    PackedAxes out;
    for (std::size_t a = 0; a < 3; ++a) {
        if (axes[a].order() > 4)
            throw Rejected("order " + std::to_string(axes[a].order()) +
                           " is evaluated by the processor: the graphics card does 2 to 4");
        pack_axis(out, a, axes[a]);
    }
    return out;
}

std::vector<glm::vec4> packed_points(const Trivariate<glm::dvec3>& f)
{
    const int nu = f.axes[0].unwrapped_count(), nv = f.axes[1].unwrapped_count(),
              nw = f.axes[2].unwrapped_count();
    std::vector<glm::vec4> out;
    out.reserve(at(nu) * at(nv) * at(nw));
    for (int i = 0; i < nu; ++i)
        for (int j = 0; j < nv; ++j)
            for (int k = 0; k < nw; ++k) out.emplace_back(f.point(i, j, k), 0);
    return out;
}

VolumeFrame volume_frame(const Lattice& lattice, const PackedAxes& packed,
                         const Embedding& embedding, const Box& object,
                         const glm::dvec3& origin_world)
{
    const std::array<Knots, 3>& axes = lattice.displacement.axes;
    VolumeFrame out;
    out.stride = {axes[1].unwrapped_count() * axes[2].unwrapped_count(), axes[2].unwrapped_count(),
                  0, 0};
    const glm::dvec3 middle(in_single_precision(object.empty() ? glm::dvec3(0) : object.center()));
    const glm::dvec4 at_middle = embedding.to_uvw * glm::dvec4(middle, 1);
    glm::dmat4 x_by_p(1);
    double steepest = 0;
    for (int a = 0; a < 3; ++a) {
        const Knots& knots = axes[at(a)];
        const double length = knots.end() - knots.begin();
        for (int i = 0; i < 3; ++i) x_by_p[i][a] = embedding.to_uvw[i][a] / length;
        double x = (at_middle[a] - knots.begin()) / length - 0.5;
        const double turns = knots.closure() == Closure::twisted ? 2 : 1;
        if (knots.closure() != Closure::open) x -= turns * std::round(x / turns);
        x_by_p[3][a] = x;
        out.cell_begin[a] = packed.cell_begin[at(a)];
        out.cell_count[a] = packed.cell_count[at(a)];
        out.closure[a] = static_cast<int>(knots.closure());
        steepest = std::max(steepest, largest_entry(glm::dmat3(x_by_p)) * out.cell_count[a]);
    }
    out.x_by_p = x_by_p;
    out.x_middle = glm::vec4(middle, 0);

    // If the rest map is a shift and the object is near its origin, no offset is subtracted and
    // added again: an untouched lattice then returns the same bits.
    const bool shift = glm::dmat3(embedding.to_rest) == glm::dmat3(1);
    const double extent = object.empty() ? 0 : glm::length(object.size());
    const bool near_origin = shift && glm::length(middle) < 4 * extent;
    const glm::dvec3 taken_off = near_origin ? glm::dvec3(0) : middle;
    glm::dmat4 rest = glm::translate(embedding.to_rest, taken_off);
    rest[3] -= glm::dvec4(origin_world, 0);
    out.rest_by_p = rest;
    out.rest_middle = glm::vec4(taken_off, 0);

    double displaced = 0;
    for (const glm::dvec3& d : lattice.displacement.points)
        displaced = std::max(displaced, glm::length(d));
    out.jacobian_scale =
        scale_for(largest_entry(glm::dmat3(embedding.to_rest)) + displaced * steepest);
    // This step is best in single precision: smaller ones lose digits, larger ones lose the slope.
    out.difference_step = static_cast<float>(1e-4 * extent);
    return out;
}

} // namespace trivar
