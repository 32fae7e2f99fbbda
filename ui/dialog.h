// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/widgets.h"

#include <optional>
#include <string>
#include <vector>

namespace trivar::ui {

// A question that only a person can decide. Esc is the answer -1; Enter is `safe`.
struct Question {
    std::string title, text;
    struct Answer {
        std::string words;
        ButtonKind kind = ButtonKind::plain;
    };
    std::vector<Answer> answers; // left to right
    int safe = 0;
};

// Draws the question over everything; the index of the answer once there is one.
std::optional<int> ask(const Theme& theme, const Question& question);

// A modal card in the middle of the window: begin, contents at the cursor, end.
struct DialogStyle {
    float from_top = -1; // pixels; below 0: in the middle
    float scrim = 1;     // how dark the rest becomes, as a share of the theme's
};
Rect begin_dialog(const Theme& theme, const char* name, glm::vec2 size,
                  const DialogStyle& style = {});
void end_dialog();

} // namespace trivar::ui
