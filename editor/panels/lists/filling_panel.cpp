// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "editor/actions/command_filling.h"
#include "editor/actions/palette_entries.h"
#include "editor/panels/lists/palette_rows.h"
#include "editor/panels/panels.h"
#include "ui/dialog.h"
#include "ui/icons.h"
#include "ui/sentence.h"
#include "ui/widgets.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>
#include <utility>

namespace trivar {
namespace {

using Field = CommandForm::Field;

// Numbers with as many digits as a field shows.
std::string text_shown(const Field& field)
{
    if (field.kind != Field::number) return field.present;
    std::string text;
    std::string_view rest = field.present;
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(' '), rest.size());
        const auto number = parse_number(rest.substr(0, end));
        text += (text.empty() ? "" : "  ") +
                (number ? ui::short_number(*number) : std::string(rest.substr(0, end)));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return text;
}

// Widths are the widths of a field in the line: its label, its value in a box, its unit.
struct Widths {
    float label, value, unit;
    float all() const { return label + value + unit; }
};
Widths widths_of(const ui::Theme& theme, const Field& field, bool at_hand, float most)
{
    const std::string& text = field.typed.empty() ? text_shown(field) : field.typed;
    const float least = at_hand ? theme.px(96) : theme.px(16);
    const float value = ui::text_width(theme.font.body, text) + theme.px(at_hand ? 28 : 14);
    Widths w{ui::text_width(theme.font.small, field.label) + theme.px(6), 0,
             field.unit.empty() ? 0 : ui::text_width(theme.font.small, field.unit) + theme.px(6)};
    w.value =
        std::clamp(value, least, std::max(least, std::min(theme.px(260), most - w.label - w.unit)));
    return w;
}

// FieldsShown are as many whole fields as fit, with the one at hand among them.
struct FieldsShown {
    std::size_t first = 0, end = 0;
};
FieldsShown fields_in(const std::vector<float>& widths, std::size_t at, float room, float gap)
{
    FieldsShown part{at, at + 1};
    room -= widths[at];
    while (part.first > 0 && widths[part.first - 1] + gap <= room)
        room -= widths[--part.first] + gap;
    while (part.end < widths.size() && widths[part.end] + gap <= room)
        room -= widths[part.end++] + gap;
    return part;
}

// A field has the keyboard some frames after it was chosen: on a slow machine that is time enough
// to type into it.
bool take_letters_typed_before(CommandPalette::Filling& filling, std::string& typed)
{
    ImVector<ImWchar>& letters = ImGui::GetIO().InputQueueCharacters;
    if (filling.typing || letters.empty()) return false;
    for (const ImWchar letter : letters) {
        char utf8[5] = {};
        if (letter >= ' ') typed += ImTextCharToUtf8(utf8, letter);
    }
    letters.resize(0);
    return filling.typed_before = true;
}

// The value at hand, typed; whether it changed. Tab is no letter and no way out of it.
bool type_value(CommandPalette& palette, const ui::Theme& theme, const ui::Rect& box)
{
    CommandForm& form = palette.filling->form;
    Field& field = form.fields[form.at];
    // A text field that has the keyboard knows its text by itself: each turn has another one.
    int& turn = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("turn"), 0);
    if (palette.fresh) ++turn;
    ImGui::PushID(turn);
    ImGui::SetCursorScreenPos({box.lo.x, box.lo.y});
    ui::paint_box(box, theme.color.field_active, theme.size.rounding_small);
    ImGui::PushStyleColor(ImGuiCol_FrameBg, 0);
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {theme.px(8), theme.px(4)});
    ImGui::SetNextItemWidth(box.width());
    CommandPalette::Filling& filling = *palette.filling;
    if (palette.fresh) filling.typing = filling.typed_before = false;
    if (std::exchange(palette.fresh, false)) ImGui::SetKeyboardFocusHere();
    bool changed = take_letters_typed_before(filling, field.typed);
    const auto follow = [](ImGuiInputTextCallbackData* data) {
        // All is selected when it gets the keyboard: the next letter would replace what came
        // before.
        bool& before = *static_cast<bool*>(data->UserData);
        if (std::exchange(before, false))
            data->SelectionStart = data->SelectionEnd = data->CursorPos = data->BufTextLen;
        return 0;
    };
    changed |= ImGui::InputText("##value", &field.typed,
                                ImGuiInputTextFlags_CallbackCompletion |
                                    ImGuiInputTextFlags_CallbackAlways,
                                follow, &filling.typed_before);
    filling.typing = ImGui::IsItemActive();
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
    ui::paint_rim(box, form.trouble.empty() ? theme.color.focus : theme.color.bad,
                  theme.size.rounding_small, 1.5f * theme.scale);
    if (field.typed.empty())
        ui::paint_text(theme.font.body,
                       {box.lo + glm::vec2(theme.px(8), 0), box.hi - glm::vec2(theme.px(6), 0)},
                       theme.color.text_3,
                       ui::elided(theme.font.body, text_shown(field), box.width() - theme.px(14)));
    ImGui::PopID();
    return changed;
}

