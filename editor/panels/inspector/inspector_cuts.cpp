// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/inspector_cuts.h"

#include "core/commands/cut.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/inspect.h"
#include "editor/tools/drawn_cut.h"
#include "ui/icons.h"

#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

enum class CutPress { none, flip, remove };

// The name of a cut with buttons that flip and remove it. Returns which was pressed.
CutPress cut_row(const ui::Theme& theme, std::size_t k, const PlainCut& cut)
{
    const float side = theme.size.row, edge = theme.px(12);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x - 2 * side - theme.px(8);
    ImGui::Dummy({width, side});
    ui::name_text(theme.font.strong, ui::rect_at({at.x + edge, at.y}, {width - edge, side}),
                  theme.color.text,
                  fmt::format("{} {}", cut.stroke.empty() ? "Plane" : "Stroke", k + 1));
    CutPress out = CutPress::none;
    ImGui::SetCursorScreenPos({at.x + width + theme.px(4), at.y});
    if (ui::icon_button(theme, "flip cut", ui::icon::reset, {side, side},
                        {"Flip this cut", {}, "Above and below change places."}))
        out = CutPress::flip;
    ImGui::SetCursorScreenPos({at.x + width + theme.px(4) + side, at.y});
    if (ui::icon_button(theme, "remove cut", ui::icon::trash, {side, side},
                        {"Remove this cut", {}, "The object is not cut there any more."}))
        out = CutPress::remove;
    ImGui::SetCursorScreenPos({at.x, at.y + side + theme.px(2)});
    ImGui::Dummy({1, 0});
    return out;
}

} // namespace

void draw_cuts(Editor& editor, const ui::Theme& theme, Id id)
{
    if (!ui::section(theme, "Cuts")) return;
    Session& session = editor.session;
    Cutting cutting = *object(session.document(), id).cutting;
    const KeyGutter keys(editor, {id});
    ValueRows rows{theme, &keys};
    for (std::size_t k = 0; k < cutting.cuts.size(); ++k) {
        ImGui::PushID(static_cast<int>(k));
        const CutPress pressed = cut_row(theme, k, cutting.cuts[k]);
        FieldRows<PlainCut> fields(rows, cutting.cuts[k], fmt::format("cutting.cuts.{}", k));
        fields(&PlainCut::keep);
        if (cutting.cuts[k].keep == CutKeep::both) fields(&PlainCut::gap);
        fields(&PlainCut::point);
        fields(&PlainCut::normal);
        ImGui::PopID();
        if (pressed == CutPress::none) continue;
        if (pressed == CutPress::remove) {
            session.run(RemoveCut{id, static_cast<int>(k) + 1});
        } else {
            cutting.cuts[k] = flipped(cutting.cuts[k]);
            session.run(CutThrough{{id}, cutting});
        }
        return;
    }
    ui::gap(theme, 8);
    FieldRows<Cutting> fields(rows, cutting, "cutting");
    fields(&Cutting::capped);
    fields(&Cutting::inside);
    if (std::ranges::any_of(cutting.cuts, [](const PlainCut& cut) { return !cut.stroke.empty(); }))
        fields(&Cutting::tolerance);
    const auto shown = session.evaluated().objects.find(id);
    if (shown != session.evaluated().objects.end() && shown->second->pieces > 0)
        ui::fact_row(theme, "Pieces", fmt::format("{}", shown->second->pieces), theme.color.text,
                     "into which its parts are cut");
    ui::gap(theme, 8);
    propose_edit(editor, rows.edit, [&] { return CutThrough{{id}, cutting}; });
}

} // namespace trivar
