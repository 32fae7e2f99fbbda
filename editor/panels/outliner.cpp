// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/letters_in_order.h"
#include "editor/panels/panels.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <imgui.h>
#include <imgui_stdlib.h>

namespace trivar {
namespace {

struct Entry {
    Id id = 0;
    int depth = 0;
};
void gather(const Document& document, Id parent, int depth, std::vector<Entry>& entries)
{
    constexpr int deepest = 64; // deeper ones are still in the scene, only not indented
    for (const auto& [id, each] : document.objects) {
        if (each->parent != parent || id == parent) continue;
        entries.push_back({id, std::min(depth, deepest)});
        if (std::holds_alternative<GroupShape>(each->source))
            gather(document, id, depth + 1, entries);
    }
}

void rename_field(Editor& editor, const ui::Theme& theme, const ui::Rect& at)
{
    ImGui::SetCursorScreenPos({at.lo.x, at.lo.y});
    ImGui::SetNextItemWidth(at.width());
    const bool fresh = !ImGui::GetStateStorage()->GetBool(ImGui::GetID("renaming"));
    if (fresh) ImGui::SetKeyboardFocusHere();
    ImGui::GetStateStorage()->SetBool(ImGui::GetID("renaming"), true);
    ImGui::InputText("##name", &editor.new_name, ImGuiInputTextFlags_AutoSelectAll);
    ui::paint_rim(at, theme.color.focus, theme.size.rounding_small, 1.5f * theme.scale);
    if (!ImGui::IsItemDeactivated()) return;
    ImGui::GetStateStorage()->SetBool(ImGui::GetID("renaming"), false);
    const Id id = std::exchange(editor.renaming, 0);
    const bool cancelled = ImGui::IsKeyPressed(ui::key_escape, false);
    if (!cancelled && !editor.new_name.empty() &&
        editor.new_name != name_of(editor.session.document(), id))
        editor.session.run(Rename{id, editor.new_name});
}

void row_menu(Editor& editor, const ui::Theme& theme)
{
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {theme.px(8), theme.px(8)});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {theme.px(10), theme.px(8)});
    if (ImGui::BeginPopup("row menu")) {
        for (const char* name : {"Frame selection", "Rename", "Duplicate", "Group", "Ungroup",
                                 "Hide or show", "Take off the stroke", "Delete"}) {
            const Action& each = action(editor, name);
            if (ImGui::MenuItem(name, key_text(each).c_str(), false, is_enabled(editor, each)))
                each.run(editor);
        }
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar(2);
}

// A click selects, with Ctrl it adds or removes, with Shift it selects all from the active one.
void select_row(Session& session, Id id, const std::vector<Entry>& entries)
{
    const ImGuiIO& io = ImGui::GetIO();
    const Id active = session.selected;
    const auto is = [](Id wanted) { return [wanted](const Entry& e) { return e.id == wanted; }; };
    auto from = std::find_if(entries.begin(), entries.end(), is(active));
    auto to = std::find_if(entries.begin(), entries.end(), is(id));
    if (io.KeyShift && from != entries.end()) {
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

// One row: triangle, icon, name, type, eye. Returns whether its menu was asked for.
bool draw_row(Editor& editor, const ui::Theme& theme, const std::vector<Entry>& entries,
              const Entry& entry, const ui::Rect& row)
{
    const ui::Palette& c = theme.color;
    Session& session = editor.session;
    const Ref<Object> held = session.document().objects.at(entry.id); // a rename replaces it
    const Object& each = *held;
    const bool selected = session.selected.contains(entry.id);
    const bool active = session.selected == entry.id;
    const bool seen = visible(session.document(), entry.id);
    const ui::Rect band = {row.lo + glm::vec2(theme.px(4), 0), row.hi - glm::vec2(theme.px(4), 0)};
    ImGui::PushID(entry.id);
    const float eye = row.hi.x - theme.px(36);
    ImGui::SetCursorScreenPos({row.lo.x, row.lo.y});
    if (ImGui::InvisibleButton("row", {eye - row.lo.x, row.height()}))
        select_row(session, entry.id, entries);
    const bool hovered = ImGui::IsItemHovered();
    bool menu = false;
    if (hovered && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        editor.renaming = entry.id;
        editor.new_name = each.name;
    }
    if (hovered && ImGui::IsMouseClicked(ImGuiMouseButton_Right)) {
        if (selected)
            session.selected.add({entry.id});
        else
            session.selected = entry.id;
        menu = true;
    }
    if (selected)
        ui::paint_box(band, c.row_selected, theme.size.rounding_small);
    else if (hovered)
        ui::paint_box(band, c.row_hover, theme.size.rounding_small);
    float x = row.lo.x + theme.px(16) + theme.px(16) * static_cast<float>(entry.depth);
    // "Off" cannot be read on the selection's blue.
    const ui::Color off = selected ? c.text_2 : c.text_off;
    const ui::Color quiet = !seen ? off : selected ? c.text : c.text_2;
    ui::paint_text(theme.font.body, {{x, row.lo.y}, row.hi}, quiet, icon_of(each));
    x += theme.px(24);
    const std::string type = type_of(each);
    const float type_x = eye - theme.px(8) - ui::text_width(theme.font.small, type);
    if (editor.renaming == entry.id) {
        rename_field(editor, theme, {{x - theme.px(6), row.lo.y}, {eye - theme.px(4), row.hi.y}});
    } else {
        const ImFont* font = active ? theme.font.strong : theme.font.body;
        ui::paint_text(font, {{x, row.lo.y}, row.hi}, seen ? c.text : off,
                       ui::elided(font, each.name, type_x - x - theme.px(8)));
        ui::paint_text(theme.font.small, {{type_x, row.lo.y}, row.hi},
                       !seen      ? off
                       : selected ? c.text_2
                                  : c.text_3,
                       type);
    }
    ImGui::SetCursorScreenPos({eye, row.lo.y});
    const glm::vec2 square(theme.size.icon_button);
    if (ui::icon_button(theme, "eye", each.hidden ? ui::icon::hidden : ui::icon::eye, square,
                        each.hidden ? "Show" : "Hide")) {
        if (each.hidden)
            session.run(Show{{entry.id}});
        else
            session.run(Hide{{entry.id}});
    }
    ImGui::PopID();
    return menu;
}

} // namespace

const char* icon_of(const Object& object)
{
    if (object.placement) return ui::icon::place;
    return std::holds_alternative<GroupShape>(object.source) ? ui::icon::group : ui::icon::mesh;
}

std::string type_of(const Object& object)
{
    if (object.placement) return "Placed";
    if (std::holds_alternative<GroupShape>(object.source)) return "Group";
    return std::holds_alternative<ImportedFile>(object.source) ? "Model" : "Primitive";
}

void draw_outliner(Editor& editor, const ui::Theme& theme, const Layout& layout)
{
    const ui::Palette& c = theme.color;
    const ui::Rect& r = layout.outliner;
    begin_panel("outliner", r, c.panel);
    const float pad = theme.size.padding;
    ui::paint_text(theme.font.strong, {r.lo + glm::vec2(pad, 0), {r.hi.x, r.lo.y + theme.px(40)}},
                   c.text, "Outliner");
    ImGui::SetCursorScreenPos({r.lo.x + pad, r.lo.y + theme.px(40)});
    ui::text_field(theme, "filter", editor.filter, "Filter by name", r.width() - 2 * pad,
                   ui::icon::search);

    std::vector<Entry> entries;
    gather(editor.session.document(), 0, 0, entries);
    std::erase_if(entries, [&](const Entry& e) {
        return !letters_in_order(editor.filter, name_of(editor.session.document(), e.id));
    });
    const ui::Rect list = {{r.lo.x, r.lo.y + theme.px(72)}, r.hi};
    if (entries.empty()) {
        const bool nothing = editor.session.document().objects.empty();
        ui::empty_state(theme, list, nothing ? ui::icon::volume : ui::icon::search,
                        nothing ? "Nothing here yet" : "Nothing is called that",
                        nothing ? "Drop a model, or add one from the Add menu."
                                : "Clear the filter to see everything.");
        ImGui::End();
        return;
    }
    ImGui::SetCursorScreenPos({list.lo.x, list.lo.y});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    ImGui::BeginChild("rows", {list.width(), list.height()});
    const float top = ImGui::GetCursorScreenPos().y, height = theme.size.row;
    bool menu = false;
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(entries.size()), height);
    while (clipper.Step())
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            const float y = top + height * static_cast<float>(i);
            const bool asked =
                draw_row(editor, theme, entries, entries[static_cast<std::size_t>(i)],
                         {{list.lo.x, y}, {list.hi.x, y + height}});
            menu = menu || asked;
        }
    if (menu) ImGui::OpenPopup("row menu");
    ImGui::PopStyleVar();
    row_menu(editor, theme);
    ImGui::EndChild();
    ImGui::End();
}

} // namespace trivar
