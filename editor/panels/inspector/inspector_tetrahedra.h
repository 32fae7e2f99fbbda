// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"
#include "ui/theme.h"

namespace trivar {

struct Editor;

// The domain of a volume of tetrahedra, and its edits: the chosen one with its numbers.
void draw_tetrahedra(Editor& editor, const ui::Theme& theme, Id id);

// Draws the facts of a surface of simplex splines.
void draw_simplex_sheet(Editor& editor, const ui::Theme& theme, Id id);

} // namespace trivar
