// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/inspector_incisions.h"

#include "core/commands/incise.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/incision_rows.h"
#include "editor/panels/inspector/inspect.h"
#include "editor/panels/inspector/wound_section.h"
#include "editor/tools/seen_cut.h"
#include "ui/icons.h"
#include "ui/sentence.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

using Outcome = IncisingEffects::OfIncision;

std::string name_of_incision(const NamedIncision& incision, int number)
{
    return incision.name.empty() ? fmt::format("Incision {}", number) : incision.name;
}

// A change of an incision that leaves its stroke as it is.
EditIncision edit_of_numbers(Id id, int number, NamedIncision incision)
{
    incision.cut.stroke.clear();
    return {id, number, std::move(incision)};
}

const Outcome* outcome_of(const Session& session, Id id, int number)
{
    const auto shown = session.evaluated().objects.find(id);
    const auto index = static_cast<std::size_t>(number) - 1;
    if (shown == session.evaluated().objects.end() || index >= shown->second->incisions.size())
        return nullptr;
    return &shown->second->incisions[index];
}

constexpr double hardly_narrowed = 0.995; // share of the width

// An incision with buttons that turn it off and heal it; a click on its name chooses it. True: the
// incisions have changed.
bool incision_row(Editor& editor, const ui::Theme& theme, Id id, int number,
                  const NamedIncision& incision)
{
    Session& session = editor.session;
    const ChosenIncision own{id, number};
    const bool open = session.incision == own;
    const Outcome* outcome = outcome_of(session, id, number);
    const bool trouble = outcome && !incision.hidden &&
                         (!outcome->refusal.empty() || !outcome->shortfall.empty() ||
                          outcome->widest < hardly_narrowed);
    const float side = theme.size.row, edge = theme.px(12);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x - 2 * side - theme.px(8);
    ImGui::PushID(number);
    if (ImGui::InvisibleButton("incision", {width, side}))
        session.incision = open ? ChosenIncision{} : own;
    ui::tooltip({open ? "Close" : "Select this incision",
                 {},
                 open ? "" : "Its numbers are shown here, and its handles in the picture."});
    const ui::Color color = incision.hidden ? theme.color.text_3 : theme.color.text;
    const ui::Rect row = ui::rect_at({at.x + edge, at.y}, {width - edge, side});
    ui::paint_text(theme.font.body, row, theme.color.text_3,
                   open ? ui::icon::open : ui::icon::closed);
    const float mark = trouble ? theme.px(20) : 0;
    ui::name_text(open ? theme.font.strong : theme.font.body,
                  {row.lo + glm::vec2(theme.px(16), 0), row.hi - glm::vec2(mark, 0)}, color,
                  name_of_incision(incision, number));
    if (trouble)
        ui::paint_text(theme.font.body, row, theme.color.warn, ui::icon::warning, ui::Align::right);
    bool changed = false;
    ImGui::SetCursorScreenPos({at.x + width + theme.px(4), at.y});
    if (ui::icon_button(theme, "incision off", incision.hidden ? ui::icon::hidden : ui::icon::eye,
                        {side, side},
                        {incision.hidden ? "Turn this incision on" : "Turn this incision off",
                         {},
                         "The skin is as if it were not there."})) {
        NamedIncision other = incision;
        other.hidden = !other.hidden;
        changed = session.run(edit_of_numbers(id, number, std::move(other)));
    }
    ImGui::SetCursorScreenPos({at.x + width + theme.px(4) + side, at.y});
    if (ui::icon_button(theme, "heal incision", ui::icon::trash, {side, side},
                        {"Heal this incision", {}, "It is removed; the others stay."})) {
        changed = session.run(RemoveIncision{id, number});
        if (session.incision.object == id && session.incision.number >= number)
            session.incision = session.incision == own
                                   ? ChosenIncision{}
                                   : ChosenIncision{id, session.incision.number - 1};
    }
    ImGui::SetCursorScreenPos({at.x, at.y + side + theme.px(2)});
    ImGui::Dummy({1, 0});
    ImGui::PopID();
    return changed;
}

void warning_lines(const ui::Theme& theme, const std::string& words)
{
    const float edge = theme.px(12), icon = theme.px(22);
    const float width = ImGui::GetContentRegionAvail().x - 2 * edge - icon;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float line = theme.px(18);
    float y = at.y + theme.px(2);
    ui::paint_text(theme.font.body, ui::rect_at({at.x + edge, y}, {icon, line}), theme.color.warn,
                   ui::icon::warning);
    for (const std::string& each : ui::wrapped(theme.font.body, words, width)) {
        ui::paint_text(theme.font.body, ui::rect_at({at.x + edge + icon, y}, {width, line}),
                       theme.color.text_2, each);
        y += line;
    }
    ImGui::Dummy({1, y - at.y + theme.px(2)});
}

