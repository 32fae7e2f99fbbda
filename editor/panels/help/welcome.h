// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/editor.h"
#include "editor/session/samples.h"
#include "ui/paint.h"

#include <string>
#include <vector>

// These functions draw parts of the card over an empty viewport.

namespace trivar {

struct SamplePictures { // of the samples; each has its scene's name
    std::string folder;
};

// Draws two samples per row, with the link to the tour above them.
void draw_samples(Editor& editor, const ui::Theme& theme, const ui::Rect& column,
                  const std::vector<Sample>& samples);

// Moves the keyboard on the card, once per frame before its entries are drawn: Tab goes through
// them in the order in which they are drawn, arrows to the nearest one in that direction.
void move_keyboard(Editor& editor);
// Returns whether the entry that was drawn here is chosen, by the given click or by Enter; draws a
// ring where the keyboard is at it.
bool is_chosen(Editor& editor, const ui::Theme& theme, const ui::Rect& r, bool clicked);
// The entry that is nearest to the given one in a direction, downward positive; else the given one.
int next_entry(const std::vector<ui::Rect>& entries, int at, glm::vec2 direction);

// Returns the lower end of the caption.
float draw_caption(const ui::Theme& theme, const ui::Rect& column, float y, const char* words);
// Draws words that lead somewhere; returns whether they were chosen.
bool text_link(Editor& editor, const ui::Theme& theme, const ui::Rect& row,
               const std::string& words, ui::Align align = ui::Align::left);

} // namespace trivar
