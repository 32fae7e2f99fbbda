// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/editor.h"
#include "editor/panels/inspector/key_gutter.h"

namespace trivar {

// The rows of the masks of a layer of tiles, and buttons that add some.
void draw_masks(Editor& editor, const ui::Theme& theme, Id id, const Tiling& tiling,
                const KeyGutter& keys);

// The section of a sheet of heights.
void draw_heights(Editor& editor, const ui::Theme& theme, Id id);

} // namespace trivar
