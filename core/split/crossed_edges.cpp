// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/crossed_edges.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace trivar {
namespace {

constexpr double least_share_of_heights = 2e-4; // of that at the other end of an edge

// One end of an edge, and the other one.
struct EdgeEnd {
    std::uint32_t point;
    std::size_t edge, end;
};

} // namespace

void move_apart(std::span<CrossedEdge> edges)
{
    const auto least = [](double other) {
        return std::max(least_share_of_heights * std::abs(other),
                        std::numeric_limits<double>::min());
    };
    // Only those of points with a height near 0
    std::vector<std::uint32_t> near;
    for (const CrossedEdge& e : edges)
        for (std::size_t i = 0; i < 2; ++i)
            if (std::abs(e.heights[i]) < least(e.heights[1 - i])) near.push_back(e.points[i]);
    if (near.empty()) return;
    std::ranges::sort(near);
    near.erase(std::unique(near.begin(), near.end()), near.end());
    std::vector<EdgeEnd> ends;
    for (std::size_t k = 0; k < edges.size(); ++k)
        for (std::size_t i = 0; i < 2; ++i)
            if (std::ranges::binary_search(near, edges[k].points[i]))
                ends.push_back({edges[k].points[i], k, i});
    std::ranges::stable_sort(ends, {}, &EdgeEnd::point);

    // A height that was moved may ask for that of the other end, by a share of a share
    for (bool moved = true; moved;) {
        moved = false;
        for (std::size_t begin = 0, end = 0; begin < ends.size(); begin = end) {
            double apart = 0;
            for (; end < ends.size() && ends[end].point == ends[begin].point; ++end)
                apart = std::max(apart, least(edges[ends[end].edge].heights[1 - ends[end].end]));
            const double height = edges[ends[begin].edge].heights[ends[begin].end];
            if (std::abs(height) >= apart) continue;
            moved = true;
            for (std::size_t k = begin; k < end; ++k)
                edges[ends[k].edge].heights[ends[k].end] = height >= 0 ? apart : -apart;
        }
    }
}

} // namespace trivar
