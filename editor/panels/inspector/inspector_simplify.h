// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"
#include "ui/theme.h"

namespace trivar {

struct Editor;

// Draws the share of triangles that an object keeps, and their number.
void draw_simplify(Editor& editor, const ui::Theme& theme, Id id);

} // namespace trivar
