// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/widgets.h"

#include <optional>
#include <string>
#include <vector>

namespace trivar::ui {

// A Question is one that only a person can decide. Esc gives the answer -1. Tab and the arrows go
// from button to button; at first `safe` has the keyboard, and Enter presses the button that has
// it.
struct Question {
    std::string title, text;
    struct Answer {
        std::string words;
        ButtonKind kind = ButtonKind::plain;
        bool apart = false; // at the left edge, away from the others
    };
    std::vector<Answer> answers; // left to right, those apart first
    int safe = 0;
};

// Draws the question over everything; returns the index of the answer once there is one.
std::optional<int> ask(const Theme& theme, const Question& question);

// A DialogStyle describes a modal card in the middle of the window: begin, contents at the cursor,
// end.
struct DialogStyle {
    float from_top = -1; // pixels; below 0: in the middle
    float scrim = 1;     // how dark the rest of the window becomes, as a share of the theme's scrim
};
Rect begin_dialog(const Theme& theme, const char* name, glm::vec2 size,
                  const DialogStyle& style = {});
// Draws a title over a rule across the top; returns where the contents begin, in pixels of the
// window.
float draw_dialog_head(const Theme& theme, const Rect& dialog, const char* title);
void end_dialog();

} // namespace trivar::ui
