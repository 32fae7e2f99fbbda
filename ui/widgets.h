// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tooltip.h"

#include <string>
#include <vector>

// What panels are made of. Each draws at ImGui's cursor in the current window and moves it on.

namespace trivar::ui {

// cancelled: the value is as it was before the drag; copied: the command that would set the value
// is asked for, the value is as it was.
enum class Edit { none, changed, cancelled, copied };

// What the fields of the current window set is a command: their menus then copy it as well.
void offer_commands();
bool offers_commands(); // the current window
inline constexpr const char* copy_command_words = "Copy as command";

// A number that is dragged sideways (1 % of the range, or of the value, each 4 px; Shift a tenth,
// Ctrl in round steps) or clicked and typed; Tab goes to the next one. Drags end at the limits;
// what is typed beyond them, or cannot be read, is not taken, and a line under the field says why.
struct NumberStyle {
    double lo = -1e9, hi = 1e9;
    double bar_hi =
        -1e300;      // above lo: a bar is filled from lo to here, and drags follow this range
    double step = 0; // above 0: drags move by whole steps of this
    std::string unit = {}, axis = {};
    Color axis_color = 0;
    std::string zero = {};  // what is shown in place of 0: "auto"
    std::string words = {}; // what is shown in place of any number: "mixed"
};
Edit number_field(const Theme& theme, const std::string& id, double& value,
                  const NumberStyle& style, float width);
Edit integer_field(const Theme& theme, const std::string& id, int& value, const NumberStyle& style,
                   float width);

// The next number that is drawn in the current window is typed: where Tab begins.
void type_next_number();

Edit check_box(const Theme& theme, const std::string& id, bool& value, const std::string& effect);
// A choice where there is no room for the names beside each other.
Edit segments(const Theme& theme, const std::string& id, int& chosen,
              const std::vector<std::string>& names, float width);
Edit choice(const Theme& theme, const std::string& id, int& chosen,
            const std::vector<std::string>& names, float width);
Edit color_field(const Theme& theme, const std::string& id, glm::vec4& linear, float width);
// Reports a change as the text is typed.
Edit text_field(const Theme& theme, const std::string& id, std::string& text,
                const std::string& hint, float width, const char* icon = nullptr);

enum class ButtonKind { plain, primary, danger, quiet };
bool button(const Theme& theme, const std::string& text, ButtonKind kind = ButtonKind::plain,
            glm::vec2 size = {0, 0}, const char* icon = nullptr, const std::string& key = {});
float button_width(const Theme& theme, const std::string& text);
struct IconState {
    bool on = false, enabled = true;
};
bool icon_button(const Theme& theme, const std::string& id, const char* icon, glm::vec2 size,
                 const Tip& tip, IconState state = {});

// An area that takes the mouse where nothing that is drawn upon it later does: what lies below a
// card takes no clicks through it, nor does a picture where a card's buttons are. As an ImGui item.
bool lower_area(const char* id, const Rect& area, int buttons = 1); // ImGuiButtonFlags of the mouse

// Something that a person named: shortened where it is too long, and then whole in its tooltip.
void name_text(const ImFont* font, const Rect& in, Color color, const std::string& name);

// A group's heading that opens and closes; whether it is open. `note` stands at its right.
bool section(const Theme& theme, const std::string& title, bool open_at_first = true,
             const std::string& note = {}, Color note_color = 0);

// At the right of a row's field, pixels at scale 1: a mark and the scroll bar.
inline constexpr float key_gutter = 26;
// The label at the left of a row; the cursor is left where the field goes. Returns the field's
// width. A dot marks a value that differs from its default; clicking the dot resets it.
struct Row {
    float width = 0;
    bool reset = false;
};
Row label_row(const Theme& theme, const std::string& label, bool changed = false,
              const std::string& help = {}); // the sentence of the row's tooltip
void reset_rows(); // those of the current window, in this frame, as by their dots
// A row that only tells.
void fact_row(const Theme& theme, const std::string& label, const std::string& value,
              Color color = 0, const std::string& help = {});
void gap(const Theme& theme, float height_at_scale_1);

// Icon, bold line, a sentence with the way out; centred in the rectangle.
void empty_state(const Theme& theme, const Rect& in, const char* icon, const std::string& title,
                 const std::string& body);

// A number with three significant digits, and no exponent between 0.001 and 1e6.
std::string short_number(double value);
std::string with_commas(std::size_t number); // 12,345

} // namespace trivar::ui
