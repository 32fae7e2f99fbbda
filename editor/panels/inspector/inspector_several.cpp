// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/motion.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/inspect.h"
#include "editor/panels/panels.h"
#include "editor/session/session_facts.h"
#include "ui/icons.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

// Returns the objects whose own transform can change: they do not lie on a stroke and are not
// locked.
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
    const auto has_clips = [&](Id id) { return kind_of(session.document(), id).has_clips; };
    if (std::ranges::all_of(session.selected.ids(), has_clips))
        draw_clip(editor, theme, {session.selected.ids().begin(), session.selected.ids().end()});
    const std::vector<Id> ids(session.selected.ids().begin(), session.selected.ids().end());
    draw_materials(editor, theme, ids);
    std::vector<Id> with_faces;
    for (const Id id : ids)
        if (kind_of(session.document(), id).has_surface) with_faces.push_back(id);
    draw_shading(editor, theme, with_faces);
    if (ui::section(theme, "Shape")) shape_rows(session, theme, ids);
}

} // namespace trivar
