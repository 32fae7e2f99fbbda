// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/inspector_split.h"

#include "core/commands/split.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/inspect.h"
#include "editor/session/scene_facts.h"
#include "ui/icons.h"

#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

// The name of an obstacle with a button that removes it. Returns whether that was pressed.
bool obstacle_row(const Session& session, const ui::Theme& theme, const ObstacleUse& use)
{
    const float side = theme.size.row, edge = theme.px(12);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x - side - theme.px(8);
    ImGui::Dummy({width, side});
    ui::name_text(theme.font.strong, ui::rect_at({at.x + edge, at.y}, {width - edge, side}),
                  theme.color.text, name_of(session.document(), use.object));
    ImGui::SetCursorScreenPos({at.x + width + theme.px(4), at.y});
    const bool removed =
        ui::icon_button(theme, "remove obstacle", ui::icon::trash, {side, side},
                        {"Remove this obstacle", {}, "The object is not parted by it any more."});
    ImGui::SetCursorScreenPos({at.x, at.y + side + theme.px(2)});
    ImGui::Dummy({1, 0});
    return removed;
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
    if (shown != session.evaluated().objects.end() && shown->second->split_field) {
        double widest = 0;
        for (const Opening& opening : shown->second->split_field->openings)
            widest = std::max(widest, opening.walls[0].most + opening.walls[1].most);
        ui::fact_row(theme, "Opens by", fmt::format("{} m", ui::short_number(widest)),
                     theme.color.text, "the widest gap between its halves, at most");
        ui::fact_row(theme, "Walls off by", fmt::format("{:.2g} m", shown->second->split_off),
                     theme.color.text,
                     "proven: no triangle is further from the true walls at this frame");
    }
    ui::gap(theme, 8);
    propose_edit(editor, rows.edit, [&] { return Split{{id}, splitting}; });
}

} // namespace trivar
