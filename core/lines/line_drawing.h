// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lines/ink.h"
#include "core/lines/more_lines.h"

namespace trivar {

// A LineDrawing says how an object is drawn in lines.
struct LineDrawing {
    bool outlines = true;       // where the surface turns away from sight
    bool creases = true;        // sharp edges
    float crease_deg = 35;      // between faces, from which on an edge is sharp
    bool borders = true;        // edges with a face on one side only
    bool intersections = false; // where its surface goes through others, and through itself
    bool surface = true;        // also the surface in its own materials
    bool paper = false;         // the surface is plain paper, without light and shade
    glm::vec3 paper_color{1};   // sRGB
    LineStyle ink = {};
    MoreLines more = {.smoothing = 1};
    bool operator==(const LineDrawing&) const = default;
};

} // namespace trivar
