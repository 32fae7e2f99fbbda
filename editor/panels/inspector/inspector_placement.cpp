// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/number_text.h"
#include "core/commands/placement/place.h"
#include "core/commands/words/step_title.h"
#include "core/placement/embed.h"
#include "editor/actions/edit_actions.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/height_map_rows.h"
#include "editor/panels/inspector/inspect.h"
#include "editor/panels/inspector/profile_rows.h"
#include "editor/panels/panels.h"
#include "editor/tools/place/place_round.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

using PlacementRows = FieldRows<PlacementParameters>;

void report_rows(const ui::Theme& theme, const Placement* placement)
{
    const PlacementReport r = placement ? placement->report : PlacementReport{};
    const auto row = [&](const char* label, const std::string& value, const char* help,
                         ui::Color color = 0) { ui::fact_row(theme, label, value, color, help); };
    row("Length", ui::short_number(r.length_world) + " m", "of the middle of the strip");
    row("Contact", percent_text(r.contact_share),
        "share of the contact surface that touches the scene; the rest is bridged");
    row("No surface", percent_text(r.missed_share),
        "share of the contact surface with nothing beneath it");
    row("Largest gap", ui::short_number(r.largest_gap) + " m",
        "largest distance from the contact surface down to the scene");
    // Above one and a half a pattern is seen to be drawn out.
    row("Stretch",
        fmt::format("up to {}x lengthwise", number_text(r.largest_stretch, {.digits = 2})),
        "how much the model is stretched at most", r.largest_stretch > 1.5 ? theme.color.warn : 0);
    row("Pinched",
        r.narrowed > 0 ? fmt::format("{} {}", r.narrowed, r.narrowed == 1 ? "place" : "places")
                       : "nowhere",
        "places where the turn is too tight, so the model is pinched",
        r.narrowed > 0 ? theme.color.warn : theme.color.good);
    const bool through = r.penetration > 1e-3;
    row("Penetration", r.penetration <= 0 ? "none" : percent_text(r.penetration) + " of height",
        "how deep the scene reaches into the volume at most", through ? theme.color.warn : 0);
    const auto folds =
        placement ? std::ranges::count(placement->nodes, true, &StripNode::folds) : 0;
    row("Folds", folds == 0 ? "none" : fmt::format("{} {}", folds, folds == 1 ? "place" : "places"),
        "places where the volume is turned inside out",
        folds == 0 ? theme.color.good : theme.color.bad);
}

// One row: what carries it, or that nothing does, with the remedy.
void carried_row(Editor& editor, const ui::Theme& theme, Id id, const PlacementStep& step)
{
    const Document& document = editor.session.document();
    if (step.onto.empty() && !step.parameters.on_ground)
        return bind_row(editor, theme, "Lies on", id);
    if (!step.onto.empty() && !step.attach) {
        const ui::Row at = ui::label_row(theme, "Not attached", false,
                                         "it stays in the world where the objects under it move");
        if (ui::button(theme, "Attach", ui::ButtonKind::plain, {at.width, theme.size.row}))
            attach_as_it_lies(editor, id);
        return;
    }
    std::vector<Id> hosts;
    if (step.attach)
        for (const AttachedHost& host : step.attach->hosts)
            if (host.touched) hosts.push_back(host.object);
    ui::fact_row(theme, "Attached",
                 hosts.empty() ? "to the ground" : "to " + names_in(document, hosts),
                 theme.color.text_2, "it goes with what carries it");
}

// Labels the two ends of the bar above.
void ends_row(const ui::Theme& theme, const char* low, const char* high)
{
    const ui::Row row = ui::label_row(theme, "");
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ui::Rect place = ui::rect_at({at.x, at.y - theme.px(4)}, {row.width, theme.px(16)});
    ui::paint_text(theme.font.small, place, theme.color.text_3, low);
    ui::paint_text(theme.font.small, place, theme.color.text_3, high, ui::Align::right);
    ImGui::Dummy({1, theme.px(12)});
}

void volume_rows(ValueRows& rows, PlacementRows& fields, PlacementParameters& p, bool round,
                 const PlacementReport* report, Editor& editor)
{
    using P = PlacementParameters;
    auto& chosen = editor.memory.of<ChosenPoints>();
    const ui::Palette& c = rows.theme.color;
    const double width = report ? report->width_world : 0;
    const double height = report ? report->height_world : 0;
    const auto profile = [&](std::vector<glm::dvec2> P::*field, double present, ui::Color color,
                             ProfileKind kind, int& point) {
        rows.take(draw_profile(
            rows.theme,
            {fields.label(field), fields.words_of(field), present, color, kind, rows.keys},
            p.*field, point));
    };
    fields.size(&P::width, width);
    profile(&P::width_profile, width, c.stroke, ProfileKind::along, chosen.width);
    fields.size(&P::height, height);
    profile(&P::height_profile, height, c.lattice, ProfileKind::along, chosen.height);
    profile(&P::height_across, height, c.lattice, ProfileKind::across, chosen.across);
    rows.take(draw_height_map(rows.theme, {fields.words_of(&P::height_map), height, rows.keys},
                              p.height_map, chosen.map));
    profile(&P::rise_profile, height, c.contact, ProfileKind::rise, chosen.rise);
    fields(&P::contact_level);
    if (!round) { // else there is no view to rise toward
        fields(&P::offset);
        ends_row(rows.theme, "toward view", "along normals");
    }
    fields(&P::grid);
    fields(&P::orders);
}