// The command's name and its fields one after another; the index of one that was clicked.
std::optional<std::size_t> draw_form_line(CommandPalette& palette, const ui::Theme& theme,
                                          const ui::Rect& r, bool& changed)
{
    const ui::Palette& c = theme.color;
    const CommandForm& form = palette.filling->form;
    const float gap = theme.px(14), right = r.hi.x - theme.px(20);
    ui::paint_text(theme.font.body, {r.lo + glm::vec2(theme.px(20), 0), r.hi}, c.text_2,
                   ui::icon::pencil);
    float x = r.lo.x + theme.px(52);
    const std::string title = ui::elided(theme.font.strong, form.title, theme.px(200));
    ui::paint_text(theme.font.strong, {{x, r.lo.y}, r.hi}, c.text, title);
    x += ui::text_width(theme.font.strong, title) + theme.px(20);
    const float mark = theme.px(18); // where more is, at either end
    std::vector<Widths> widths;
    std::vector<float> all;
    for (std::size_t i = 0; i < form.fields.size(); ++i) {
        widths.push_back(widths_of(theme, form.fields[i], i == form.at, right - x - 2 * mark));
        all.push_back(widths.back().all());
    }
    const std::size_t at = form.at; // Tab moves it on while it is drawn
    const FieldsShown part = fields_in(all, at, right - x - 2 * mark, gap);
    const auto more = [&](float left) {
        ui::paint_text(theme.font.body, {{left, r.lo.y}, {left + mark, r.hi.y}}, c.text_3, "…");
    };
    if (part.first > 0) more(x);
    if (part.first > 0) x += mark;
    std::optional<std::size_t> clicked;
    for (std::size_t i = part.first; i < part.end; ++i, x += gap) {
        const Field& field = form.fields[i];
        ui::paint_text(theme.font.small, {{x, r.lo.y}, r.hi}, i == at ? c.text : c.text_2,
                       field.label);
        const float middle = r.center().y, half = theme.px(12);
        const ui::Rect box = {{x + widths[i].label, std::round(middle - half)},
                              {x + widths[i].label + widths[i].value, std::round(middle + half)}};
        if (i == at) {
            changed = type_value(palette, theme, box);
        } else {
            const std::string text = field.typed.empty() ? text_shown(field) : field.typed;
            const ui::Rect words = {box.lo + glm::vec2(theme.px(4), 0), box.hi};
            ImGui::PushID(static_cast<int>(i));
            ImGui::SetCursorScreenPos({x, box.lo.y});
            if (ImGui::InvisibleButton("field", {widths[i].label + widths[i].value, box.height()}))
                clicked = i;
            ui::paint_text(theme.font.body, words, field.typed.empty() ? c.text_3 : c.text,
                           ui::elided(theme.font.body, text, words.width() - theme.px(4)));
            ImGui::PopID();
        }
        x = box.hi.x;
        if (widths[i].unit > 0)
            ui::paint_text(theme.font.small, {{x + theme.px(6), r.lo.y}, r.hi}, c.text_2,
                           field.unit);
        x += widths[i].unit;
    }
    if (part.end < form.fields.size()) more(x - theme.px(8));
    ui::paint_box({{r.lo.x, r.hi.y}, {r.hi.x, r.hi.y + theme.size.hairline}}, c.line_soft);
    return clicked;
}

PaletteRows rows_of(const std::vector<FormOption>& options, const Document& document)
{
    PaletteRows rows;
    rows.caption = options.empty() || options.front().object == 0 ? "CHOICES" : "OBJECTS";
    for (std::size_t i = 0; i < options.size(); ++i) {
        const FormOption& each = options[i];
        PaletteEntry entry{each.words, {}, nullptr, {}, {}, nullptr};
        entry.icon = ui::icon::check;
        if (each.object != 0) {
            const Object& named = object(document, each.object);
            entry.icon = icon_of(named);
            entry.note = type_of(named);
            if (each.typed == std::to_string(each.object)) // others are called that too
                entry.note += ", number " + each.typed;
        }
        rows.entries.push_back(std::move(entry));
        rows.found.push_back({i, each.letters});
    }
    return rows;
}

} // namespace

