// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/unwrap/manifold_surface.h"

namespace trivar {

struct ChartRules {
    // Edges over which faces turn by more than that are where charts end.
    double seam_angle = 1.05; // radians
    // The greatest spread of the normals of one chart: as over a round cap whose rim leans so far.
    double spread = 1.05; // radians
};

// A ChartTree divides a surface into charts and keeps for each of them the parts from which it was
// joined, down to single faces. Every node is a disk: it is joined from two disks whose common part
// is one piece of their rims. The two that stay the flattest and roundest together are joined first
// [1]:
//
//        chart
//       /     \          both are disks:
//     left   right        a chart that is stretched too much is
//     /  \   /   \        divided into these two
//    f1  f2 f3   ...
//
// O(#C log #C) where charts have short rims. The same charts on every machine.
//   [1] Garland, Willmott, Heckbert, "Hierarchical face clustering on polygonal surfaces", 2001
class ChartTree {
public:
    // Builds the tree. `progress` is called every few milliseconds; its throw cancels.
    ChartTree(const ManifoldSurface& surface, const ChartRules& rules,
              const Progress& progress = {});

    static constexpr std::uint32_t none = ~0u;
    const std::vector<std::uint32_t>& charts() const
    {
        return charts_;
    } // nodes that were joined no further
    bool is_face(std::uint32_t node) const { return nodes_[node].left == none; }
    std::uint32_t left(std::uint32_t node) const { return nodes_[node].left; }
    std::uint32_t right(std::uint32_t node) const { return nodes_[node].right; }
    std::vector<std::uint32_t> faces(std::uint32_t node) const; // ascending

private:
    struct Node {
        std::uint32_t left = none, right = none;
        std::uint32_t face = 0; // of a node that is one
        bool joined = false;    // is part of another one
        glm::dvec3 turned{0};   // sum of the area normals
        double area = 0, rim = 0;
        std::vector<std::uint32_t> sides; // of the rim
    };
    class Joining;

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> charts_;
};

} // namespace trivar
