// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/commands/new_material.h"
#include "editor/panels/inspector/inspect.h"
#include "editor/panels/inspector/key_gutter.h"
#include "editor/panels/panels.h"
#include "editor/session/session_facts.h"
#include "editor/tools/motion.h"
#include "editor/words/field_words.h"
#include "ui/icons.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

// Those that have a transform of their own to change: not what lies on a stroke or is locked.
std::vector<Id> movable(const Session& session)
{
    const Document& document = session.document();
    std::vector<Id> out;
    for (const Id id : topmost(document, session.selected.ids()))
        if (!object(document, id).placement && !locked(document, id)) out.push_back(id);
    return out;
}

// One number of all: what they have in common, or "mixed". What is typed or dragged is what all
// get.
ui::Edit shared_number(const ui::Theme& theme, const std::string& id, std::vector<double*> values,
                       ui::NumberStyle style, float width)
{
    bool same = true;
    for (const double* value : values) same = same && *value == *values.front();
    double shown = *values.back(); // the active one's, from which a drag begins
    if (!same) style.words = "mixed";
    const ui::Edit edit = ui::number_field(theme, id, shown, style, width);
    if (edit == ui::Edit::changed)
        for (double* value : values) *value = shown;
    return edit;
}

using Component = glm::dvec3 Transform::*;

ui::Edit shared_row(const ui::Theme& theme, const KeyGutter& keys, const std::string& label,
                    std::vector<Transform>& transforms, Component part,
                    const ui::NumberStyle& style, const std::string& field)
{
    const glm::dvec3 rest = Transform{}.*part;
    bool changed = false;
    for (const Transform& t : transforms) changed = changed || t.*part != rest;
    const ui::Row row = ui::label_row(theme, label, changed, help_of_field("transform", field));
    keys.mark(theme, row, axes_of("transform." + field), true);
    if (row.reset) {
        for (Transform& t : transforms) t.*part = rest;
        return ui::Edit::changed;
    }
    return axis_fields(theme, row.width, style,
                       [&](int axis, const ui::NumberStyle& own, float width) {
                           std::vector<double*> values;
                           for (Transform& t : transforms) values.push_back(&(t.*part)[axis]);
                           return shared_number(theme, label + own.axis, values, own, width);
                       });
}

void transforms(Editor& editor, const ui::Theme& theme)
{
    const std::vector<Id> ids = movable(editor.session);
    if (ids.empty() || !ui::section(theme, "Transform")) return;
    std::vector<Transform> all;
    for (const Id id : ids) all.push_back(object(editor.session.document(), id).transform);
    ui::Edit edit = ui::Edit::none;
    const auto take = [&edit](ui::Edit one) {
        if (one != ui::Edit::none) edit = one;
    };
    const KeyGutter keys(editor, ids);
    take(shared_row(theme, keys, "Position", all, &Transform::translation, {.unit = "m"},
                    "translation"));
    take(shared_row(theme, keys, "Rotation", all, &Transform::rotation_deg,
                    {.lo = -36000, .hi = 36000, .step = 1, .unit = "deg"}, "rotation_deg"));
    take(
        shared_row(theme, keys, "Scale", all, &Transform::scale, {.lo = -1e6, .hi = 1e6}, "scale"));
    ui::gap(theme, 8);
    propose_edit(editor, edit, [&] { return arranged(ids, all); });
}

