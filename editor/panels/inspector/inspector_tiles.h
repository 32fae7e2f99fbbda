// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"
#include "ui/theme.h"

namespace trivar {

struct Editor;

// The rows of a layer of tiles: what holds for all of them, and its strokes.
void draw_tiles(Editor& editor, const ui::Theme& theme, Id id);

} // namespace trivar
