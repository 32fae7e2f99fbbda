// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/commands/new_material.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/inspect.h"
#include "editor/panels/panels.h"
#include "editor/session/session_facts.h"
#include "editor/tools/motion.h"
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
        if (!object(document, id).stroke && !locked(document, id)) out.push_back(id);
    return out;
}

void transforms(Editor& editor, const ui::Theme& theme)
{
    const std::vector<Id> ids = movable(editor.session);
    if (ids.empty() || !ui::section(theme, "Transform")) return;
    std::vector<Transform> all;
    for (const Id id : ids) all.push_back(object(editor.session.document(), id).transform);
    const KeyGutter keys(editor, ids);
    ValueRows rows{theme, &keys};
    Transform active = all.back(); // from which a drag begins
    FieldRows<Transform> fields(rows, active, "transform", all);
    fields(&Transform::translation);
    fields(&Transform::rotation_deg);
    fields(&Transform::scale);
    for (Transform& each : all) fields.put_into(each);
    ui::gap(theme, 8);
    propose_edit(editor, rows.edit, [&] { return arranged(ids, all); });
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
    if (ui::check_box(theme, "own", own, "original materials") == ui::Edit::changed) {
        if (own)
            editor.session.run(ClearMaterial{ids});
        else
            editor.session.run(SetMaterial{ids, new_material});
        return;
    }
    if (!same) ui::fact_row(theme, "Values", "mixed");
    if (!own) {
        Surfacing s = *active.surfacing;
        const ui::Edit edit = draw_surfacing(editor, theme, ids, s);
        propose_edit(editor, edit, [&] { return SetMaterial{ids, s}; });
    }
    ui::gap(theme, 8);
}

void facts(Editor& editor, const ui::Theme& theme)
{
    if (!ui::section(theme, "Shape")) return;
    const Session& session = editor.session;
    const Members members(session.document(), session.selected.ids());
    std::size_t faces = 0, vertices = 0, curves = 0;
    for (const auto& [id, effects] : session.evaluated().objects) {
        if (!members.contain(id)) continue;
        for (const Part& part : effects->parts) {
            faces += part.face_count();
            vertices += part.vertex_count();
        }
        for (const CurvePart& part : effects->curves) curves += part.curves->line_count();
    }
    if (vertices + curves == 0) {
        const auto seen = [&](Id id) { return visible(session.document(), id); };
        const bool any = std::ranges::any_of(session.selected.ids(), seen);
        return ui::fact_row(theme, "Size", any ? "not there yet" : "hidden");
    }
    const glm::dvec3 size = bounds_of(session, session.selected.ids()).size();
    if (size.x >= 0)
        ui::fact_row(theme, "Size",
                     fmt::format("{} × {} × {} m", ui::short_number(size.x),
                                 ui::short_number(size.y), ui::short_number(size.z)));
    ui::fact_row(theme, "Faces", ui::with_commas(faces));
    ui::fact_row(theme, "Vertices", ui::with_commas(vertices));
    if (curves > 0) ui::fact_row(theme, "Curves", ui::with_commas(curves));
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
        for (const Id id : session.selected.ids()) count += object(document, id).stroke ? 1 : 0;
        return count == 0 ? std::string()
                          : fmt::format("{} on {}", count, count == 1 ? "a stroke" : "strokes");
    }();
    ui::fact_row(theme, fmt::format("{} objects", session.selected.size()), placed);
    ui::fact_row(theme, "Active", active->name);
    ui::gap(theme, 8);
    transforms(editor, theme);
    std::vector<Id> placed_ids;
    for (const Id id : session.selected.ids())
        if (object(session.document(), id).stroke) placed_ids.push_back(id);
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
