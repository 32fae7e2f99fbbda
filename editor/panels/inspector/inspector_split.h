// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"
#include "ui/theme.h"

namespace trivar {

struct Editor;

// The obstacles that part an object, and how its halves are closed.
void draw_split(Editor& editor, const ui::Theme& theme, Id id);

} // namespace trivar
