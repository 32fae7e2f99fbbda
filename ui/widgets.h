// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tooltip.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

// These are the widgets of panels. Each draws at ImGui's cursor in the current window and advances
// it.

namespace trivar::ui {

// cancelled: the value is that before the drag; copied: the person asks for the command that would
// set the value, and the value stays.
enum class Edit { none, changed, cancelled, copied };

// Declares that the fields of the current window set parts of a command: their menus then offer to
// copy it.
void offer_commands();
bool offers_commands(); // the current window
inline constexpr const char* copy_command_words = "Copy as command";

// A number that is dragged sideways (1 % of the range, or of the value, per 4 px; Shift a tenth,
// Ctrl in round steps) or clicked and typed; Tab goes to the next one. Drags end at the limits. A
// typed number beyond them, or one that cannot be read, is not taken, and a line under the field
// says why.
struct NumberStyle {
    double lo = -1e9, hi = 1e9;
    double bar_hi =
        -1e300;      // above lo: a bar is filled from lo to here, and drags follow this range
    double step = 0; // above 0: drags move by whole steps of this
    std::string unit = {}, axis = {};
    Color axis_color = 0;
    std::string zero = {};  // what is shown in place of 0: "auto"
    std::string words = {}; // what is shown in place of any number: "mixed"
    double stop = 1e300;    // drags from below halt there, and go on if they are pulled further
    double usual = 0.04;    // without range and step, drags of smaller values go as those of this
    double factor = 1;      // from a value to what is shown; all the numbers above are values
};
// Styles a share that is shown as per cent.
NumberStyle percent_style(double lo = 0, double hi = 1);
Edit number_field(const Theme& theme, const std::string& id, double& value,
                  const NumberStyle& style, float width);
Edit integer_field(const Theme& theme, const std::string& id, int& value, const NumberStyle& style,
                   float width);

// Lets the next number that is drawn in the current window be typed: where Tab begins.
void type_next_number();

Edit check_box(const Theme& theme, const std::string& id, bool& value, const std::string& effect);
// A choice for places without room for the names beside each other.
Edit segments(const Theme& theme, const std::string& id, int& chosen,
              const std::vector<std::string>& names, float width);
Edit choice(const Theme& theme, const std::string& id, int& chosen,
            const std::vector<std::string>& names, float width);
Edit color_field(const Theme& theme, const std::string& id, glm::vec4& linear, float width);
// Reports a change while the text is typed.
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

// An area that takes the mouse where nothing later drawn upon it does: things below a card get no
// clicks through it, nor does a picture where a card's buttons are. It counts as an ImGui item.
bool lower_area(const char* id, const Rect& area, int buttons = 1); // ImGuiButtonFlags of the mouse

// Draws a name that a person gave: shortened where it is too long, and then complete in its
// tooltip.
void name_text(const ImFont* font, const Rect& in, Color color, const std::string& name);

// The heading of a group that opens and closes; returns whether it is open. `note` stands at its
// right.
bool section(const Theme& theme, const std::string& title, bool open_at_first = true,
             const std::string& note = {}, Color note_color = 0);

// The width at the right of a row's field, in pixels at scale 1, for a mark and the scroll bar.
inline constexpr float key_gutter = 26;
// A Row is a label at the left, with the cursor left where the field goes. It holds the field's
// width. A dot marks a value that differs from its default; clicking the dot resets the value.
struct Row {
    float width = 0;
    bool reset = false;
};
Row label_row(const Theme& theme, const std::string& label, bool changed = false,
              const std::string& help = {}); // the sentence of the row's tooltip
void reset_rows(); // resets the rows of the current window in this frame, as their dots do
// Draws a button at the end of a row that unfolds the rows below it; the row's field gets narrower
// by it. Before it is pressed, `open_at_first` is the answer. Values never open or close it.
bool unfolded(const Theme& theme, Row& row, const std::string& id, bool open_at_first);
void unfold(const std::string& id); // opens it from the next frame on
// A row that shows a fact.
void fact_row(const Theme& theme, const std::string& label, const std::string& value,
              Color color = 0, const std::string& help = {});
// A row of a list: a name, and buttons at its right.
struct RowButton {
    const char *id, *icon;
    Tip tip;
};
struct ListRow {
    std::string name;
    const ImFont* font = nullptr; // null: that of the body
    Color color = 0;              // 0: that of text
    const char* icon = nullptr;   // before the name
    std::optional<Tip> tip = {};  // where the name can be clicked
};
// Returns the number of the button that was pressed; -1: the name was, and nothing: none was.
std::optional<int> list_row(const Theme& theme, const ListRow& row,
                            const std::vector<RowButton>& buttons);
// Rows that need not apply: if they do not, they keep their place, greyed, take neither mouse nor
// keys, and their tooltips say why not. So no row moves while values change.
void rows_if(const Theme& theme, bool they_apply, const char* why_not,
             const std::function<void()>& draw);
bool is_greyed(); // whether what is drawn now is in such rows
void gap(const Theme& theme, float height_at_scale_1);

// An icon, a bold line, and a sentence with the way out; centred in the rectangle.
void empty_state(const Theme& theme, const Rect& in, const char* icon, const std::string& title,
                 const std::string& body);

// Returns a number as a field shows it: all of up to six digits, else four, and no more than fit.
// Whole steps are shown in whole.
std::string number_in_field(double value, double step,
                            const std::function<bool(const std::string&)>& fits);
// A number_text of three digits, two decimals where they are known: 0.40 beside 0.42.
std::string short_number(double value);

} // namespace trivar::ui
