// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spline/box_tree.h"

#include <algorithm>
#include <numeric>

namespace trivar {

BoxTree::BoxTree(const std::vector<Box>& boxes)
{
    std::vector<int> order(boxes.size());
    std::iota(order.begin(), order.end(), 0);
    nodes_.reserve(2 * boxes.size());
    if (!order.empty()) build(boxes, order.begin(), order.end());
}

int BoxTree::build(const std::vector<Box>& boxes, std::vector<int>::iterator begin,
                   std::vector<int>::iterator end)
{
    Node node;
    for (auto i = begin; i != end; ++i) node.bounds.add(boxes[static_cast<std::size_t>(*i)]);
    const int here = static_cast<int>(nodes_.size());
    if (end - begin == 1) {
        node.box = *begin;
        nodes_.push_back(node);
        return here;
    }
    nodes_.push_back(node);
    // Splits at the median of the box centres across the longest side.
    const glm::dvec3 size = node.bounds.hi - node.bounds.lo;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const auto middle = [&](int i) {
        const Box& b = boxes[static_cast<std::size_t>(i)];
        return b.lo[axis] + b.hi[axis];
    };
    const auto half = begin + (end - begin) / 2;
    std::nth_element(begin, half, end, [&](int a, int b) {
        return middle(a) != middle(b) ? middle(a) < middle(b) : a < b;
    });
    build(boxes, begin, half);
    const int second = build(boxes, half, end);
    nodes_[static_cast<std::size_t>(here)].second = second;
    return here;
}

std::vector<int> BoxTree::boxes_in(auto&& wanted) const
{
    std::vector<int> found, open;
    if (!nodes_.empty()) open.push_back(0);
    while (!open.empty()) {
        const int i = open.back();
        const Node& node = nodes_[static_cast<std::size_t>(i)];
        open.pop_back();
        if (!wanted(node.bounds)) continue;
        if (node.box >= 0)
            found.push_back(node.box);
        else
            open.insert(open.end(), {node.second, i + 1});
    }
    std::sort(found.begin(), found.end());
    return found;
}

std::vector<int> BoxTree::near(const glm::dvec3& p, double distance) const
{
    return boxes_in([&](const Box& bounds) { return bounds.distance(p) <= distance; });
}

std::vector<int> BoxTree::touching(const Box& box) const
{
    return boxes_in([&](const Box& bounds) { return !bounds.apart(box); });
}

double BoxTree::distance(const glm::dvec3& p) const
{
    double best = 1e300;
    std::vector<int> open;
    if (!nodes_.empty()) open.push_back(0);
    while (!open.empty()) {
        const int i = open.back();
        const Node& node = nodes_[static_cast<std::size_t>(i)];
        open.pop_back();
        const double here = node.bounds.distance(p);
        if (!(here < best)) continue;
        if (node.box >= 0)
            best = here;
        else
            open.insert(open.end(), {node.second, i + 1});
    }
    return best;
}

} // namespace trivar
