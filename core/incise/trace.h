// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/slit_drawing.h"

#include <string>

namespace trivar {

// A StrokePart is a part of a stroke that lies on the skin: its places, and where each is, as a
// share of the stroke's length; by number where that is not told.
struct StrokePart {
    std::vector<SkinPlace> places;
    std::vector<double> shares = {};
    double share(std::size_t i) const
    {
        return shares.empty() ? static_cast<double>(i) / static_cast<double>(places.size() - 1)
                              : shares[i];
    }
};

struct Traced {
    std::vector<DrawnChain> chains; // in the order of the stroke
    std::string refusal;            // a sentence, where there is none
    std::string notice;             // a sentence, where not all is drawn, or not as one chain
};

// Draws lines over the skin through the places of each part in their order: between two of them in
// the plane through both and their mean normal. Points near points that are drawn already become
// these: so strokes join, and strokes that run over each other share their edges. A line is parted
// where it touches an open border or faces that are no surface, and where the surface does not go
// on to the next place.
Traced trace(const SlitDrawing& drawing, std::span<const StrokePart> parts);

} // namespace trivar
