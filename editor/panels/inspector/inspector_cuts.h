// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"
#include "ui/theme.h"

namespace trivar {

struct Editor;

// The planes and strokes that cut an object, and how its pieces are closed.
void draw_cuts(Editor& editor, const ui::Theme& theme, Id id);

} // namespace trivar