void spring_rows(const ui::Theme& theme, PlacementRows& fields, const PlacementParameters& p)
{
    using P = PlacementParameters;
    fields(&P::springs);
    ui::rows_if(theme, p.springs, "The springs are off.", [&] {
        fields(&P::stiffness);
        fields(&P::bending);
        fields(&P::neighborhood);
        fields(&P::roughness_deg);
        fields(&P::free_ends);
    });
}

void fit_rows(ValueRows& rows, PlacementRows& fields, PlacementParameters& p)
{
    constexpr double least_fill = 1e-3;
    fields(&PlacementParameters::start);
    fields(&PlacementParameters::fill);
    // The other of the two gives way: both share the stroke.
    p.start = std::min(p.start, 1 - least_fill);
    if (p.start + p.fill > 1) p.fill = std::max(least_fill, 1 - p.start);
    Lying lying = lying_of(p);
    const Lying before = lying;
    int side = static_cast<int>(lying.on);
    const std::vector<std::string> turns{"placement.along", "placement.reverse",
                                         "placement.roll_deg"};
    rows.row(
        "Lies on", side, 0, {"which side of the model lies on the scene", turns}, [&](float width) {
            return ui::choice(rows.theme, "lies on", side,
                              {"Bottom", "Right side", "Top", "Left side", "Front", "Back"}, width);
        });
    lying.on = static_cast<Underside>(side);
    rows.choice("Turned", lying.quarters, 0, {"0", "90", "180", "270"},
                {"rotation about the vertical, to the left, degrees", turns},
                [&](int chosen) { lying.quarters = chosen; });
    if (!(lying == before)) p = with_lying(std::move(p), lying);
}

void contact_rows(PlacementRows& fields)
{
    using P = PlacementParameters;
    fields(&P::on_ground);
    fields(&P::misses);
    fields(&P::bridge_jumps);
    fields(&P::sharp);
    fields(&P::clearance);
    fields(&P::lift_tolerance);
    fields(&P::skip_back_faces);
}

// Edits the place on the body at which it goes round. The step lays it anew, so later edits of its
// volume would be lost: if there are some, only keys change it.
void level_row(Editor& editor, ValueRows& rows, Id id)
{
    const Object& each = object(editor.session.document(), id);
    std::optional<RoundWish> now = round_now(editor.session.document(), id);
    if (!now) return;
    if (!each.shaping.empty()) {
        ui::fact_row(rows.theme, "Level", ui::short_number(*now->level) + " m",
                     rows.theme.color.text_2,
                     "fixed, since edits of the lattice would be lost; keys can change it");
        return;
    }
    ValueRows own{rows.theme, rows.keys};
    own.number("Level", *now->level, 0, {.lo = -1e6, .hi = 1e6, .unit = "m"},
               {"where along the axis of the body it goes round",
                std::vector<std::string>{"placement.level"}});
    propose_edit(editor, own.edit, [&] { return round_command(editor.session, *now); });
}

} // namespace

void draw_placement(Editor& editor, const ui::Theme& theme, Id id)
{
    const Object& each = object(editor.session.document(), id);
    PlacementParameters p = each.stroke->parameters;
    const auto effects = editor.session.evaluated().objects.find(id);
    const Placement* placement = effects == editor.session.evaluated().objects.end()
                                     ? nullptr
                                     : effects->second->stroke_placement().get();
    const bool round = each.stroke->round.has_value();
    const KeyGutter keys(editor, {id});
    ValueRows rows{theme, &keys};
    PlacementRows fields(rows, p, "placement");
    const auto part = [&](const char* title, bool open, auto&& fill) {
        ImGui::PushID(title);
        if (ui::section(theme, title, open)) {
            fill();
            ui::gap(theme, 8);
        }
        ImGui::PopID();
    };
    if (!round) carried_row(editor, theme, id, *each.stroke);
    part("Volume", true, [&] {
        if (round) level_row(editor, rows, id);
        volume_rows(rows, fields, p, round, placement ? &placement->report : nullptr, editor);
    });
    if (!round) part("Springs", true, [&] { spring_rows(theme, fields, p); });
    part("Fit", true, [&] { fit_rows(rows, fields, p); });
    if (!round) part("Contact", false, [&] { contact_rows(fields); });
    draw_travel(editor, theme, {id});
    draw_refinement(editor, theme, {id});
    part("Checks", true, [&] {
        ui::rows_if(theme, placement, "It is not laid.", [&] {
            report_rows(theme, placement);
            overlap_row(editor, theme, placement ? effects->second.get() : nullptr);
        });
    });
    propose_edit(editor, rows.edit, [&] { return EditPlacement{id, p, {}, {}}; });
}

} // namespace trivar
