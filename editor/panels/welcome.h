// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/editor.h"
#include "editor/samples.h"
#include "ui/paint.h"

#include <string>
#include <vector>

// Parts of the card over an empty viewport.

namespace trivar {

// Two in a row, with the way to the tour above them.
void draw_samples(Editor& editor, const ui::Theme& theme, const ui::Rect& column,
                  const std::vector<Sample>& samples);

// Where it ends, downward.
float draw_caption(const ui::Theme& theme, const ui::Rect& column, float y, const char* words);
// Words that lead somewhere; whether they were clicked.
bool text_link(const ui::Theme& theme, const ui::Rect& row, const std::string& words,
               ui::Align align = ui::Align::left);

} // namespace trivar
