// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/inspector_tetrahedra.h"

#include "core/base/number_text.h"
#include "core/base/rounded.h"
#include "core/commands/volumes/tetrahedra.h"
#include "core/tetrahedra/from_lattice.h"
#include "core/tetrahedra/tetrahedra_shaper.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/inspect.h"
#include "editor/panels/inspector/warp_rows.h"
#include "ui/icons.h"

#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

// EditAtHand is the edit of a volume that the rows below the list show.
struct EditAtHand {
    Id of = 0;
    std::size_t number = 0, known = 0;
};

// Follows the last edit where one was added.
std::size_t chosen_edit(EditAtHand& at_hand, Id id, std::size_t count)
{
    if (at_hand.of != id || count > at_hand.known) at_hand.number = count == 0 ? 0 : count - 1;
    at_hand.of = id;
    at_hand.known = count;
    at_hand.number = std::min(at_hand.number, count == 0 ? 0 : count - 1);
    return at_hand.number;
}

enum class RowPress { none, choose, remove };

RowPress edit_row(const ui::Theme& theme, const std::string& words, const std::string& right,
                  const std::string& note, bool chosen, bool held)
{
    const float side = theme.size.row, edge = theme.px(12);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x - side - theme.px(8);
    RowPress out = RowPress::none;
    if (ImGui::InvisibleButton("edit", {width, side})) out = RowPress::choose;
    const ui::Rect all = ui::rect_at({at.x, at.y}, {width, side});
    if (chosen || ImGui::IsItemHovered())
        ui::paint_box(all, chosen ? theme.color.row_selected : theme.color.row_hover,
                      theme.size.rounding);
    ui::name_text(chosen ? theme.font.strong : theme.font.body,
                  ui::rect_at({at.x + edge, at.y}, {width - edge - theme.px(64), side}),
                  theme.color.text, words);
    ui::name_text(theme.font.body,
                  ui::rect_at({at.x + width - theme.px(60), at.y}, {theme.px(60), side}),
                  held ? theme.color.warn : theme.color.text_3, right);
    ImGui::SetCursorScreenPos({at.x + width + theme.px(4), at.y});
    if (ui::icon_button(theme, "remove edit", ui::icon::trash, {side, side},
                        {"Remove this edit", {}, note}))
        out = RowPress::remove;
    ImGui::SetCursorScreenPos({at.x, at.y + side + theme.px(2)});
    ImGui::Dummy({1, 0});
    return out;
}

void domain_rows(ValueRows& rows, TetrahedraShape& shape)
{
    FieldRows<TetrahedraShape> fields(rows, shape, "shape");
    if (shape.cells.empty()) {
        fields.resting_at(shape.size, &TetrahedraShape::size);
        fields(&TetrahedraShape::boxes);
    }
    fields(&TetrahedraShape::degree);
    fields(&TetrahedraShape::spread);
}

void number_rows(ValueRows& rows, TetrahedraEdit& edit, std::size_t number)
{
    const std::string name = fmt::format("shape.edits.{}.", number);
    if (edit.pull) {
        FieldRows<TetrahedraPull> fields(rows, *edit.pull, name + "pull");
        fields(&TetrahedraPull::by);
        fields(&TetrahedraPull::rotation_deg);
        fields(&TetrahedraPull::factors);
        fields(&TetrahedraPull::at);
        fields(&TetrahedraPull::radius);
        fields(&TetrahedraPull::decay);
        fields(&TetrahedraPull::guard);
    } else if (edit.warp) {
        FieldRows<Warp> fields(rows, *edit.warp, name + "warp");
        fields(&Warp::axis);
        warp_rows(fields);
        fields(&Warp::guard);
    } else if (edit.cloud) {
        FieldRows<TetrahedraCloud> fields(rows, *edit.cloud, name + "cloud");
        fields(&TetrahedraCloud::by);
        fields(&TetrahedraCloud::factor);
    } else if (edit.crease) {
        FieldRows<TetrahedraCrease> fields(rows, *edit.crease, "");
        fields(&TetrahedraCrease::radius);
        fields(&TetrahedraCrease::depth);
    } else if (edit.refinement) {
        FieldRows<TetrahedraRefinement> fields(rows, *edit.refinement, "");
        fields(&TetrahedraRefinement::radius);
        fields(&TetrahedraRefinement::edge);
    }
}

