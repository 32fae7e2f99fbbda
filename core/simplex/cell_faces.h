// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplex/simplex_domain.h"

#include <cstdint>

namespace trivar {

// A CellFace is one face of a cell: the one opposite to a corner.
template <int S> struct CellFace {
    std::array<int, S> vertices; // ascending
    std::uint32_t cell = 0;
    std::uint8_t opposite = 0; // corner number
};

// All faces of all cells, sorted by their vertices, so that the two sides of a face follow each
// other; a face on the border is alone. O(n log n).
template <int S> std::vector<CellFace<S>> sorted_faces(const SimplexDomain<S>& domain);

// The unit normal of a face out of its cell.
glm::dvec3 outward(const SimplexDomain<3>& domain, const CellFace<3>& face);

} // namespace trivar
