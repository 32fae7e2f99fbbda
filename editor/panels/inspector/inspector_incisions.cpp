// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/inspector_incisions.h"

#include "core/base/number_text.h"
#include "core/commands/cutting/peel.h"
#include "core/commands/edits/edits.h"
#include "editor/hands/usual_layers.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/incision_rows.h"
#include "editor/panels/inspector/inspect.h"
#include "editor/panels/inspector/wound_section.h"
#include "editor/tools/incise/seen_incision.h"
#include "ui/icons.h"
#include "ui/sentence.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>
#include <set>

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
                          !outcome->notice.empty() || outcome->widest < hardly_narrowed);
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

// SeenSection is the section of the chosen incision, with its inputs.
struct SeenSection {
    IncisedSkin skin;
    Ref<EvaluatedObject> shown;
    NamedIncision incision;
    std::vector<IncisionLayer> layers;
    WoundSection section;
};

// Draws the incision unrolled, where it is seen.
void section_row(Editor& editor, ValueRows& rows, Id id, NamedIncision& incision,
                 const Outcome* outcome)
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
    ui::gap(theme, 4);
    ImGui::SetCursorScreenPos(
        {ImGui::GetWindowPos().x + theme.size.padding, ImGui::GetCursorScreenPos().y});
    const float width =
        ImGui::GetWindowWidth() - 2 * theme.size.padding - theme.px(ui::key_gutter - 12);
    WoundSection section = kept.section;
    if (outcome && outcome->length > 0) section.length = outcome->length;
    rows.take(draw_wound_section(theme, section, incision.cut, width));
    ui::gap(theme, 8);
}

// Draws the outcome; faults are told at the foot of the panel.
void outcome_rows(const ui::Theme& theme, const Outcome* outcome)
{
    const bool cut = outcome && outcome->refusal.empty();
    const auto metres = [&](double value) {
        return cut ? ui::short_number(value) + " m" : std::string();
    };
    ui::fact_row(theme, "Length", metres(cut ? outcome->length : 0), theme.color.text,
                 "of its stroke");
    ui::fact_row(theme, "Depth here", metres(cut ? outcome->depth : 0), theme.color.text,
                 "as far as there is body below it");
    ui::fact_row(theme, "Least depth", cut ? percent_text(outcome->least_depth) : "",
                 theme.color.text, "of what it asks for, as far as there is body below it");
}

