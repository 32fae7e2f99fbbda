// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/panels.h"
#include "editor/session/scene_facts.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

using Column = OutlinerState::Column;

// Rows in the hand: where they would go, and the step when it lets go.
void drag_rows(Editor& editor, const ui::Theme& theme, const std::vector<OutlineRow>& rows,
               const ui::Rect& list, float top)
{
    const ui::Palette& c = theme.color;
    OutlinerState& o = editor.outliner;
    if (o.dragged.empty()) return;
    if (ImGui::IsKeyPressed(ui::key_escape, false)) {
        o.dragged.clear();
        return;
    }
    const ImVec2 p = ImGui::GetIO().MousePos;
    const glm::vec2 mouse{p.x, p.y};
    const float height = theme.size.row;
    const Document& document = editor.session.committed();
    RowDrop drop = row_drop(document, rows, o.dragged, (mouse.y - top) / height);
    const bool inside = list.contains(mouse);
    if (inside && !o.filter.empty() && drop.line >= 0)
        drop.refused = "Clear the filter to change the order.";
    if (inside && drop.refused.empty() && drop.line >= 0) {
        const auto above = static_cast<std::size_t>(drop.line);
        float left = list.lo.x + theme.px(6);
        const auto parent = std::ranges::find(rows, drop.command.parent, &OutlineRow::id);
        if (parent != rows.end()) left += theme.px(16) * static_cast<float>(parent->depth + 1);
        const float y = top + height * static_cast<float>(above);
        ui::paint_box({{left, y - theme.px(1)}, {list.hi.x - theme.px(8), y + theme.px(1)}},
                      c.focus);
        ui::paint_dot({left, y}, theme.px(3), c.focus);
    }
    if (inside && drop.refused.empty() && drop.onto >= 0) {
        const float y = top + height * static_cast<float>(drop.onto);
        ui::paint_rim({{list.lo.x + theme.px(4), y}, {list.hi.x - theme.px(4), y + height}},
                      c.focus, theme.size.rounding_small, theme.px(2));
    }
    const std::string what = o.dragged.size() == 1 ? name_of(document, o.dragged.front())
                                                   : fmt::format("{} objects", o.dragged.size());
    ImGui::SetNextWindowPos({mouse.x + theme.px(14), mouse.y + theme.px(14)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme.px(10), theme.px(6)});
    ImGui::BeginTooltip();
    ImGui::TextUnformatted(ui::elided(theme.font.body, what, theme.px(220)).c_str());
    if (inside && !drop.refused.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, c.warn);
        for (const std::string& line : ui::wrapped(theme.font.body, drop.refused, theme.px(220)))
            ImGui::TextUnformatted(line.c_str());
        ImGui::PopStyleColor();
        ImGui::SetMouseCursor(ImGuiMouseCursor_NotAllowed);
    }
    ImGui::EndTooltip();
    ImGui::PopStyleVar();
    if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
    o.dragged.clear();
    if (!inside || !drop.refused.empty() || drop.command.objects.empty()) return;
    o.closed.erase(drop.command.parent); // what was put there is seen there
    editor.session.run(drop.command);
}

// Scrolls while a row is dragged near the upper or the lower edge of the list, or beyond it.
bool scroll_at_edges(const OutlinerState& o, const ui::Theme& theme, const ui::Rect& list)
{
    if (o.dragged.empty() && o.painting == Column::none) return false;
    const ImGuiIO& io = ImGui::GetIO();
    const float zone = std::min(1.5f * theme.size.row, list.height() / 3);
    const float above = list.lo.y + zone - io.MousePos.y;
    const float below = io.MousePos.y - (list.hi.y - zone);
    const float depth = above > 0 ? -above : below > 0 ? below : 0;
    if (depth == 0 || io.MousePos.x < list.lo.x || io.MousePos.x > list.hi.x) return false;
    constexpr float rows_a_second = 12; // at the edge itself
    constexpr float longest_frame_s = 0.1f;
    const float share = std::clamp(depth / zone, -2.0f, 2.0f);
    const float from = ImGui::GetScrollY();
    const float to = std::clamp(from + share * rows_a_second * theme.size.row *
                                           std::min(io.DeltaTime, longest_frame_s),
                                0.0f, ImGui::GetScrollMaxY());
    ImGui::SetScrollY(to);
    return to != from;
}

void finish_painting(Editor& editor)
{
    OutlinerState& o = editor.outliner;
    if (o.painting == Column::none) return;
    const bool cancelled = ImGui::IsKeyPressed(ui::key_escape, false);
    if (!cancelled && ImGui::IsMouseDown(ImGuiMouseButton_Left)) return;
    if (cancelled) {
        editor.session.cancel();
    } else if (editor.session.proposing()) {
        editor.session.commit();
    }
    o.painting = Column::none;
    o.painted.clear();
}

