// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/editor.h"
#include "ui/paint.h"

#include <string>
#include <vector>

// These functions draw the pages of the preferences. A page draws its rows from ImGui's cursor
// downward, within `r`; changes act at once.

namespace trivar {

void draw_general_page(Editor& editor, const ui::Theme& theme, const ui::Rect& r);
void draw_interface_page(Editor& editor, const ui::Theme& theme, const ui::Rect& r);
void draw_viewport_page(Editor& editor, const ui::Theme& theme, const ui::Rect& r);
void draw_mouse_page(Editor& editor, const ui::Theme& theme, const ui::Rect& r);
void draw_files_page(Editor& editor, const ui::Theme& theme, const ui::Rect& r);
void draw_performance_page(Editor& editor, const ui::Theme& theme, const ui::Rect& r);
void draw_accessibility_page(Editor& editor, const ui::Theme& theme, const ui::Rect& r);
void draw_about_page(Editor& editor, const ui::Theme& theme, const ui::Rect& r);
void copy_about();                           // as text, to the clipboard
void reset_preferences_page(Editor& editor); // the one that is shown, as it is drawn next

const Preferences& usual_preferences(); // the defaults

// These are rows of preferences: a label, with a dot where the value is not the default. The dot
// restores it.
void flag_row(const ui::Theme& theme, const char* label, bool& value, bool usual,
              const std::string& effect);
struct NamedText {
    std::string value, name;
};
void choice_row(const ui::Theme& theme, const char* label, std::string& value,
                const std::string& usual, const std::vector<NamedText>& choices);
struct NamedNumber {
    double value;
    std::string name;
};
// Draws a row of choices; the one nearest to the value is shown as chosen.
void choice_row(const ui::Theme& theme, const char* label, double& value, double usual,
                const std::vector<NamedNumber>& choices);
void scale_row(Editor& editor, const ui::Theme& theme); // of the whole interface
// Draws quiet words below the rows.
void foot_note(const ui::Theme& theme, const ui::Rect& r, const std::string& text,
               ui::Color color = 0);

} // namespace trivar
