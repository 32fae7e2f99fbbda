// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"
#include "ui/theme.h"

namespace trivar {

struct Editor;

// The incisions of an object: which are there, the numbers of the chosen one, what became of it,
// and what the walls of all show.
void draw_incisions(Editor& editor, const ui::Theme& theme, Id id);

} // namespace trivar
