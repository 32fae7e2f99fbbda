// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/level/field_slabs.h"
#include "core/lines/level_drawing.h"

namespace trivar {

// A level as it is to be drawn of data that are larger than memory.
struct SlabLevel {
    std::string name;
    float level = 0;                   // as a sample
    LevelSide side = LevelSide::above; // that of samples
    LineStyle style = {};              // without fans
    bool border = true;                // also lines where the grid cuts the body off
    float amount = 1;                  // as MoreLines has it, without levels nearby
};

// Draws levels as draw_levels() does, slab by slab, in two passes over the slices: curves, then
// what is hidden of them. The curves are those of the whole; what is hidden may differ where
// visibility errs anyway, at 0.1 % of points. Of the options certified lines, dashes and `kept` are
// not for slabs. Beside a slab memory is taken for its levels' meshes and for the curves.
LevelDrawing draw_levels_by_slabs(const SlabPlan& plan, const VoxelFieldOptions& field,
                                  const SliceReader& read, std::span<const SlabLevel> levels,
                                  const DrawingView& view, const LevelDrawingOptions& options = {});

} // namespace trivar
