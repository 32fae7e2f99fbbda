// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/bind.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/material.h"
#include "core/commands/objects/view.h"
#include "editor/panels/inspector/inspect.h"

#include "core/base/number_text.h"
#include "core/document/parameters.h"
#include "core/scene/log.h"
#include "editor/actions/left_behind.h"
#include "editor/actions/remedies.h"
#include "editor/commands/clipboard.h"
#include "editor/commands/new_material.h"
#include "editor/panels/inspector/field_cells.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/inspector_sections.h"
#include "editor/panels/panels.h"
#include "editor/session/scene_facts.h"
#include "editor/session/session_facts.h"
#include "ui/icons.h"
#include "ui/sentence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

void object_card(const ui::Theme& theme, const Object& each)
{
    const ui::Palette& c = theme.color;
    ui::gap(theme, 4);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float left = ImGui::GetWindowPos().x + theme.size.padding;
    const float width = ImGui::GetWindowWidth() - 2 * theme.size.padding;
    const ui::Rect r = ui::rect_at({left, at.y}, {width, theme.px(32)});
    ui::paint_box(r, c.field, theme.size.rounding);
    const ui::Rect in = {r.lo + glm::vec2(theme.px(10), 0), r.hi - glm::vec2(theme.px(10), 0)};
    ui::paint_text(theme.font.body, in, c.accent_text, icon_of(each));
    const float type = ui::text_width(theme.font.small, type_of(each));
    ui::name_text(theme.font.strong,
                  {in.lo + glm::vec2(theme.px(24), 0), in.hi - glm::vec2(type + theme.px(12), 0)},
                  c.text, each.name);
    ui::paint_text(theme.font.small, in, c.text_2, type_of(each), ui::Align::right);
    ImGui::SetCursorScreenPos(at);
    ImGui::Dummy({1, theme.px(32)});
    ui::gap(theme, 8);
}

// Whose notices are shown in full.
struct UnfoldedNotices {
    Id of = 0;
};

// At the foot of the panel, where they do not move the fields that the hand is on: the first of
// them, and all once they are asked for. What one click can do about one is on a button. Returns
// the height that they take.
float draw_notices(Editor& editor, const ui::Theme& theme, const ui::Rect& panel, Id id,
                   const std::vector<std::string>& notices)
{
    if (notices.empty()) return 0;
    constexpr std::size_t few = 2;
    Id& unfolded = editor.memory.of<UnfoldedNotices>().of;
    const std::size_t count = notices.size() <= few || unfolded == id ? notices.size() : 1;
    const float pad = theme.size.padding, line = theme.px(20), between = theme.px(4);
    const float indent = theme.px(24), width = panel.width() - 2 * pad - indent;
    const float button_height = theme.size.row + between;
    struct Shown {
        std::vector<std::string> lines;
        std::optional<Remedy> remedy;
    };
    std::vector<Shown> shown;
    float height = 2 * theme.px(8) - between;
    for (std::size_t i = 0; i < count; ++i) {
        shown.push_back({ui::wrapped(theme.font.body, ui::sentence(notices[i]), width),
                         remedy_of(editor.session.document(), id, notices[i])});
        height += line * static_cast<float>(shown.back().lines.size()) + between;
        if (shown.back().remedy) height += button_height;
    }
    if (notices.size() > few) height += button_height;
    const float most = std::round(panel.height() * 0.4f), taken = std::min(height, most);
    const ui::Rect r = {{panel.lo.x, panel.hi.y - taken}, panel.hi};
    begin_panel("inspector notices", r, theme.color.panel, height > most);
    ui::paint_box({r.lo, {r.hi.x, r.lo.y + theme.size.hairline}}, theme.color.line);
    float y = ImGui::GetCursorScreenPos().y + theme.px(8);
    const auto pressed = [&](const std::string& words) {
        ImGui::SetCursorScreenPos({r.lo.x + pad + indent, y});
        y += button_height;
        return ui::button(theme, words, ui::ButtonKind::plain, {width, theme.size.row});
    };
    for (const Shown& each : shown) {
        ui::paint_text(theme.font.body, ui::rect_at({r.lo.x + pad, y}, {indent, line}),
                       theme.color.warn, ui::icon::warning);
        for (const std::string& words : each.lines) {
            ui::paint_text(theme.font.body, ui::rect_at({r.lo.x + pad + indent, y}, {width, line}),
                           theme.color.text_2, words);
            y += line;
        }
        if (each.remedy && pressed(each.remedy->words)) editor.session.run(each.remedy->command);
        y += between;
    }
    if (notices.size() > few &&
        pressed(unfolded == id ? "Show one of them"
                               : fmt::format("Show {} more", notices.size() - 1)))
        unfolded = unfolded == id ? 0 : id;
    ImGui::SetCursorScreenPos({r.lo.x, r.lo.y});
    ImGui::Dummy({1, height});
    ImGui::End();
    return taken;
}

