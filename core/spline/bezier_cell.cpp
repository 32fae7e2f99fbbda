// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spline/bezier_cell.h"

#include "core/base/index.h"

namespace trivar {

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
