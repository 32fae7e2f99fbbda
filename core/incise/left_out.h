// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/slit_shape.h"

namespace trivar {

// Finds the pieces that loops through the body cut out and that are to be left out: of the two
// parts beside such a loop the one with fewer points. O(#points of these pieces). Incisions that
// cut out none are told of in `kept`.
struct LeftOutPieces {
    struct Kept {
        std::uint32_t incision;
        bool loop; // whose sides hang together elsewhere
    };
    LeftOut pieces;
    std::vector<Kept> kept;
};
LeftOutPieces left_out_pieces(const SlitShape& shape, std::span<const Incision> incisions);

} // namespace trivar
