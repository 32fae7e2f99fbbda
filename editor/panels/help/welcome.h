// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/editor.h"
#include "editor/session/samples.h"
#include "ui/paint.h"

#include <string>
#include <vector>

// Parts of the card over an empty viewport.

namespace trivar {

struct SamplePictures { // of the samples, each called as its scene
    std::string folder;
};

// Two in a row, with the way to the tour above them.
void draw_samples(Editor& editor, const ui::Theme& theme, const ui::Rect& column,
                  const std::vector<Sample>& samples);

// The keyboard on the card: Tab goes through its entries in the order in which they are drawn,
// arrows to the nearest that way. Once a frame, before them.
void move_keyboard(Editor& editor);
// Of the entry that was drawn here, with a ring where the keyboard is at it: whether it is chosen,
// by that click or by Enter.
bool is_chosen(Editor& editor, const ui::Theme& theme, const ui::Rect& r, bool clicked);
// The entry that is nearest to that one in a direction, downward positive; else that one.
int next_entry(const std::vector<ui::Rect>& entries, int at, glm::vec2 direction);

// Where it ends, downward.
float draw_caption(const ui::Theme& theme, const ui::Rect& column, float y, const char* words);
// Words that lead somewhere; whether they were chosen.
bool text_link(Editor& editor, const ui::Theme& theme, const ui::Rect& row,
               const std::string& words, ui::Align align = ui::Align::left);

} // namespace trivar