// Lets it be cut before the one above it in the list. True: the incisions have changed.
bool earlier_button(Session& session, const ui::Theme& theme, Id id, int number)
{
    if (number < 2) return false;
    ui::gap(theme, 4);
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float edge = theme.px(12);
    ImGui::SetCursorScreenPos({at.x + edge, at.y});
    const bool pressed =
        ui::button(theme, "Cut it earlier", ui::ButtonKind::plain,
                   {ImGui::GetContentRegionAvail().x - theme.px(ui::key_gutter), theme.size.row});
    ui::tooltip({"Cut it earlier",
                 {},
                 "It changes places with the incision above it in the list. Where both cross, the "
                 "earlier one is cut first."});
    if (!pressed || !session.run(SwapIncisions{id, number - 1, number})) return false;
    session.incision = {id, number - 1};
    return true;
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

// Edits the object that opens it. Objects that depend on the skin cannot.
void blade_row(const Session& session, ValueRows& rows, Id id, NamedIncision& incision)
{
    const Document& document = session.document();
    const std::set<Id> above = depending_on(document, {id});
    std::vector<Id> ids{0};
    std::vector<std::string> names{"none"};
    for (const auto& [other, each] : document.objects)
        if (!above.contains(other)) {
            ids.push_back(other);
            names.push_back(each->name);
        }
    int chosen = static_cast<int>(std::ranges::find(ids, incision.blade) - ids.begin());
    const ui::Row at = ui::label_row(
        rows.theme, "Blade", incision.blade != 0,
        "an object that opens it as far as the place that is nearest to the object's origin, and "
        "no further than it is open at all");
    if (at.reset) {
        incision.blade = 0;
        rows.take(ui::Edit::changed);
        return;
    }
    rows.take(ui::choice(rows.theme, "blade", chosen, names, at.width));
    incision.blade = ids[static_cast<std::size_t>(chosen)];
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
    ui::rows_if(theme, !before.hidden, "The incision is off.",
                [&] { section_row(editor, rows, id, incision, outcome_of(session, id, number)); });
    draw_incision_rows(rows, incision, number, editor.memory.of<ChosenCutPoints>());
    blade_row(session, rows, id, incision);
    outcome_rows(theme, before.hidden ? nullptr : outcome_of(session, id, number));
    propose_edit(editor, rows.edit, [&] { return edit_of_numbers(id, number, incision); });
    if (incision_buttons(session, theme, id, number, before)) return true;
    return earlier_button(session, theme, id, number);
}

// The flaps that are peeled. True: the incisions have changed.
bool flap_rows(Editor& editor, const ui::Theme& theme, Id id, const Incising& incising,
               const KeyGutter& keys)
{
    Session& session = editor.session;
    for (std::size_t k = 0; k < incising.flaps.size(); ++k) {
        PeeledFlap flap = incising.flaps[k];
        ImGui::PushID(static_cast<int>(k));
        ValueRows rows{theme, &keys};
        const float side = theme.size.row, edge = theme.px(12);
        const ImVec2 at = ImGui::GetCursorScreenPos();
        const float width = ImGui::GetContentRegionAvail().x - side - theme.px(4);
        const auto name = [&](int number) {
            return name_of_incision(incising.cuts[static_cast<std::size_t>(number) - 1], number);
        };
        const auto of = [](IncisionSide s) { return s == IncisionSide::left ? "left" : "right"; };
        ui::name_text(theme.font.body, ui::rect_at({at.x + edge, at.y}, {width - edge, side}),
                      theme.color.text_2,
                      fmt::format("Flap {} of {}, {} of {}", of(flap.side_of_first),
                                  name(flap.first), of(flap.side_of_second), name(flap.second)));
        ImGui::SetCursorScreenPos({at.x + width, at.y});
        const bool laid =
            ui::icon_button(theme, "lay flap", ui::icon::trash, {side, side},
                            {"Lay this flap back", {}, "Its keys go, too; the others stay."});
        ImGui::SetCursorScreenPos({at.x, at.y + side + theme.px(2)});
        ImGui::Dummy({1, 0});
        FieldRows<PeeledFlap> fields(rows, flap, fmt::format("incising.flaps.{}", k));
        fields(&PeeledFlap::lift);
        ImGui::PopID();
        if (laid) return session.run(LayFlap{id, static_cast<int>(k) + 1});
        propose_edit(editor, rows.edit, [&] { return PeelFlap{id, flap}; });
    }
    return false;
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
    ui::rows_if(theme, layer.look.filling == Filling::none, "Solid textures have their own.",
                [&] { look(&Surfacing::roughness); });
    ui::gap(theme, 4);
    ImGui::PopID();
    return removed;
}

double deepest_of(const Incising& incising)
{
    double out = 0;
    for (const NamedIncision& each : incising.cuts) out = std::max(out, each.cut.depth);
    return out;
}

void draw_layers(Editor& editor, const ui::Theme& theme, Id id, const Incising& before,
                 const KeyGutter& keys)
{
    Session& session = editor.session;
    Incising incising = before;
    incising.cuts.clear();
    incising.flaps.clear();
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
            incising.layers = usual_layers(deepest_of(before));
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
    if (!incising.flaps.empty() &&
        ui::section(theme, "Peeled flaps", true, fmt::format("{}", incising.flaps.size()),
                    theme.color.text_3)) {
        if (flap_rows(editor, theme, id, incising, keys)) return;
        ui::gap(theme, 8);
    }
    if (ui::section(theme, "Incision layers", false)) {
        draw_layers(editor, theme, id, incising, keys);
        ui::gap(theme, 8);
    }
}

} // namespace trivar
