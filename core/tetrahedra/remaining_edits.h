// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tetrahedra/tetrahedra_shape.h"

namespace trivar {

// RemainingEdits holds the edits that remain when one is removed, and which of all of them are gone
// (1) or remain (0).
struct RemainingEdits {
    std::vector<TetrahedraEdit> edits;
    std::vector<char> gone;
};

// Removes an edit. The pulls of a refinement are gone with it; those of the others still act on
// theirs, which have other numbers now. Of n edits, `index` is from 0 to n - 1. O(n).
RemainingEdits without_edit(std::vector<TetrahedraEdit> edits, std::size_t index);

} // namespace trivar