// Where an imported model comes from, and how smooth its cage is drawn.
void draw_file(Editor& editor, const ui::Theme& theme, const ImportedFile& file, Id id)
{
    const float width = ui::label_row(theme, "File").width;
    const std::string name = std::filesystem::path(file.path).filename().string();
    const std::string shown = ui::elided(theme.font.body, name, width - theme.px(84));
    if (ui::button(theme, shown, ui::ButtonKind::plain, {width, theme.size.row}, nullptr,
                   "Replace..."))
        editor.files.ask_relink(id);
    ui::tooltip({file.path, {}, "Click to take another file."});
    EditImport edit{id, file};
    const KeyGutter keys(editor, {id});
    ValueRows rows{theme, &keys};
    FieldRows<ImportedFile>(rows, edit.file, "shape")(&ImportedFile::subdivisions);
    propose_edit(editor, rows.edit, [&] { return edit; });
}

void facts(Editor& editor, const ui::Theme& theme, const Object& each, Id id)
{
    if (!ui::section(theme, "Shape")) return;
    if (const auto* file = std::get_if<ImportedFile>(&each.source))
        draw_file(editor, theme, *file, id);
    const Document& document = editor.session.document();
    if (kind_of(each).holds_others) {
        const auto inside = [&](const auto& other) {
            return other.first != id && belongs_to(document, other.first, id);
        };
        ui::fact_row(
            theme, "Objects",
            with_commas(static_cast<std::size_t>(std::ranges::count_if(document.objects, inside))));
    }
    shape_rows(editor.session, theme, {id});
    ui::gap(theme, 8);
}

} // namespace

void shape_rows(const Session& session, const ui::Theme& theme, const std::vector<Id>& ids)
{
    const Document& document = session.document();
    const Members members(document, ids);
    std::size_t faces = 0, vertices = 0, curves = 0;
    for (const auto& [id, effects] : session.evaluated().objects) {
        if (!members.contain(id)) continue;
        for (const Part& part : effects->parts) {
            faces += part.face_count();
            vertices += part.vertex_count();
        }
        for (const CurvePart& part : effects->curves) curves += part.curves->line_count();
    }
    Box box;
    if (vertices + curves > 0)
        box = bounds_of(session, ids);
    else // of volume data that are shown by lines and rays alone
        for (const glm::dvec3& p : points_of(session, ids)) box.add(p);
    const glm::dvec3 size = box.size();
    const auto is_seen = [&](Id id) { return visible(document, id); };
    const auto holds = [&](Id id) { return kind_of(document, id).holds_others; };
    ui::fact_row(theme, "Size",
                 !box.empty() ? fmt::format("{} × {} × {} m", number_text(size.x),
                                            number_text(size.y), number_text(size.z))
                 : std::ranges::none_of(ids, is_seen) ? "hidden"
                 : std::ranges::all_of(ids, holds)    ? "nothing to see"
                                                      : "not there yet");
    ui::fact_row(theme, "Faces", with_commas(faces));
    ui::fact_row(theme, "Vertices", with_commas(vertices));
    ui::fact_row(theme, "Curves", with_commas(curves));
}

ui::Edit axis_fields(const ui::Theme& theme, float width, ui::NumberStyle style,
                     const AxisField& field)
{
    const FieldCells cells(theme, width, 3);
    const ui::Palette& c = theme.color;
    const std::array<ui::Color, 3> colors{c.letter_x, c.letter_y, c.letter_z};
    const std::array<const char*, 3> names{"X", "Y", "Z"};
    ui::Edit edit = ui::Edit::none;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    for (int axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<std::size_t>(axis);
        const glm::vec2 off = cells.offset(axis);
        ImGui::SetCursorScreenPos({at.x + off.x, at.y + off.y});
        style.axis = names.at(k);
        style.axis_color = colors.at(k);
        const ui::Edit one = field(axis, style, cells.width);
        if (one != ui::Edit::none) edit = one;
    }
    return edit;
}

