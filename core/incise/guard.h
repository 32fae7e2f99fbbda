// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/cut_shape.h"

namespace trivar {

// How many pairs of triangles pierce each other that have at most one point in common.
struct Piercings {
    std::size_t of_walls = 0; // with a wall in the pair
    std::size_t of_skin = 0;
};

// A CutGuard looks at the region of cuts for walls and skin that pierce each other. It counts with
// doubles, and what they cannot tell from touching is no piercing. In parallel.
class CutGuard {
public:
    explicit CutGuard(const CutShape& shape);
    // With each incision open by a share of its width.
    Piercings piercings(std::span<const double> shares) const;

private:
    std::vector<glm::dvec3> rest_;
    std::vector<glm::uvec3> triangles_; // local vertices; skin first
    std::size_t first_wall_ = 0, end_of_walls_ = 0;
    std::vector<CutTerm> terms_; // by local vertex
};

// The shares of their widths that incisions can open: 1 where nothing pierces then, otherwise
// narrower for all, or for later ones more. An empty result: walls pierce although all is shut.
std::vector<double> admissible_shares(const CutShape& shape, std::size_t incisions);

} // namespace trivar
