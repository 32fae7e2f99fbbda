// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/arrange.h"
#include "core/document/document_digest.h"
#include "editor/panels/panels.h"
#include "editor/session/scene_facts.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <imgui.h>
#include <imgui_stdlib.h>

namespace trivar {
namespace {

using Column = OutlinerState::Column;

void rename_field(Editor& editor, const ui::Theme& theme, const ui::Rect& at)
{
    OutlinerState& o = editor.outliner;
    ImGui::SetCursorScreenPos({at.lo.x, at.lo.y});
    ImGui::SetNextItemWidth(at.width());
    const ImGuiID begun = ImGui::GetID("renaming");
    if (!ImGui::GetStateStorage()->GetBool(begun)) ImGui::SetKeyboardFocusHere();
    ImGui::GetStateStorage()->SetBool(begun, true);
    ImGui::InputText("##name", &o.new_name, ImGuiInputTextFlags_AutoSelectAll);
    ui::paint_rim(at, theme.color.focus, theme.size.rounding_small, 1.5f * theme.scale);
    if (!ImGui::IsItemDeactivated()) return;
    ImGui::GetStateStorage()->SetBool(begun, false);
    const Id id = std::exchange(o.renaming, 0);
    const bool cancelled = ImGui::IsKeyPressed(ui::key_escape, false);
    if (!cancelled && !o.new_name.empty() && o.new_name != name_of(editor.session.document(), id))
        editor.session.run(Rename{id, o.new_name});
}

// A click selects, with Ctrl it adds or removes, with Shift it selects all from the active one.
void select_row(Session& session, Id id, const std::vector<OutlineRow>& rows)
{
    const ImGuiIO& io = ImGui::GetIO();
    const Id active = session.selected;
    const auto from = std::ranges::find(rows, active, &OutlineRow::id);
    const auto to = std::ranges::find(rows, id, &OutlineRow::id);
    if (io.KeyShift && from != rows.end()) {
        std::vector<Id> ids;
        for (auto it = std::min(from, to); it <= std::max(from, to); ++it) ids.push_back(it->id);
        if (!io.KeyCtrl) session.selected = 0;
        session.selected.add(ids);
        session.selected.add({active}); // the next range begins there again
    } else if (io.KeyCtrl) {
        session.selected.toggle(id);
    } else {
        session.selected = id;
    }
}

bool state_of(const Object& object, Column column)
{
    return column == Column::eye ? object.hidden : object.locked;
}

// Shows what letting go would do: of all that were met, those that differ.
void propose_painted(Editor& editor)
{
    const OutlinerState& o = editor.outliner;
    const Document& before = editor.session.committed();
    std::vector<Id> ids;
    for (const Id id : o.painted)
        if (before.objects.contains(id) && state_of(object(before, id), o.painting) != o.paint)
            ids.push_back(id);
    if (ids.empty()) return editor.session.cancel();
    if (o.painting == Column::eye)
        editor.session.propose(o.paint ? Command(Hide{ids}) : Command(Show{ids}));
    else
        editor.session.propose(o.paint ? Command(Lock{ids}) : Command(Unlock{ids}));
}

// Only this one is seen; where that is so already, all are.
void show_only(Session& session, Id id)
{
    const Show only{.objects = {id}, .only = true};
    const Document& now = session.committed();
    if (digest(after(now, only)) != digest(now)) {
        session.run(only);
        return;
    }
    std::vector<Id> hidden;
    for (const auto& [each, ref] : now.objects)
        if (ref->hidden) hidden.push_back(each);
    if (!hidden.empty()) session.run(Show{hidden});
}

// The eye or the lock of a row; a press begins to paint, and a hand that comes down paints it too.
void column_cell(Editor& editor, const ui::Theme& theme, const ui::Rect& cell, Column column,
                 const Object& each, Id id, ui::Color color, bool shown)
{
    OutlinerState& o = editor.outliner;
    const bool on = state_of(each, column), eye = column == Column::eye;
    ImGui::SetCursorScreenPos({cell.lo.x, cell.lo.y});
    ImGui::InvisibleButton(eye ? "eye" : "lock", {cell.width(), cell.height()});
    const bool hot = ImGui::IsItemHovered();
    if (ImGui::IsItemActivated() && !editor.session.committing()) {
        if (eye && ImGui::GetIO().KeyAlt) {
            show_only(editor.session, id);
        } else {
            o.painting = column;
            o.paint = !on;
            o.painted = {id};
            propose_painted(editor);
        }
    }
    const float y = ImGui::GetIO().MousePos.y;
    if (o.painting == column && y >= cell.lo.y && y < cell.hi.y &&
        std::ranges::find(o.painted, id) == o.painted.end()) {
        o.painted.push_back(id);
        propose_painted(editor);
    }
    if (hot) ui::paint_box(cell, theme.color.field_hover, theme.size.rounding_small);
    if (shown || hot || on) {
        const char* icon = eye ? (on ? ui::icon::hidden : ui::icon::eye)
                               : (on ? ui::icon::lock : ui::icon::open_lock);
        ui::paint_text(theme.font.body, cell, hot ? theme.color.text : color, icon,
                       ui::Align::center);
    }
    if (o.painting != Column::none) return;
    if (eye)
        ui::tooltip({on ? "Show" : "Hide",
                     {},
                     "Drag down to do it to more rows; Alt shows only this one."});
    else
        ui::tooltip(
            {on ? "Unlock" : "Lock", {}, "Locked objects cannot be picked, moved or deleted."});
}

const EvaluatedObject* effects_of(const Session& session, Id id)
{
    const auto found = session.evaluated().objects.find(id);
    return found == session.evaluated().objects.end() ? nullptr : found->second.get();
}

// Returns why the object shows nothing; empty: it is shown.
std::string trouble_of(const Session& session, Id id)
{
    const EvaluatedObject* effects = effects_of(session, id);
    if (!effects) return {};
    if (!effects->rejected.empty()) return effects->rejected;
    return effects->shows_nothing() && !effects->notices.empty() ? effects->notices.front() : "";
}

} // namespace

bool draw_outline_row(Editor& editor, const ui::Theme& theme, const std::vector<OutlineRow>& rows,
                      std::size_t index, const ui::Rect& place)
{
    const ui::Palette& c = theme.color;
    const OutlineRow& row = rows[index];
    Session& session = editor.session;
    OutlinerState& o = editor.outliner;
    if (!session.document().objects.contains(row.id)) return false; // undone in this very frame
    const Ref<Object> held = session.document().objects.at(row.id); // a rename replaces it
    const Object& each = *held;
    const bool selected = session.selected.contains(row.id);
    const bool active = session.selected == row.id;
    const bool seen = visible(session.document(), row.id) && row.found &&
                      !std::ranges::binary_search(session.hidden_here, row.id);
    const ui::Rect band = {place.lo + glm::vec2(theme.px(4), 0),
                           place.hi - glm::vec2(theme.px(4), 0)};
    ImGui::PushID(row.id);
    bool menu = false;
    const glm::vec2 square(theme.size.icon_button);
    const float lock = place.hi.x - theme.px(34), eye = lock - theme.px(22);
    const float left = place.lo.x + theme.px(6) + theme.px(16) * static_cast<float>(row.depth);
    if (row.group) { // before the row, which it lies on
        ImGui::SetCursorScreenPos({left, place.lo.y});
        if (ImGui::InvisibleButton("open", {theme.px(18), place.height()})) {
            if (row.open)
                o.closed.insert(row.id);
            else
                o.closed.erase(row.id);
        }
        ui::tooltip({row.open ? "Close the group" : "Open the group"});
    }
    const float from = row.group ? left + theme.px(18) : place.lo.x;
    ImGui::SetCursorScreenPos({from, place.lo.y});
    const bool clicked =
        ImGui::InvisibleButton("row", {std::max(1.0f, eye - from), place.height()});
    if (clicked && o.dragged.empty()) select_row(session, row.id, rows);
    if (ImGui::IsItemActive() && o.dragged.empty() && ImGui::IsMouseDragging(0))
        o.dragged = selected ? session.selected.ids() : std::vector<Id>{row.id};
    const bool hovered = ImGui::IsItemHovered() && o.dragged.empty();
    if (hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        o.renaming = row.id;
        o.new_name = each.name;
    }
    if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
        if (selected)
            session.selected.add({row.id});
        else
            session.selected = row.id;
        menu = true;
    }
    const bool keyboard = editor.panel == Editor::Panel::outliner;
    if (selected)
        ui::paint_box(band, c.row_selected, theme.size.rounding_small);
    else if (hovered)
        ui::paint_box(band, c.row_hover, theme.size.rounding_small);
    if (active && keyboard && editor.show_focus)
        ui::paint_rim(band, c.focus, theme.size.rounding_small, 1.5f * theme.scale);
    // "Off" cannot be read on the selection's blue.
    const ui::Color off = selected ? c.text_2 : c.text_off;
    const ui::Color quiet = !seen ? off : selected ? c.text : c.text_2;
    if (row.group)
        ui::paint_text(theme.font.body, {{left, place.lo.y}, {left + theme.px(16), place.hi.y}},
                       quiet, row.open ? ui::icon::open : ui::icon::closed, ui::Align::center);
    float x = left + theme.px(18);
    const std::string trouble = trouble_of(session, row.id);
    ui::paint_text(theme.font.body, {{x, place.lo.y}, place.hi}, trouble.empty() ? quiet : c.bad,
                   trouble.empty() ? icon_of(each) : ui::icon::warning);
    x += theme.px(22);
    const std::string type = type_of(each);
    const float type_x = eye - theme.px(8) - ui::text_width(theme.font.small, type);
    if (o.renaming == row.id) {
        rename_field(editor, theme,
                     {{x - theme.px(6), place.lo.y}, {eye - theme.px(4), place.hi.y}});
    } else {
        const ImFont* font = active ? theme.font.strong : theme.font.body;
        const std::string shown = ui::elided(font, each.name, type_x - x - theme.px(8));
        if (!trouble.empty())
            ui::tooltip({each.name, {}, trouble});
        else if (shown != each.name)
            ui::tooltip({each.name});
        ui::paint_text(font, {{x, place.lo.y}, place.hi}, seen ? c.text : off, shown);
        ui::paint_text(theme.font.small, {{type_x, place.lo.y}, place.hi},
                       !seen      ? off
                       : selected ? c.text_2
                                  : c.text_3,
                       type);
    }
    // The eye shows the object's own state: bright even if its group is hidden.
    const ui::Color own = selected ? c.text : c.text_2;
    column_cell(editor, theme, ui::rect_at({eye, place.lo.y}, square), Column::eye, each, row.id,
                each.hidden ? off : own, true);
    column_cell(editor, theme, ui::rect_at({lock, place.lo.y}, square), Column::lock, each, row.id,
                each.locked ? own : off, selected);
    ImGui::PopID();
    return menu;
}

} // namespace trivar
