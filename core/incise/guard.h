// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/cut_shape.h"

namespace trivar {

// A CutGuard looks at the region of cuts for triangles that pierce each other and have at most one
// vertex in common. It decides with doubles: what they cannot tell from touching is no piercing. In
// parallel.
class CutGuard {
public:
    explicit CutGuard(const CutShape& shape);

    struct Pair {
        std::uint32_t a, b; // triangles of the region, a < b
        auto operator<=>(const Pair&) const = default;
    };
    // With each incision open by a share of its width. Ascending.
    std::vector<Pair> piercings(std::span<const double> shares) const;
    bool is_wall(std::uint32_t triangle) const
    {
        return triangle >= first_wall_ && triangle < end_of_walls_;
    }
    // Of CutShape::walls.
    std::uint32_t wall_number(std::uint32_t triangle) const
    {
        return walls_[triangle - first_wall_];
    }
    // The incisions that move a corner of one of both.
    std::vector<std::uint32_t> incisions_at(const Pair& pair) const;

private:
    struct Mover {
        std::uint32_t vertex, incision;
        auto operator<=>(const Mover&) const = default;
    };
    std::vector<glm::dvec3> rest_;
    std::vector<glm::uvec3> triangles_; // local vertices; skin first
    std::size_t first_wall_ = 0, end_of_walls_ = 0;
    std::vector<std::uint32_t> walls_;
    std::vector<CutTerm> terms_; // by local vertex
    std::vector<Mover> movers_;  // ascending
};

// The incisions through the body whose walls pierce others while all is shut, ascending.
std::vector<std::uint32_t> piercing_on_their_way(const CutShape& shape);

// The shares of their widths that incisions can open: 1 where nothing pierces then, otherwise
// narrower for those that move what does. An empty result: walls pierce although all is shut.
std::vector<double> admissible_shares(const CutShape& shape, std::size_t incisions);

} // namespace trivar
