// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lines/ink.h"
#include "gpu/curve.h"

#include <limits>
#include <vector>

namespace trivar {

// PlacedInk places inked lines in the picture and in the world.
struct PlacedInk {
    const glm::dmat4& to_world; // of their points in space
    const glm::dmat4& to_image; // of the same, to pixels and depth: how they were inked
    int id = 0;                 // of the object
    float wider = 1; // width of a line in pixels per pixel of a picture of the usual height
    // World units: the object's surface does not hide a seen line if it lies less far before it.
    // Rays have found what hides a line, and triangles are not quite where the smooth surface is.
    float own_reach = std::numeric_limits<float>::infinity();
};

// The renderer's curves for inked lines, at the end of `out`: through their points in space, or
// where a hand left them in the picture, at their depth.
void add_curves(std::vector<gpu::Curve>& out, const std::vector<InkedLine>& lines,
                const PlacedInk& placed);

} // namespace trivar
