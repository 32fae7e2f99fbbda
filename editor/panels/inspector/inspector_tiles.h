// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"
#include "ui/theme.h"

namespace trivar {

struct Editor;

// The rows of a layer of tiles: what holds for all of them, and its strokes.
void draw_tiles(Editor& editor, const ui::Theme& theme, Id id);

// The strokes of a layer, of which one at a time shows its numbers.
void draw_tile_strokes(Editor& editor, const ui::Theme& theme, Id id, const Tiling& tiling);

// The height at which drags stop for a fold limit: rounded numbers must not pass that.
double just_below(double limit);

} // namespace trivar
