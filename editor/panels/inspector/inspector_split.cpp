// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/inspector_split.h"

#include "core/base/number_text.h"
#include "core/commands/cutting/split.h"
#include "core/split/split_field.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/inspect.h"
#include "editor/session/scene_facts.h"
#include "ui/icons.h"

#include <algorithm>
#include <imgui.h>

namespace trivar {
namespace {

// The name of an obstacle with a button that removes it. Returns whether that was pressed.
bool obstacle_row(const Session& session, const ui::Theme& theme, const ObstacleUse& use)
{
    return ui::list_row(
               theme, {.name = name_of(session.document(), use.object), .font = theme.font.strong},
               {{"remove obstacle",
                 ui::icon::trash,
                 {"Remove this obstacle", {}, "The object is not parted by it any more."}}})
        .has_value();
}

} // namespace

void draw_split(Editor& editor, const ui::Theme& theme, Id id)
{
    if (!ui::section(theme, "Split")) return;
    Session& session = editor.session;
    Splitting splitting = *object(session.document(), id).splitting;
    ValueRows rows{theme};
    for (std::size_t k = 0; k < splitting.obstacles.size(); ++k) {
        ImGui::PushID(static_cast<int>(k));
        ObstacleUse& use = splitting.obstacles[k];
        const bool removed = obstacle_row(session, theme, use);
        FieldRows<ObstacleUse> fields(rows, use, "");
        fields(&ObstacleUse::clearance);
        fields(&ObstacleUse::reach);
        fields(&ObstacleUse::kernel);
        ImGui::PopID();
        if (!removed) continue;
        splitting.obstacles.erase(splitting.obstacles.begin() + static_cast<long>(k));
        session.run(splitting.obstacles.empty() ? Command(ClearSplit{{id}})
                                                : Split{{id}, splitting});
        return;
    }
    ui::gap(theme, 8);
    FieldRows<Splitting> fields(rows, splitting, "splitting");
    fields(&Splitting::closing);
    fields(&Splitting::ends);
    fields(&Splitting::inside);
    fields(&Splitting::tolerance);
    fields(&Splitting::opening);
    fields(&Splitting::way);
    const auto shown = session.evaluated().objects.find(id);
    const bool known = shown != session.evaluated().objects.end() && shown->second->split_field;
    double widest = 0;
    if (known)
        for (const Opening& opening : shown->second->split_field->openings)
            widest = std::max(widest, opening.walls[0].most + opening.walls[1].most);
    ui::fact_row(theme, "Opens by", known ? ui::short_number(widest) + " m" : "", theme.color.text,
                 "the widest gap between its halves, at most");
    ui::fact_row(
        theme, "Error",
        known ? "at most " + number_text(shown->second->split_off, {.digits = 2}) + " m" : "",
        theme.color.text, "proven: no triangle is further from the true walls at this frame");
    ui::gap(theme, 8);
    propose_edit(editor, rows.edit, [&] { return Split{{id}, splitting}; });
}

} // namespace trivar
