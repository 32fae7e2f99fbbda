// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/placement.h"
#include "editor/hands/tool.h"
#include "gpu/picture.h"
#include "ui/paint.h"

namespace trivar {

// These functions show how the strip of a placement lies, by colours, dots and words.

// The strip in colours: where it touches the scene, bridges gaps, meets nothing, is stretched or
// squeezed by more than half, or folds.
gpu::Translucent strip_veil(const Placement& placement, const ui::Theme& theme);

// The nodes of its rims and middle line that are drawn, as densely as they can be told apart: solid
// where the strip touches the scene, hollow where it bridges or met nothing; and a cross wherever
// the volume folds. `trouble`: only those that met nothing, and the crosses.
enum class Nodes { all, trouble };
void paint_nodes(const ui::Theme& theme, const ViewportInput& input, const Camera& camera,
                 const Placement& placement, Nodes which);

// Paints the meaning of those colours that occur, at the right of the picture.
glm::vec2 strip_legend_at(const ui::Theme& theme, const ui::Rect& picture); // its left top corner
void paint_strip_legend(const ui::Theme& theme, const ui::Rect& picture,
                        const Placement& placement);

} // namespace trivar
