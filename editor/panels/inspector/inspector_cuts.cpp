// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/inspector_cuts.h"

#include "core/base/number_text.h"
#include "core/commands/cutting/cut.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/inspect.h"
#include "editor/tools/split/drawn_cut.h"
#include "ui/icons.h"

#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

// The name of a cut with buttons that flip and remove it. Returns which was pressed.
std::optional<int> cut_row(const ui::Theme& theme, std::size_t k, const PlainCut& cut)
{
    return ui::list_row(
        theme,
        {.name = fmt::format("{} {}", cut.stroke.empty() ? "Plane" : "Stroke", k + 1),
         .font = theme.font.strong},
        {{"flip cut", ui::icon::reset, {"Flip this cut", {}, "Above and below change places."}},
         {"remove cut",
          ui::icon::trash,
          {"Remove this cut", {}, "The object is not cut there any more."}}});
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
        const std::optional<int> pressed = cut_row(theme, k, cutting.cuts[k]);
        FieldRows<PlainCut> fields(rows, cutting.cuts[k], fmt::format("cutting.cuts.{}", k));
        fields(&PlainCut::keep);
        ui::rows_if(theme, cutting.cuts[k].keep == CutKeep::both, "Only one side is kept.",
                    [&] { fields(&PlainCut::gap); });
        fields(&PlainCut::point);
        fields(&PlainCut::normal);
        ImGui::PopID();
        if (!pressed) continue;
        if (pressed == 1) {
            session.run(RemoveCut{id, static_cast<int>(k) + 1});
        } else {
            session.run(CutThrough{{id}, flipped(std::move(cutting), k)});
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
    ui::fact_row(theme, "Pieces",
                 shown != session.evaluated().objects.end() ? with_commas(shown->second->pieces)
                                                            : "",
                 theme.color.text, "into which its parts are cut");
    ui::gap(theme, 8);
    propose_edit(editor, rows.edit, [&] { return CutThrough{{id}, cutting}; });
}

} // namespace trivar
