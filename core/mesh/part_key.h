// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <cstdint>

namespace trivar {

// A PartKey tells a part from the other parts of its object; it does not depend on which are shown.
struct PartKey {
    int member = 0;         // of a procession
    int mesh = 0;           // of the shape
    std::int64_t piece = 0; // number of the piece, where a step cut the mesh
    auto operator<=>(const PartKey&) const = default;
};

} // namespace trivar