void draw_filling(Editor& editor, const ui::Theme& theme)
{
    CommandPalette& palette = editor.palette;
    CommandForm& form = palette.filling->form;
    if (!palette.filling->begun) show_filling(editor);
    palette.filling->begun = true;
    const Document& document = editor.session.committed();
    auto options = options_of(form, document);
    const Field& field = form.fields[form.at];
    const float width = theme.px(640), pad = theme.px(20), line = theme.px(18);
    const std::string help =
        form.trouble.empty() ? ui::sentence(field.help) : ui::sentence(printable(form.trouble));
    const auto told = ui::wrapped(theme.font.small, help, width - 2 * pad - theme.px(56));
    const float head = theme.px(56), foot = theme.px(40);
    const float words =
        theme.px(16) + line * static_cast<float>(std::max<std::size_t>(told.size(), 1));
    const float most_rows = 7;
    const float rows =
        options.empty()
            ? 0
            : theme.px(36) + theme.px(36) * std::min(static_cast<float>(options.size()), most_rows);
    const float top = std::min(theme.px(120), ImGui::GetIO().DisplaySize.y * 0.14f);
    // The dialog darkens nothing: the picture shows the filled-in command.
    const ui::Rect r =
        ui::begin_dialog(theme, "command palette", {width, head + words + rows + foot},
                         {.from_top = top, .scrim = 0});
    bool changed = false;
    const auto field_clicked =
        draw_form_line(palette, theme, {r.lo, {r.hi.x, r.lo.y + head}}, changed);
    float y = r.lo.y + head + theme.px(8);
    ui::paint_text(theme.font.small, {{r.lo.x, y}, {r.hi.x - pad, y + line}}, theme.color.text_3,
                   fmt::format("{} of {}", form.at + 1, form.fields.size()), ui::Align::right);
    for (const std::string& each : told) {
        ui::paint_text(theme.font.small, {{r.lo.x + pad, y}, {r.hi.x, y + line}},
                       form.trouble.empty() ? theme.color.text_2 : theme.color.bad, each);
        y += line;
    }
    if (changed) form.chosen.reset();
    if (changed) options = options_of(form, document);
    auto taken = taken_option(form, options, document);
    const bool down = ImGui::IsKeyPressed(ui::key_down), up = ImGui::IsKeyPressed(ui::key_up);
    const auto was = taken;
    if (!options.empty() && down) taken = taken ? std::min(*taken + 1, options.size() - 1) : 0;
    if (!options.empty() && up && taken) taken = *taken > 0 ? *taken - 1 : 0;
    bool option_clicked = false;
    if (rows > 0 && !options.empty()) {
        const ui::Rect place = {{r.lo.x, r.lo.y + head + words}, {r.hi.x, r.hi.y - foot}};
        const auto clicked = draw_rows(theme, place, rows_of(options, document), taken, down || up);
        option_clicked = clicked.has_value();
    }
    if (taken != was) form.chosen = taken;
    draw_palette_hints(theme, {{r.lo.x, r.hi.y - foot}, r.hi},
                       {{{"Enter"}, "Run"},
                        {{"Tab"}, "Next value"},
                        {{"Shift", "Tab"}, "Back"},
                        {{"Esc"}, "Cancel"}});
    if (changed || taken != was) show_filling(editor);
    const bool tab = ImGui::IsKeyPressed(ui::key_tab, false);
    const bool enter = ImGui::IsKeyPressed(ui::key_enter, false) ||
                       ImGui::IsKeyPressed(ui::key_keypad_enter, false);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const bool beside =
        ImGui::IsMouseClicked(ImGuiMouseButton_Left) && !r.contains({mouse.x, mouse.y});
    bool back = false;
    if (field_clicked) {
        form.at = *field_clicked;
        form.chosen.reset();
        palette.fresh = true;
    } else if (tab || option_clicked) {
        back = !next_field(editor, ImGui::GetIO().KeyShift ? -1 : 1);
    }
    if (enter && run_filled(editor))
        palette.open = false;
    else if (beside || ImGui::IsKeyPressed(ui::key_escape, false)) {
        leave_filling(editor);
        palette.open = false;
    } else if (back) { // to the list
        leave_filling(editor);
        palette.fresh = true;
    }
    if (!palette.open) ImGui::CloseCurrentPopup();
    ui::end_dialog();
}

} // namespace trivar