void copy_command(Editor& editor, const Command& command)
{
    ImGui::SetClipboardText(command_line(command).c_str());
    editor.session.notices.say(ui::NoticeKind::good, "The command was copied",
                               "Paste it into the field of the log to run it.", of_clipboard);
}

void bind_row(Editor& editor, const ui::Theme& theme, const char* label, Id id)
{
    const std::vector<Id> others = can_be_bound_to(editor, {id});
    std::vector<std::string> names{"(deleted)"};
    for (const Id other : others) names.push_back(name_of(editor.session.document(), other));
    const ui::Row at = ui::label_row(theme, label, false, "choose what takes its place");
    int chosen = 0;
    if (ui::choice(theme, label, chosen, names, at.width) == ui::Edit::changed && chosen > 0)
        editor.session.run(Bind{{id}, {}, others[static_cast<std::size_t>(chosen - 1)]});
}

void propose_edit(Editor& editor, ui::Edit edit, const std::function<Command()>& command)
{
    if (edit == ui::Edit::copied) return copy_command(editor, command());
    if (edit == ui::Edit::none || editor.session.committing()) return;
    if (edit == ui::Edit::cancelled) {
        editor.session.cancel();
        editor.inspecting = false;
    } else if (editor.session.propose(command())) {
        editor.inspecting = true;
    }
}

void finish_edit(Editor& editor)
{
    if (!editor.inspecting || ImGui::IsAnyItemActive()) return;
    editor.inspecting = false;
    const auto& now = editor.session.document();
    const Document before = document_at(editor.session.committed(), editor.session.frame());
    // A drag that came back to where it began is no step.
    bool changed = *now.render != *before.render || now.time != before.time ||
                   now.kept_views != before.kept_views || *now.tracks != *before.tracks ||
                   now.objects.size() != before.objects.size();
    for (const auto& [id, each] : now.objects) {
        if (changed) break;
        const auto found = before.objects.find(id);
        changed =
            found == before.objects.end() || (each != found->second && !(*each == *found->second));
    }
    if (changed)
        editor.session.commit();
    else
        editor.session.cancel();
}

void draw_transform(Editor& editor, const ui::Theme& theme, Id id)
{
    const Object& each = object(editor.session.document(), id);
    if (!ui::section(theme, "Transform", !each.stroke)) return;
    Transform t = each.transform;
    const KeyGutter keys(editor, {id});
    ValueRows rows{theme, &keys};
    FieldRows<Transform> fields(rows, t, "transform");
    if (!each.stroke) { // the stroke says where a placed object is
        fields(&Transform::translation);
        fields(&Transform::rotation_deg);
    }
    fields(&Transform::scale);
    const ui::Row row = ui::label_row(theme, "Uniform scale", false, "one factor along X, Y and Z");
    double uniform = t.scale.x;
    const bool mixed = t.scale != glm::dvec3(uniform);
    const ui::Edit one =
        ui::number_field(theme, "uniform", uniform,
                         {.lo = 1e-6, .hi = 1e6, .words = mixed ? "mixed" : ""}, row.width);
    if (one == ui::Edit::changed) t.scale = glm::dvec3(uniform);
    rows.take(one);
    ui::gap(theme, 8);
    propose_edit(editor, rows.edit, [&] { return SetTransform{id, t}; });
}

namespace {

// The rows of a plain material.
ui::Edit draw_surfacing(Editor& editor, const ui::Theme& theme, std::vector<Id> ids, Surfacing& s)
{
    const KeyGutter keys(editor, std::move(ids));
    ValueRows rows{theme, &keys};
    FieldRows<Surfacing> fields(rows, s, "material");
    fields(&Surfacing::base_color);
    double opacity = 100 * static_cast<double>(s.base_color.a);
    rows.number("Opacity", opacity, 100, {.lo = 0, .hi = 100, .bar_hi = 100, .unit = "%"},
                {"below 100 % what is behind shows through", std::string("material.base_color.w")});
    s.base_color.a = static_cast<float>(opacity / 100);
    fields(&Surfacing::filling);
    ui::rows_if(theme, s.filling == Filling::none, "Solid textures have their own.", [&] {
        fields(&Surfacing::metallic);
        fields(&Surfacing::roughness);
    });
    fields(&Surfacing::glow);
    return rows.edit;
}

} // namespace

