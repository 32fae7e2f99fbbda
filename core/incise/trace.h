// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/incise/cut_drawing.h"

#include <string>

namespace trivar {

struct Traced {
    DrawnChain chain;
    std::string refusal; // a sentence, where there is no chain
    std::string notice;  // a sentence, where the chain is a part of what was asked for
};

// Draws a line over the skin through places in their order: between two of them in the plane
// through both and their mean normal. Points near points that are drawn already become these: so
// strokes join, and such as run over each other share their edges. Where the line touches an open
// border or faces that are no surface, or cannot go on, its longest part without that is drawn.
Traced trace(const CutDrawing& drawing, std::span<const SkinPlace> places);

} // namespace trivar