void material(Editor& editor, const ui::Theme& theme)
{
    const Document& document = editor.session.document();
    std::vector<Id> ids;
    for (const Id id : editor.session.selected.ids())
        if (!holds_others(object(document, id).source)) ids.push_back(id);
    if (ids.empty() || !ui::section(theme, "Material")) return;
    const Object& active = object(document, ids.back());
    bool same = true;
    for (const Id id : ids) same = same && object(document, id).surfacing == active.surfacing;
    bool own = !active.surfacing.has_value();
    ui::label_row(theme, "Use", false, material_help);
    if (ui::check_box(theme, "own", own, "the models' own") == ui::Edit::changed) {
        if (own)
            editor.session.run(ClearMaterial{ids});
        else
            editor.session.run(SetMaterial{ids, new_material});
        return;
    }
    if (!same) ui::fact_row(theme, "Values", "mixed");
    if (!own) {
        Surfacing s = *active.surfacing;
        const KeyGutter keys(editor, ids);
        const auto row_of = [&](const char* label, const std::string& field) {
            const ui::Row row =
                ui::label_row(theme, label, false, help_of_field("set_material", field));
            keys.mark(theme, row,
                      field == "base_color" ? axes_of("material." + field)
                                            : std::vector{"material." + field});
            return row.width;
        };
        ui::Edit edit =
            ui::color_field(theme, "color", s.base_color, row_of("Colour", "base_color"));
        const auto share = [&](const char* label, const char* field, float& value) {
            double number = static_cast<double>(value);
            const ui::Edit one = ui::number_field(
                theme, label, number, {.lo = 0, .hi = 1, .bar_hi = 1}, row_of(label, field));
            value = static_cast<float>(number);
            if (one != ui::Edit::none) edit = one;
        };
        share("Metallic", "metallic", s.metallic);
        share("Roughness", "roughness", s.roughness);
        propose_edit(editor, edit, [&] { return SetMaterial{ids, s}; });
    }
    ui::gap(theme, 8);
}

void facts(Editor& editor, const ui::Theme& theme)
{
    if (!ui::section(theme, "Shape")) return;
    const Session& session = editor.session;
    const Members members(session.document(), session.selected.ids());
    std::size_t faces = 0, vertices = 0;
    for (const auto& [id, effects] : session.evaluated().objects) {
        if (!members.contain(id)) continue;
        for (const Part& part : effects->parts) {
            faces += part.rest->face_count();
            vertices += part.rest->vertex_count();
        }
    }
    if (vertices == 0) {
        const auto seen = [&](Id id) { return visible(session.document(), id); };
        const bool any = std::ranges::any_of(session.selected.ids(), seen);
        return ui::fact_row(theme, "Size", any ? "not there yet" : "hidden");
    }
    const glm::dvec3 size = bounds_of(session, session.selected.ids()).size();
    if (size.x >= 0)
        ui::fact_row(theme, "Size",
                     fmt::format("{} x {} x {} m", ui::short_number(size.x),
                                 ui::short_number(size.y), ui::short_number(size.z)));
    ui::fact_row(theme, "Faces", ui::with_commas(faces));
    ui::fact_row(theme, "Vertices", ui::with_commas(vertices));
}

} // namespace

void draw_several(Editor& editor, const ui::Theme& theme)
{
    const Session& session = editor.session;
    const Document& document = session.document();
    const Ref<Object> active = document.objects.at(session.selected);
    ui::gap(theme, 4);
    const std::string placed = [&] {
        std::size_t count = 0;
        for (const Id id : session.selected.ids()) count += object(document, id).placement ? 1 : 0;
        return count == 0 ? std::string()
                          : fmt::format("{} on {}", count, count == 1 ? "a stroke" : "strokes");
    }();
    ui::fact_row(theme, fmt::format("{} objects", session.selected.size()), placed);
    ui::fact_row(theme, "Active", active->name);
    ui::gap(theme, 8);
    transforms(editor, theme);
    std::vector<Id> placed_ids;
    for (const Id id : session.selected.ids())
        if (object(session.document(), id).placement) placed_ids.push_back(id);
    if (!placed_ids.empty()) {
        draw_travel(editor, theme, placed_ids);
        draw_refinement(editor, theme, placed_ids);
    }
    const auto imported = [&](Id id) {
        return std::holds_alternative<ImportedFile>(object(session.document(), id).source);
    };
    if (std::ranges::all_of(session.selected.ids(), imported))
        draw_clip(editor, theme, {session.selected.ids().begin(), session.selected.ids().end()});
    material(editor, theme);
    facts(editor, theme);
}

} // namespace trivar
