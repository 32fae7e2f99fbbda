// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spline/bezier_cell.h"

#include "core/base/index.h"

namespace trivar {
namespace {

using Row = std::array<double, max_order>;

// Computes the Bernstein polynomials of one order at x, and their derivatives.
struct Bernstein {
    Row value{1}, derivative{};
};
Bernstein bernstein(int order, double x)
{
    Bernstein b;
    for (int p = 1; p < order; ++p) {
        if (p == order - 1)
            for (int r = 0; r <= p; ++r)
                b.derivative[at(r)] =
                    p * ((r > 0 ? b.value[at(r - 1)] : 0) - (r < p ? b.value[at(r)] : 0));
        for (int r = p; r >= 0; --r)
            b.value[at(r)] =
                (r < p ? b.value[at(r)] * (1 - x) : 0) + (r > 0 ? b.value[at(r - 1)] * x : 0);
    }
    return b;
}

} // namespace

std::vector<BezierCell> bezier_cells(const Trivariate<glm::dvec3>& f)
{
    const Trivariate<glm::dvec3> form = bezier_form(f);
    std::array<std::vector<BezierSpan>, 3> spans;
    for (std::size_t a = 0; a < 3; ++a) spans[a] = bezier_spans(form.axes[a]);
    const glm::ivec3 orders(form.axes[0].order(), form.axes[1].order(), form.axes[2].order());
    std::vector<BezierCell> out;
    for (const BezierSpan& u : spans[0])
        for (const BezierSpan& v : spans[1])
            for (const BezierSpan& w : spans[2]) {
                BezierCell cell{orders, {u.lo, v.lo, w.lo}, {u.hi, v.hi, w.hi}, {}};
                for (int i = 0; i < orders.x; ++i)
                    for (int j = 0; j < orders.y; ++j)
                        for (int k = 0; k < orders.z; ++k)
                            cell.points.push_back(
                                form.point(u.first + i, v.first + j, w.first + k));
                out.push_back(std::move(cell));
            }
    return out;
}

CellValue evaluate(const BezierCell& cell, const glm::dvec3& x)
{
    const Bernstein u = bernstein(cell.orders.x, x.x), v = bernstein(cell.orders.y, x.y),
                    w = bernstein(cell.orders.z, x.z);
    CellValue out;
    const glm::dvec3* p = cell.points.data();
    for (int i = 0; i < cell.orders.x; ++i) {
        // Contracts over w, then over v: the value of the plane and its slopes along v and w.
        glm::dvec3 plane(0), plane_v(0), plane_w(0);
        for (int j = 0; j < cell.orders.y; ++j) {
            glm::dvec3 line(0), line_w(0);
            for (int k = 0; k < cell.orders.z; ++k, ++p) {
                line += *p * w.value[at(k)];
                line_w += *p * w.derivative[at(k)];
            }
            plane += line * v.value[at(j)];
            plane_v += line * v.derivative[at(j)];
            plane_w += line_w * v.value[at(j)];
        }
        out.value += plane * u.value[at(i)];
        out.jacobian[0] += plane * u.derivative[at(i)];
        out.jacobian[1] += plane_v * u.value[at(i)];
        out.jacobian[2] += plane_w * u.value[at(i)];
    }
    return out;
}

BezierCell part_of(const BezierCell& cell, const glm::dvec3& lo, const glm::dvec3& hi)
{
    BezierCell out = cell;
    out.lo = cell.lo + (cell.hi - cell.lo) * lo;
    out.hi = cell.lo + (cell.hi - cell.lo) * hi;
    std::size_t inner = cell.points.size();
    for (int axis = 0; axis < 3; ++axis) {
        const int order = cell.orders[axis];
        inner /= at(order);
        const auto matrix = bezier_segment(order, lo[axis], hi[axis]);
        AxisMap map{order, std::vector<int>(at(order), 0), {}};
        map.weights.assign(matrix.begin(), matrix.begin() + order * order);
        out.points =
            applied(map, {order, Closure::open}, std::span<const glm::dvec3>(out.points), inner);
    }
    return out;
}

Box bounds(const BezierCell& cell)
{
    Box out;
    for (const glm::dvec3& p : cell.points) out.add(p);
    return out;
}

} // namespace trivar