void facts(const Session& session, const ui::Theme& theme, Id id)
{
    const auto found = session.evaluated().objects.find(id);
    const bool known =
        found != session.evaluated().objects.end() && found->second->tetrahedra != nullptr;
    const SimplexVolume* volume = known ? found->second->tetrahedra->volume.get() : nullptr;
    const auto count = [&](std::size_t n) { return volume ? with_commas(n) : std::string(); };
    ui::fact_row(theme, "Tetrahedra",
                 count(volume ? volume->layers.front()->domain().cells.size() : 0));
    ui::fact_row(theme, "Control points", count(volume ? volume->displacements.size() : 0));
    ui::fact_row(theme, "Refinements", count(volume ? volume->layers.size() - 1 : 0));
    const auto* shape = made_of<TetrahedraShape>(session.document(), id);
    if (!shape || shape->displaced.empty()) return; // it never was a lattice
    const bool as_it_was = is_as_converted(*shape);
    ui::fact_row(theme, "Off the lattice",
                 as_it_was ? "about " + ui::short_number(rounded_up(shape->deviation, 2)) + " m"
                           : "edited since",
                 as_it_was ? theme.color.text : theme.color.text_3,
                 "greatest distance from where the lattice took a point, by samples inside each "
                 "tetrahedron, before later edits");
}

void draw_edits(Editor& editor, const ui::Theme& theme, Id id)
{
    TetrahedraShape shape = *made_of<TetrahedraShape>(editor.session.document(), id);
    auto& at_hand = editor.memory.of<EditAtHand>();
    const std::size_t chosen = chosen_edit(at_hand, id, shape.edits.size());
    if (!ui::section(theme, "Edits")) return;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos({ImGui::GetWindowPos().x + theme.size.padding, at.y});
    if (ui::button(theme, "Bend the volume", ui::ButtonKind::plain, {})) {
        editor.session.run(EditTetrahedra{id, {.warp = Warp{.bend_deg = 30}}});
        return;
    }
    ui::gap(theme, 4);
    const auto found = editor.session.evaluated().objects.find(id);
    const Ref<ShapedTetrahedra> shown =
        found == editor.session.evaluated().objects.end() ? nullptr : found->second->tetrahedra;
    for (std::size_t i = 0; i < shape.edits.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        const bool held = shown && i < shown->outcomes.size() && shown->outcomes[i].share < 1;
        const RowPress press = edit_row(
            theme, fmt::format("{}  {}", i + 1, words_of(shape.edits[i], shape.degree)),
            held ? percent_text(shown->outcomes[i].share) : "",
            shape.edits[i].refinement ? "Pulls of the refinement are removed too; other edits stay."
                                      : "Later edits stay.",
            i == chosen, held);
        ImGui::PopID();
        if (press == RowPress::choose) at_hand.number = i;
        if (press != RowPress::remove) continue;
        editor.session.run(RemoveTetrahedraEdit{id, static_cast<int>(i) + 1});
        return;
    }
    if (shape.edits.empty()) return;
    ui::gap(theme, 8);
    const KeyGutter keys(editor, {id});
    ValueRows rows{theme, &keys};
    number_rows(rows, shape.edits[chosen], chosen);
    propose_edit(editor, rows.edit, [&] { return SetTetrahedra{id, shape}; });
    ui::gap(theme, 8);
}

} // namespace

void draw_tetrahedra(Editor& editor, const ui::Theme& theme, Id id)
{
    if (ui::section(theme, "Domain")) {
        TetrahedraShape shape = *made_of<TetrahedraShape>(editor.session.document(), id);
        const KeyGutter keys(editor, {id});
        ValueRows rows{theme, &keys};
        domain_rows(rows, shape);
        propose_edit(editor, rows.edit, [&] { return SetTetrahedra{id, shape}; });
        facts(editor.session, theme, id);
        ui::gap(theme, 8);
    }
    draw_edits(editor, theme, id);
}

void draw_simplex_sheet(Editor& editor, const ui::Theme& theme, Id id)
{
    if (!ui::section(theme, "Sheet")) return;
    auto shape = *made_of<SimplexSheetShape>(editor.session.document(), id);
    const KeyGutter keys(editor, {id});
    ValueRows rows{theme, &keys};
    FieldRows<SimplexSheetShape> fields(rows, shape, "shape");
    fields(&SimplexSheetShape::degree);
    fields(&SimplexSheetShape::spread);
    fields(&SimplexSheetShape::clamped);
    fields(&SimplexSheetShape::segments);
    propose_edit(editor, rows.edit, [&] { return SetSimplexSheet{id, shape}; });
    ui::gap(theme, 8);
}

} // namespace trivar
