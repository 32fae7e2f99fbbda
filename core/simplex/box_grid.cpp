// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/box_grid.h"

#include "core/base/rejected.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

template <int S, class Body>
void each_cell(const glm::vec<S, int>& from, const glm::vec<S, int>& to, const Body& body)
{
    glm::vec<S, int> at = from;
    for (;;) {
        body(at);
        int axis = S - 1;
        while (axis >= 0 && at[axis] == to[axis]) {
            at[axis] = from[axis];
            --axis;
        }
        if (axis < 0) return;
        ++at[axis];
    }
}

// Boxes that touch more of the grid than this, as cells of a domain never do, lie over each other.
constexpr std::size_t most_touched_per_box = 64, most_touched_of_few = 1'000'000;

} // namespace

template <int S> BoxGrid<S>::BoxGrid(std::span<const CellBox<S>> boxes)
{
    if (boxes.empty()) return;
    glm::vec<S, double> lo = boxes[0].lo, hi = boxes[0].hi;
    for (const CellBox<S>& box : boxes) {
        lo = glm::min(lo, box.lo);
        hi = glm::max(hi, box.hi);
    }
    const double most = std::min(2.0 * static_cast<double>(boxes.size()), 1e7);
    glm::vec<S, double> extent = hi - lo;
    double largest = 0, volume = 1;
    for (int i = 0; i < S; ++i) largest = std::max(largest, extent[i]);
    for (int i = 0; i < S; ++i) volume *= std::max(extent[i], 1e-3 * largest);
    const double side = std::pow(volume / most, 1.0 / S);
    origin_ = lo;
    std::size_t count = 1;
    for (int i = 0; i < S; ++i) {
        size_[i] = std::clamp(static_cast<int>(std::lround(extent[i] / side)), 1, 4096);
        per_unit_[i] = extent[i] > 0 ? size_[i] / extent[i] : 0;
        count *= static_cast<std::size_t>(size_[i]);
    }
    std::size_t touched = 0;
    for (const CellBox<S>& box : boxes) {
        const glm::vec<S, int> cells = cell_of(box.hi) - cell_of(box.lo) + 1;
        std::size_t of_box = 1;
        for (int i = 0; i < S; ++i) of_box *= static_cast<std::size_t>(cells[i]);
        touched += of_box;
    }
    if (touched > most_touched_per_box * boxes.size() + most_touched_of_few)
        throw Rejected("Too many cells of the domain lie over each other.");
    begin_.assign(count + 1, 0);
    for (const CellBox<S>& box : boxes)
        each_cell<S>(cell_of(box.lo), cell_of(box.hi),
                     [&](const glm::vec<S, int>& cell) { ++begin_[index(cell) + 1]; });
    for (std::size_t i = 1; i <= count; ++i) begin_[i] += begin_[i - 1];
    boxes_.resize(static_cast<std::size_t>(begin_.back()));
    std::vector<std::int32_t> next(begin_.begin(), begin_.end() - 1);
    for (std::size_t b = 0; b < boxes.size(); ++b)
        each_cell<S>(cell_of(boxes[b].lo), cell_of(boxes[b].hi), [&](const glm::vec<S, int>& cell) {
            boxes_[static_cast<std::size_t>(next[index(cell)]++)] = static_cast<std::int32_t>(b);
        });
}

template <int S> glm::vec<S, int> BoxGrid<S>::cell_of(const glm::vec<S, double>& x) const
{
    glm::vec<S, int> out;
    for (int i = 0; i < S; ++i)
        out[i] = static_cast<int>(
            std::clamp((x[i] - origin_[i]) * per_unit_[i], 0.0, static_cast<double>(size_[i] - 1)));
    return out;
}

template <int S> std::size_t BoxGrid<S>::index(const glm::vec<S, int>& cell) const
{
    std::size_t out = 0;
    for (int i = 0; i < S; ++i)
        out = out * static_cast<std::size_t>(size_[i]) + static_cast<std::size_t>(cell[i]);
    return out;
}

template <int S>
std::span<const std::int32_t> BoxGrid<S>::boxes_at(const glm::vec<S, double>& x) const
{
    for (int i = 0; i < S; ++i) // false for what is not a number, too
        if (!((x[i] - origin_[i]) * per_unit_[i] >= 0 &&
              (x[i] - origin_[i]) * per_unit_[i] <= size_[i]))
            return {};
    if (begin_.empty()) return {};
    const std::size_t cell = index(cell_of(x));
    return std::span(boxes_).subspan(static_cast<std::size_t>(begin_[cell]),
                                     static_cast<std::size_t>(begin_[cell + 1] - begin_[cell]));
}

template class BoxGrid<2>;
template class BoxGrid<3>;

} // namespace trivar
