// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/cage.h"

namespace trivar {

// JoinedCages are several cages as one, and where the charts of each begin on a surface over it.
struct JoinedCages {
    Cage cage;
    std::vector<std::uint32_t> first_chart; // of each; one more at the end
    // Tells which of them a chart belongs to.
    std::size_t piece_of(std::uint32_t chart) const;
};
// Joins cages. `largest_chart` is the number of corners that a face may have as one chart; where
// some face has more, or fewer than `smallest_chart`, each corner of all faces makes one. O(#points
// + #corners).
JoinedCages joined(std::span<const Cage> cages, int smallest_chart = 4, int largest_chart = 4);

} // namespace trivar