void draw_materials(Editor& editor, const ui::Theme& theme, std::vector<Id> ids)
{
    const auto& objects = editor.session.document().objects;
    std::erase_if(ids, [&](Id id) { return !kind_of(*objects.at(id)).has_surface; });
    if (ids.empty() || !ui::section(theme, "Material")) return;
    const Ref<Object> active = objects.at(ids.back()); // edits replace it while we read
    const bool same = std::ranges::all_of(
        ids, [&](Id id) { return objects.at(id)->surfacing == active->surfacing; });
    const bool original = !active->surfacing.has_value();
    const auto use = [&](bool theirs, const Surfacing& surfacing) {
        return theirs ? Command(ClearMaterial{ids}) : SetMaterial{ids, surfacing};
    };
    Surfacing s = active->surfacing.value_or(new_material);
    bool now = original;
    ui::label_row(theme, "Use", false, "use the file's materials, or override them with one");
    const ui::Edit turned = ui::check_box(theme, "own", now, "original materials");
    if (ids.size() > 1) ui::fact_row(theme, "Values", same ? "equal" : "mixed");
    ui::Edit edit = ui::Edit::none;
    ui::rows_if(theme, !original, "The original materials are used.",
                [&] { edit = draw_surfacing(editor, theme, ids, s); });
    ui::gap(theme, 8);
    if (turned == ui::Edit::copied) return copy_command(editor, use(now, s));
    if (turned == ui::Edit::changed)
        editor.session.run(use(now, new_material));
    else
        propose_edit(editor, edit, [&] { return use(false, s); });
}

void draw_material(Editor& editor, const ui::Theme& theme, Id id)
{
    draw_materials(editor, theme, {id});
}

void draw_picture_settings(Editor& editor, const ui::Theme& theme)
{
    using R = RenderSettings;
    if (!ui::section(theme, "Picture")) return;
    R s = *editor.session.document().render;
    const KeyGutter keys(editor, {0});
    ValueRows rows{theme, &keys};
    FieldRows<R> fields(rows, s, "render");
    fields(&R::look);
    fields(&R::color_by);
    fields(&R::exposure);
    fields(&R::sun_azimuth);
    fields(&R::sun_elevation);
    for (const auto on_or_off :
         {&R::shadows, &R::ambient_occlusion, &R::wire, &R::volumes, &R::captions, &R::ground})
        fields(on_or_off);
    ui::gap(theme, 8);
    propose_edit(editor, rows.edit, [&] { return SetRender{s}; });
}

void draw_inspector(Editor& editor, const ui::Theme& theme, const Layout& layout)
{
    const Id id = editor.session.selected;
    ui::Rect fields = layout.inspector;
    const auto effects = editor.session.evaluated().objects.find(id);
    if (effects != editor.session.evaluated().objects.end())
        fields.hi.y -= draw_notices(editor, theme, layout.inspector, id, effects->second->notices);
    begin_panel("inspector", fields, theme.color.panel, true);
    ui::offer_commands();
    if (editor.panel == Editor::Panel::dock && editor.show_focus && !ImGui::IsAnyItemActive() &&
        ImGui::IsKeyPressed(ui::key_tab, false))
        ui::type_next_number();
    const auto& objects = editor.session.document().objects;
    const auto found = objects.find(id);
    if (found == objects.end()) {
        const ui::Rect& r = layout.inspector;
        const bool nothing = objects.empty();
        if (!nothing) draw_picture_settings(editor, theme);
        if (!nothing) draw_kept_view(editor, theme);
        const float top = nothing ? r.lo.y : ImGui::GetCursorScreenPos().y;
        const float end = nothing ? std::min(r.hi.y, top + theme.px(220)) : top + theme.px(200);
        ui::empty_state(theme, {{r.lo.x, top}, {r.hi.x, end}}, ui::icon::sliders,
                        nothing ? "Nothing to change yet" : "Nothing selected",
                        nothing ? "Drop a model into the window, or add an object with " +
                                      key_text(action(editor, add_action_name)) + "."
                                : "Click an object, or a row of the outliner, to see what can be "
                                  "changed.");
        if (!nothing) ImGui::Dummy({1, theme.px(200)});
        ImGui::End();
        return;
    }
    if (editor.session.selected.size() > 1) {
        draw_several(editor, theme);
        ImGui::End();
        return;
    }
    const Ref<Object> each = found->second; // edits replace it while we read
    ImGui::PushID(id);
    object_card(theme, *each);
    for (const InspectorSection& section : inspector_sections())
        if (editor.session.document().objects.contains(id) &&
            section.applies(editor.session.document(), id))
            section.draw(editor, theme, id);
    if (editor.session.document().objects.contains(id)) facts(editor, theme, *each, id);
    ImGui::PopID();
    ImGui::End();
}

} // namespace trivar