// The section of the chosen incision, and what it was made of.
struct SeenSection {
    IncisedSkin skin;
    Ref<EvaluatedObject> shown;
    NamedIncision incision;
    std::vector<IncisionLayer> layers;
    WoundSection section;
};

// Draws the incision unrolled, where it is seen.
void section_row(Editor& editor, ValueRows& rows, Id id, NamedIncision& incision)
{
    const ui::Theme& theme = rows.theme;
    const Session& session = editor.session;
    auto& kept = editor.memory.of<SeenSection>();
    const std::vector<IncisionLayer>& layers = object(session.document(), id).incising->layers;
    kept.skin.look(session, id);
    if (!kept.shown || kept.shown != kept.skin.shown() || kept.incision != incision ||
        kept.layers != layers) {
        kept.shown = kept.skin.shown();
        kept.incision = incision;
        kept.layers = layers;
        kept.section = section_of(kept.skin, incision, layers);
    }
    if (!(kept.section.length > 0)) return;
    ui::gap(theme, 4);
    ImGui::SetCursorScreenPos(
        {ImGui::GetWindowPos().x + theme.size.padding, ImGui::GetCursorScreenPos().y});
    const float width =
        ImGui::GetWindowWidth() - 2 * theme.size.padding - theme.px(ui::key_gutter - 12);
    rows.take(draw_wound_section(theme, kept.section, incision.cut, width));
    ui::gap(theme, 8);
}

// What became of it.
void outcome_rows(const ui::Theme& theme, const Outcome& outcome, const NamedIncision& incision)
{
    if (!outcome.refusal.empty())
        return warning_lines(theme, "It is left out: " + outcome.refusal + ".");
    if (!outcome.shortfall.empty())
        warning_lines(theme, incision.cut.floor == Incision::Floor::through
                                 ? "It does not go through: " + outcome.shortfall + "."
                                 : "It keeps its piece: " + outcome.shortfall + ".");
    const auto metres = [](double value) { return ui::short_number(value) + " m"; };
    ui::fact_row(theme, "Length", metres(outcome.length), theme.color.text, "of its stroke");
    if (outcome.depth < 0.98 * incision.cut.depth)
        ui::fact_row(theme, "Depth here", metres(outcome.depth), theme.color.text,
                     "as far as there is body below it");
    if (outcome.widest < hardly_narrowed)
        warning_lines(theme, fmt::format("It opens to {:.0f} % of its width, as its walls would "
                                         "meet beyond. Reduce its width or its depth.",
                                         100 * outcome.widest));
}

// Turns it round, copies it, or heals it. True: the incisions have changed.
bool incision_buttons(Session& session, const ui::Theme& theme, Id id, int number,
                      const NamedIncision& incision)
{
    ui::gap(theme, 4);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float edge = theme.px(12), gap = theme.px(6);
    const float half =
        (ImGui::GetContentRegionAvail().x - edge - theme.px(ui::key_gutter) - gap) / 2;
    ImGui::SetCursorScreenPos({at.x + edge, at.y});
    bool changed = false;
    if (ui::button(theme, "Reverse", ui::ButtonKind::plain, {half, theme.size.row}))
        changed = session.run(EditIncision{id, number, reversed(incision)});
    ui::tooltip({"Reverse", {}, "Its end becomes its start; it looks the same."});
    ImGui::SetCursorScreenPos({at.x + edge + half + gap, at.y});
    if (ui::button(theme, "Mirror copy", ui::ButtonKind::plain, {half, theme.size.row})) {
        const auto count = static_cast<int>(object(session.committed(), id).incising->cuts.size());
        changed = session.run(Incise{id, mirrored(incision)});
        if (changed) session.incision = {id, count + 1};
    }
    ui::tooltip({"Mirror copy", {}, "Another one like it on the other side of the model's X = 0."});
    ui::gap(theme, 6);
    return changed;
}

// True: the incisions have changed.
bool chosen_incision(Editor& editor, const ui::Theme& theme, Id id, int number,
                     const NamedIncision& before, const KeyGutter& keys)
{
    Session& session = editor.session;
    NamedIncision incision = before;
    ValueRows rows{theme, &keys};
    const ui::Row name = ui::label_row(theme, "Name", false, "what it is called");
    rows.take(ui::text_field(theme, "name", incision.name, fmt::format("Incision {}", number),
                             name.width));
    if (!before.hidden) section_row(editor, rows, id, incision);
    draw_incision_rows(rows, incision, number, editor.memory.of<ChosenCutPoints>());
    if (const Outcome* outcome = outcome_of(session, id, number); outcome && !before.hidden)
        outcome_rows(theme, *outcome, before);
    propose_edit(editor, rows.edit, [&] { return edit_of_numbers(id, number, incision); });
    return incision_buttons(session, theme, id, number, before);
}

