// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"
#include "ui/theme.h"

namespace trivar {

struct Editor;

// Draws how the UVs of an object are made, and what came of it.
void draw_unwrap(Editor& editor, const ui::Theme& theme, Id id);

} // namespace trivar