// The arrows go from row to row, into groups and out of them.
void take_keys(Editor& editor, const std::vector<OutlineRow>& rows)
{
    OutlinerState& o = editor.outliner;
    if (editor.panel != Editor::Panel::outliner || rows.empty() || o.renaming != 0 ||
        ImGui::GetIO().WantTextInput || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup))
        return;
    Session& session = editor.session;
    const auto here = std::ranges::find(rows, session.selected.active(), &OutlineRow::id);
    const auto at = here == rows.end() ? -1 : here - rows.begin();
    const auto struck = [](int key) { return ImGui::IsKeyPressed(key, true); };
    const auto go = [&](std::ptrdiff_t row) {
        const Id id =
            rows[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(row, 0, std::ssize(rows) - 1))]
                .id;
        if (ImGui::GetIO().KeyShift)
            session.selected.add({id});
        else
            session.selected = id;
    };
    if (struck(ui::key_down)) go(at + 1);
    if (struck(ui::key_up)) go(at < 0 ? std::ssize(rows) - 1 : at - 1);
    if (struck(ui::key_page_down)) go(at + 8);
    if (struck(ui::key_page_up)) go(at - 8);
    if (at < 0) return;
    const OutlineRow& row = *here;
    if (struck(ui::key_right) && row.group) {
        if (!row.open)
            o.closed.erase(row.id);
        else if (at + 1 < std::ssize(rows) && here[1].depth > row.depth)
            go(at + 1);
    }
    if (struck(ui::key_left)) {
        if (row.group && row.open && o.filter.empty())
            o.closed.insert(row.id);
        else if (const Id parent = object(session.document(), row.id).parent; parent != 0)
            session.selected = parent;
    }
    const bool enter = ImGui::IsKeyPressed(ui::key_enter, false) ||
                       ImGui::IsKeyPressed(ui::key_keypad_enter, false);
    if (enter) action(editor, "Rename").run(editor);
}

// Shows an object that was selected elsewhere: opens its groups and scrolls its row into view.
void reveal(Editor& editor)
{
    OutlinerState& o = editor.outliner;
    const auto& objects = editor.session.document().objects;
    const auto found = objects.find(editor.session.selected);
    if (found == objects.end()) return;
    for (Id id = found->second->parent; id != 0; id = object(editor.session.document(), id).parent)
        o.closed.erase(id);
}

void scroll_to(const std::vector<OutlineRow>& rows, Id id, float height)
{
    const auto found = std::ranges::find(rows, id, &OutlineRow::id);
    if (found == rows.end()) return;
    const float top = height * static_cast<float>(found - rows.begin());
    const float view = ImGui::GetWindowHeight(), scroll = ImGui::GetScrollY();
    if (top < scroll) ImGui::SetScrollY(top);
    if (top + height > scroll + view) ImGui::SetScrollY(top + height - view);
}

void draw_filter(OutlinerState& o, const ui::Theme& theme, const ui::Rect& place)
{
    ImGui::SetCursorScreenPos({place.lo.x, place.lo.y});
    if (std::exchange(o.focus_filter, false)) ImGui::SetKeyboardFocusHere();
    ui::text_field(theme, "filter", o.filter, "Filter by name or type:model", place.width(),
                   ui::icon::search);
    ui::tooltip(
        {"Filter", {}, "Letters in order are enough; type:model shows objects of one type."});
    // On Esc the text field restores the former text; here that is empty.
    if (ImGui::IsItemDeactivated() && ImGui::IsKeyPressed(ui::key_escape, false)) o.filter.clear();
}

} // namespace

void draw_outliner(Editor& editor, const ui::Theme& theme, const Layout& layout)
{
    const ui::Palette& c = theme.color;
    const ui::Rect& r = layout.outliner;
    OutlinerState& o = editor.outliner;
    begin_panel("outliner", r, c.panel);
    const float pad = theme.size.padding, height = theme.size.row;
    ui::paint_text(theme.font.strong, {r.lo + glm::vec2(pad, 0), {r.hi.x, r.lo.y + theme.px(40)}},
                   c.text, "Outliner");
    draw_filter(o, theme, {{r.lo.x + pad, r.lo.y + theme.px(40)}, {r.hi.x - pad, r.hi.y}});
    const Id active = editor.session.selected;
    const bool reveals = o.shown != active;
    if (reveals) reveal(editor);
    const std::vector<OutlineRow> rows = outline(editor.session.document(), o.filter, o.closed);
    take_keys(editor, rows);
    const ui::Rect list = {{r.lo.x, r.lo.y + theme.px(72)}, r.hi};
    if (rows.empty()) {
        const bool nothing = editor.session.document().objects.empty();
        const std::string key = key_text(action(editor, add_action_name));
        ui::empty_state(theme, list, nothing ? ui::icon::volume : ui::icon::search,
                        nothing ? "Nothing here yet"
                                : "Nothing is called '" +
                                      ui::elided(theme.font.strong, o.filter, theme.px(120)) + "'",
                        !nothing      ? ""
                        : key.empty() ? "Drop a model, or add one from the Add menu."
                                      : "Drop a model, or add one with " + key + ".");
        const float wide = ui::button_width(theme, "Clear");
        ImGui::SetCursorScreenPos(
            {std::round(list.center().x - wide / 2), std::round(list.center().y + theme.px(40))});
        if (!nothing && ui::button(theme, "Clear")) o.filter.clear();
        ImGui::End();
        return;
    }
    ImGui::SetCursorScreenPos({list.lo.x, list.lo.y});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    ImGui::BeginChild("rows", {list.width(), list.height()});
    if (reveals) scroll_to(rows, active, height);
    o.shown = active;
    const float top = ImGui::GetCursorScreenPos().y;
    bool menu = false;
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(rows.size()), height);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const float y = top + height * static_cast<float>(i);
            const bool asked = draw_outline_row(editor, theme, rows, static_cast<std::size_t>(i),
                                                {{list.lo.x, y}, {list.hi.x, y + height}});
            menu = menu || asked;
        }
    o.scrolling = scroll_at_edges(o, theme, list);
    drag_rows(editor, theme, rows, list, top);
    finish_painting(editor);
    if (menu) ImGui::OpenPopup("row menu");
    ImGui::PopStyleVar();
    draw_object_menu(editor, theme, "row menu");
    ImGui::EndChild();
    ImGui::End();
}

} // namespace trivar