// One layer of the walls. Returns whether it shall go.
bool layer_rows(ValueRows& rows, IncisionLayer& layer, std::size_t k, bool last)
{
    const ui::Theme& theme = rows.theme;
    ImGui::PushID(static_cast<int>(k));
    const float side = theme.size.row, edge = theme.px(12);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x - side - theme.px(8);
    ImGui::SetCursorScreenPos({at.x + edge, at.y});
    rows.take(ui::text_field(theme, "layer name", layer.name, fmt::format("Layer {}", k + 1),
                             width - edge));
    ImGui::SetCursorScreenPos({at.x + width + theme.px(4), at.y});
    const bool removed =
        ui::icon_button(theme, "remove layer", ui::icon::trash, {side, side},
                        {"Remove this layer", {}, "The layers below it begin where it began."});
    ImGui::SetCursorScreenPos({at.x, at.y + side + theme.px(4)});
    ImGui::Dummy({1, 0});
    FieldRows<IncisionLayer> fields(rows, layer, "");
    if (!last) fields(&IncisionLayer::depth);
    FieldRows<Surfacing> look(rows, layer.look, fmt::format("incising.layers.{}", k));
    look(&Surfacing::base_color);
    look(&Surfacing::filling);
    if (layer.look.filling == Filling::none) look(&Surfacing::roughness);
    ui::gap(theme, 4);
    ImGui::PopID();
    return removed;
}

// A body as it usually is: skin, fat and flesh, to the depth of the deepest incision.
std::vector<IncisionLayer> usual_layers(const Incising& incising)
{
    double deepest = 0;
    for (const NamedIncision& each : incising.cuts) deepest = std::max(deepest, each.cut.depth);
    const auto share = [&](double s) { return std::round(s * deepest * 1e5) / 1e5; };
    return {{"Skin", share(0.12), {{0.62f, 0.3f, 0.24f, 1}, 0, 0.5f}},
            {"Fat", share(0.4), {{0.86f, 0.7f, 0.33f, 1}, 0, 0.45f}},
            {"Flesh", deepest, {{0.42f, 0.05f, 0.04f, 1}, 0, 0.35f}}};
}

void draw_layers(Editor& editor, const ui::Theme& theme, Id id, const Incising& before,
                 const KeyGutter& keys)
{
    Session& session = editor.session;
    Incising incising = before;
    incising.cuts.clear();
    ValueRows rows{theme, &keys};
    std::optional<std::size_t> gone;
    for (std::size_t k = 0; k < incising.layers.size(); ++k)
        if (layer_rows(rows, incising.layers[k], k, k + 1 == incising.layers.size())) gone = k;
    const ui::Row at = ui::label_row(theme, "Walls", false,
                                     "what all walls show, from the skin down; without layers "
                                     "they look as the skin above");
    const bool none = incising.layers.empty();
    const bool add = ui::button(theme, none ? "Add layers" : "Add a layer", ui::ButtonKind::plain,
                                {at.width, theme.size.row});
    FieldRows<Incising> fields(rows, incising, "incising");
    fields(&Incising::rows);
    if (gone || add) {
        if (gone) {
            incising.layers.erase(incising.layers.begin() + static_cast<long>(*gone));
        } else if (none) {
            incising.layers = usual_layers(before);
        } else { // the last one gets a floor of its own
            IncisionLayer next = incising.layers.back();
            next.name.clear();
            next.depth *= 1.5;
            incising.layers.push_back(next);
        }
        session.run(LayerIncisions{{id}, incising});
        return;
    }
    propose_edit(editor, rows.edit, [&] { return LayerIncisions{{id}, incising}; });
}

} // namespace

void draw_incisions(Editor& editor, const ui::Theme& theme, Id id)
{
    Session& session = editor.session;
    const Incising incising = *object(session.document(), id).incising;
    const KeyGutter keys(editor, {id});
    if (ui::section(theme, "Incisions", true, fmt::format("{}", incising.cuts.size()),
                    theme.color.text_3)) {
        for (std::size_t k = 0; k < incising.cuts.size(); ++k) {
            const int number = static_cast<int>(k) + 1;
            if (incision_row(editor, theme, id, number, incising.cuts[k])) return;
            if (session.incision != ChosenIncision{id, number}) continue;
            ImGui::PushID(number);
            const bool changed = chosen_incision(editor, theme, id, number, incising.cuts[k], keys);
            ImGui::PopID();
            if (changed) return;
        }
        ui::gap(theme, 8);
    }
    if (ui::section(theme, "Incision layers", false)) {
        draw_layers(editor, theme, id, incising, keys);
        ui::gap(theme, 8);
    }
}

} // namespace trivar
