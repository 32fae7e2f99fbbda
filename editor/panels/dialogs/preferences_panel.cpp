// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/use_keys.h"
#include "editor/panels/dialogs/preferences_pages.h"
#include "editor/panels/panels.h"
#include "ui/dialog.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <imgui.h>

namespace trivar {
namespace {

// In the order of their names; null: the key map, which scrolls.
using DrawPage = void (*)(Editor&, const ui::Theme&, const ui::Rect&);
constexpr std::array<DrawPage, PreferencesDialog::page_count> pages{
    draw_general_page, draw_interface_page,   draw_viewport_page,      draw_mouse_page, nullptr,
    draw_files_page,   draw_performance_page, draw_accessibility_page, draw_about_page,
};

void draw_page_names(Editor& editor, const ui::Theme& theme, const ui::Rect& r)
{
    const ui::Palette& c = theme.color;
    auto& dialog = editor.preferences_dialog;
    // Nearer to each other in a low window: all of them are seen.
    const float room = (r.height() - theme.px(24)) / static_cast<float>(pages.size());
    const float pitch = std::min(theme.px(34), std::floor(room));
    const auto place = [&](int i) {
        const float y = r.lo.y + theme.px(12) + pitch * static_cast<float>(i);
        return ui::Rect{{r.lo.x + theme.px(12), y},
                        {r.hi.x - theme.px(12), y + pitch - theme.px(2)}};
    };
    const auto turn = [&](int page) {
        dialog = {};
        dialog.open = true;
        dialog.page = page;
    };
    const bool list_open = ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId);
    if (dialog.asking.empty() && !dialog.seeking && !list_open && !ImGui::IsAnyItemActive()) {
        if (ui::struck({ui::key_up}, true)) turn(std::max(dialog.page - 1, 0));
        if (ui::struck({ui::key_down}, true))
            turn(std::min(dialog.page + 1, dialog.page_count - 1));
    }
    int hovered = -1;
    for (int i = 0; i < std::ssize(pages); ++i) {
        const ui::Rect row = place(i);
        ImGui::SetCursorScreenPos({row.lo.x, row.lo.y});
        const bool clicked =
            ImGui::InvisibleButton(preferences_page_name(i), {row.width(), row.height()});
        if (ImGui::IsItemHovered()) hovered = i;
        if (clicked) turn(i);
    }
    for (int i = 0; i < std::ssize(pages); ++i) {
        const ui::Rect row = place(i);
        const bool on = dialog.page == i;
        if (on || i == hovered)
            ui::paint_box(row, on ? c.row_selected : c.row_hover, theme.size.rounding);
        ui::paint_text(on ? theme.font.strong : theme.font.body,
                       {row.lo + glm::vec2(theme.px(12), 0), row.hi}, on ? c.text : c.text_2,
                       preferences_page_name(i));
    }
    ui::paint_box({{r.hi.x - theme.size.hairline, r.lo.y}, r.hi}, c.line_soft);
}

// Rows under each other, which scroll where there are too many of them.
void draw_rows_of_page(Editor& editor, const ui::Theme& theme, const ui::Rect& r)
{
    auto& dialog = editor.preferences_dialog;
    const DrawPage draw = pages[static_cast<std::size_t>(dialog.page)];
    if (!draw) return draw_key_map(editor, theme, r);
    ui::Theme roomy = theme; // for longer labels than the inspector's
    roomy.size.label = theme.px(140);
    ImGui::SetCursorScreenPos({r.lo.x, r.lo.y + theme.px(12)});
    ImGui::BeginChild(preferences_page_name(dialog.page), {r.width(), r.height() - theme.px(12)});
    if (dialog.resetting) ui::reset_rows();
    draw(editor, roomy, r);
    dialog.resetting = false;
    ImGui::EndChild();
}

} // namespace

void reset_preferences_page(Editor& editor)
{
    Preferences& p = editor.preferences;
    auto& dialog = editor.preferences_dialog;
    dialog.resetting = dialog.page != dialog.of_keys; // the rows
    if (dialog.page == dialog.of_interface) {         // what is dragged has no rows
        const Preferences& usual = usual_preferences();
        p.dock = usual.dock;
        p.outliner = usual.outliner;
        p.timeline = usual.timeline;
    }
    if (dialog.page != dialog.of_keys) return;
    p.keys.clear();
    use_keys(editor.actions, p.keys);
    dialog.asking.clear();
    dialog.given.clear();
}

void draw_preferences(Editor& editor, const ui::Theme& theme)
{
    auto& dialog = editor.preferences_dialog;
    if (!dialog.open) return;
    const ui::Palette& c = theme.color;
    const ui::Rect r = ui::begin_dialog(theme, "preferences", {theme.px(840), theme.px(620)});
    const float foot = theme.px(60), left = theme.px(184);
    const float pad = theme.px(24);
    // Read before the page, which takes the key that is waited for.
    const bool leave =
        dialog.asking.empty() && !dialog.seeking && ImGui::IsKeyPressed(ui::key_escape, false);
    const float y0 = ui::draw_dialog_head(theme, r, "Preferences"), y1 = r.hi.y - foot;
    draw_page_names(editor, theme, {{r.lo.x, y0}, {r.lo.x + left, y1}});
    const ui::Rect page = {{r.lo.x + left + theme.px(12), y0}, {r.hi.x - theme.px(12), y1}};
    draw_rows_of_page(editor, theme, page);
    ui::paint_box({{r.lo.x, y1}, {r.hi.x, y1 + theme.size.hairline}}, c.line_soft);
    const float y = std::round(y1 + (foot - theme.px(32)) / 2);
    ImGui::SetCursorScreenPos({r.lo.x + theme.px(16), y});
    const bool about = dialog.page == dialog.of_about;
    const std::string words = about                           ? "Copy as text"
                              : dialog.page == dialog.of_keys ? "Reset key map"
                                                              : "Reset this page";
    const float width = ui::text_width(theme.font.body, words) + theme.px(56);
    if (ui::button(theme, words, ui::ButtonKind::plain, {width, theme.px(32)},
                   about ? ui::icon::copy : ui::icon::reset)) {
        if (about)
            copy_about();
        else
            reset_preferences_page(editor);
    }
    ImGui::SetCursorScreenPos({r.hi.x - pad - theme.px(88), y});
    const bool done =
        ui::button(theme, "Done", ui::ButtonKind::primary, {theme.px(88), theme.px(32)});
    if (done || leave || !dialog.open) {
        const int shown = dialog.page;
        dialog = {};
        dialog.page = shown;
        ImGui::CloseCurrentPopup();
    }
    ui::end_dialog();
}

} // namespace trivar
