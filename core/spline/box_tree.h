// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"

#include <vector>

namespace trivar {

// A BoxTree is a balanced tree over given boxes. Queries report indices in ascending order, for any
// shape of the tree.
class BoxTree {
public:
    BoxTree() = default;
    explicit BoxTree(const std::vector<Box>& boxes); // O(n log n)

    // The boxes within a distance of p (0: those that hold it), ascending.
    std::vector<int> near(const glm::dvec3& p, double distance) const;
    // The boxes that have a point in common with one, ascending.
    std::vector<int> touching(const Box& box) const;
    // The smallest distance for which near() reports anything; 1e300 for an empty tree.
    double distance(const glm::dvec3& p) const;
    // box round all of them; not for an empty tree
    const Box& bounds() const { return nodes_.front().bounds; }

private:
    // A leaf holds one box; an inner node's children are the next node and `second`.
    struct Node {
        Box bounds;
        int box = -1;
        int second = -1;
    };
    int build(const std::vector<Box>& boxes, std::vector<int>::iterator begin,
              std::vector<int>::iterator end);
    std::vector<int> boxes_in(auto&& wanted) const; // the boxes in bounds that are wanted
    std::vector<Node> nodes_;
};

} // namespace trivar
