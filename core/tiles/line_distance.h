// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"

#include <span>
#include <vector>

namespace trivar {

// A LineDistance finds the distance of points from lines. Boxes round 16 pieces each rule out far
// ones. O(#pieces / 16), and 16 for each box that may hold the nearest piece.
class LineDistance {
public:
    void add(std::span<const glm::dvec3> line);
    bool empty() const { return pieces_.empty(); }
    double to(const glm::dvec3& p) const; // metres; infinite without lines

private:
    struct Piece {
        glm::dvec3 a, b;
    };
    static constexpr std::size_t block = 16;
    std::vector<Piece> pieces_;
    std::vector<Box> boxes_; // of blocks
};

} // namespace trivar
