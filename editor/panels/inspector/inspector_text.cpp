// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/objects/text.h"
#include "core/text/installed_fonts.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/inspect.h"
#include "editor/panels/inspector/letters_as_read.h"
#include "editor/panels/panels.h"

#include <algorithm>
#include <imgui.h>
#include <imgui_stdlib.h>

namespace trivar {
namespace {

// Others than spaces; what is no UTF-8 is for the command to refuse.
bool lacks_letters(const std::string& text)
{
    try {
        return !has_letters(text);
    } catch (const Rejected&) {
        return false;
    }
}

// Several lines: Enter begins a new one.
ui::Edit letters_field(const ui::Theme& theme, std::string& text)
{
    const float width = ImGui::GetWindowWidth() - 2 * theme.size.padding;
    ImGui::SetCursorScreenPos(
        {ImGui::GetWindowPos().x + theme.size.padding, ImGui::GetCursorScreenPos().y});
    const std::string before = text;
    const bool changed =
        ImGui::InputTextMultiline("##letters", &text, {width, 3.2f * theme.size.row});
    const ImVec2 lo = ImGui::GetItemRectMin(), hi = ImGui::GetItemRectMax();
    const bool waits = changed && lacks_letters(text);
    if (waits) { // for what is typed next: the scene keeps its own meanwhile
        text = before;
        ui::paint_text(
            theme.font.small, {{lo.x + theme.px(8), hi.y - theme.size.row}, {hi.x, hi.y}},
            theme.color.warn, "Type some letters; until then the scene keeps the old text");
    }
    ui::gap(theme, 6);
    return changed && !waits ? ui::Edit::changed : ui::Edit::none;
}

struct FontTitles { // looked for when a text is first shown
    std::vector<std::string> titles;
};

void font_row(Editor& editor, ValueRows& rows, TextShape& s)
{
    std::vector<std::string>& fonts = editor.memory.of<FontTitles>().titles;
    if (fonts.empty())
        for (const InstalledFont& font : installed_fonts()) {
            const std::string title = font.title();
            if (fonts.empty() || fonts.back() != title) fonts.push_back(title);
        }
    std::vector<std::string> words = fonts;
    auto at = std::ranges::find(words, s.font);
    if (at == words.end()) at = words.insert(words.begin(), s.font); // a family, a file, a lost one
    int chosen = static_cast<int>(at - words.begin());
    const int shown = chosen;
    rows.take(ui::choice(
        rows.theme, "font", chosen, words,
        ui::label_row(rows.theme, "Font", false, facts_of(&TextShape::font).help).width));
    if (chosen == shown) return;
    s.font = words[static_cast<std::size_t>(chosen)];
    s = prepare(SetText{0, s}, *editor.session.assets()).get<SetText>().shape;
}

} // namespace

void draw_text(Editor& editor, const ui::Theme& theme, Id id)
{
    if (!ui::section(theme, "Text")) return;
    TextShape s = *made_of<TextShape>(editor.session.document(), id);
    const KeyGutter keys(editor, {id});
    ValueRows rows{theme, &keys};
    rows.take(letters_field(theme, s.text));
    const auto effects = editor.session.evaluated().objects.find(id);
    if (!field_shows(s.text) && effects != editor.session.evaluated().objects.end() &&
        !effects->second->parts.empty())
        draw_letters_as_read(theme, *effects->second->parts.front().rest, s.size);
    font_row(editor, rows, s);
    FieldRows<TextShape> fields(rows, s, "shape");
    fields(&TextShape::size);
    fields(&TextShape::depth);
    fields(&TextShape::bevel);
    fields(&TextShape::bevel_steps);
    fields(&TextShape::tolerance);
    fields(&TextShape::max_edge);
    fields(&TextShape::letter_spacing);
    fields(&TextShape::line_spacing);
    fields(&TextShape::align);
    ui::gap(theme, 8);
    propose_edit(editor, rows.edit, [&] { return SetText{id, s}; });
}

} // namespace trivar
