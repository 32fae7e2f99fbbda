// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limit/chart_surface.h"
#include "core/limit/surface_point.h"

namespace trivar {

// SharedNodes numbers the nodes of a grid on every chart, so that a node that charts share has one
// number: at their corners, along their edges, and all along an edge that is a single point. Asking
// costs O(1).
class SharedNodes {
public:
    // `counts` holds the number of intervals along u and along v of each chart, equal on both sides
    // of every edge. O(#charts).
    SharedNodes(const ChartNet& net, std::vector<glm::ivec2> counts);

    std::uint32_t size() const { return size_; }
    const glm::ivec2& counts(std::uint32_t chart) const { return counts_[chart]; }
    // i along u and j along v, from 0 to the number of intervals.
    std::uint32_t node(std::uint32_t chart, int i, int j) const;

private:
    struct Edge {
        std::uint32_t first = 0; // node at the corner where the edge begins, or after it
        bool backwards = false;  // the nodes were numbered along the other chart's side
        bool is_point = false;
    };
    std::uint32_t on_edge_of(std::uint32_t chart, int edge, int step) const;

    std::vector<glm::ivec2> counts_;
    std::vector<std::array<std::uint32_t, 4>> points_;
    std::vector<std::array<Edge, 4>> edges_;
    std::vector<std::uint32_t> inner_; // first node inside of each chart
    std::uint32_t size_ = 0;
};

// A ShareOfStep says where node `step` of `count` intervals lies along a chart, from 0 to 1.
using ShareOfStep = double (*)(int step, int count);

// Evaluates the nodes' points on a surface: the position at a node's first place, and the mean of
// the normals at all of its places, so that it is one on a crease too. `share` places the nodes
// along a chart. In parallel; the same bits for any number of threads. O(#nodes).
std::vector<SurfacePoint> points_at(const ChartSurface& surface, const SharedNodes& nodes,
                                    ShareOfStep share);

} // namespace trivar
