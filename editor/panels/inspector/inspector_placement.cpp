// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/embed.h"
#include "editor/panels/inspector/height_map_rows.h"
#include "editor/panels/inspector/inspect.h"
#include "editor/panels/inspector/profile_rows.h"
#include "editor/panels/inspector/value_rows.h"
#include "editor/panels/panels.h"
#include "editor/words/field_words.h"

#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

RowWords help_of(const std::string& parameter)
{
    return {help_of_field("edit_placement", "parameters." + parameter), "placement." + parameter};
}

std::string percent(double share)
{
    return fmt::format("{:.0f} %", share * 100);
}

void report_rows(const ui::Theme& theme, const PlacementReport& r)
{
    const auto row = [&](const char* label, const std::string& value, const char* help,
                         ui::Color color = 0) { ui::fact_row(theme, label, value, color, help); };
    row("Length", ui::short_number(r.length_world) + " m", "of the middle of the strip");
    row("On the scene", percent(r.contact_share) + " of the nodes",
        "nodes of the contact surface that touch what they lie on; the others bridge gaps");
    row("Missed", percent(r.missed_share) + " of the rays",
        "of the rays through the strip, those that met nothing");
    row("Largest gap", ui::short_number(r.largest_gap) + " m",
        "between a node that springs hold and the scene under it");
    // Above one and a half a pattern is seen to be drawn out.
    row("Stretch", fmt::format("{:.2g} times along", r.largest_stretch),
        "how far the model is drawn out where it is most",
        r.largest_stretch > 1.5 ? theme.color.warn : 0);
    if (r.narrowed > 0)
        row("Narrowed", fmt::format("{} {}", r.narrowed, r.narrowed == 1 ? "column" : "columns"),
            "made narrower, since the stroke turns more tightly there than it is wide",
            theme.color.warn);
    const bool through = r.penetration > 1e-3;
    row("Penetration",
        r.penetration <= 0 ? "none" : fmt::format("{:.2g} % of height", r.penetration * 100),
        "how deep the scene is still in the volume at the worst", through ? theme.color.warn : 0);
    const bool folds = r.smallest_jacobian <= 0;
    row("Folds", folds ? "yes, at a node" : "none", "places where the volume is turned inside out",
        folds ? theme.color.bad : theme.color.good);
}

void volume_rows(ValueRows& rows, PlacementParameters& p, bool round, const PlacementReport* report,
                 Editor& editor)
{
    const PlacementParameters rest;
    const auto profile = [&](const char* label, const char* field, double present, ui::Color color,
                             ProfileKind kind, std::vector<glm::dvec2>& points, int& chosen) {
        rows.take(draw_profile(rows.theme, {label, help_of(field), present, color, kind, rows.keys},
                               points, chosen));
    };
    auto& chosen_points = editor.memory.of<ChosenPoints>();
    const ui::Palette& c = rows.theme.color;
    const double width = report ? report->width_world : 0;
    const double height = report ? report->height_world : 0;
    rows.size("Width", p.width, width, help_of("width"));
    profile("Width profile", "width_profile", width, c.stroke, ProfileKind::along, p.width_profile,
            chosen_points.width);
    rows.size("Height", p.height, height, help_of("height"));
    profile("Height profile", "height_profile", height, c.lattice, ProfileKind::along,
            p.height_profile, chosen_points.height);
    profile("Height across", "height_across", height, c.lattice, ProfileKind::across,
            p.height_across, chosen_points.across);
    rows.take(draw_height_map(rows.theme, {help_of("height_map"), height, rows.keys}, p.height_map,
                              chosen_points.map));
    profile("Rise", "rise_profile", height, c.contact, ProfileKind::rise, p.rise_profile,
            chosen_points.rise);
    rows.number("Sunk", p.contact_level, rest.contact_level, {.lo = 0, .hi = 1, .bar_hi = 1},
                help_of("contact_level"));
    if (!round) // there is no camera to extrude toward
        rows.number("Offset", p.offset, rest.offset, {.lo = 0, .hi = 1, .bar_hi = 1},
                    help_of("offset"));
    rows.triple("Density", p.grid, rest.grid, {.lo = 2, .hi = most_along_or_across},
                help_of("grid"));
    rows.triple("Order", p.orders, rest.orders, {.lo = 2, .hi = 6}, help_of("orders"));
}

void spring_rows(ValueRows& rows, PlacementParameters& p)
{
    const PlacementParameters rest;
    rows.choice("Gaps", p.springs ? 0 : 1, rest.springs ? 0 : 1, {"Bridge", "Follow"},
                help_of("springs"), [&](int chosen) { p.springs = chosen == 0; });
    if (!p.springs) return;
    rows.number("Stiffness", p.stiffness, rest.stiffness, {.lo = 1e-3, .hi = 1e3},
                help_of("stiffness"));
    rows.number("Bending", p.bending, rest.bending, {.lo = 0, .hi = 10, .bar_hi = 10},
                help_of("bending"));
    rows.integer("Reach", p.neighborhood, rest.neighborhood, {.lo = 0, .hi = most_along_or_across},
                 help_of("neighborhood"));
    rows.number("Roughness", p.roughness_deg, rest.roughness_deg,
                {.lo = 1, .hi = 90, .bar_hi = 90, .unit = "deg"}, help_of("roughness_deg"));
    rows.check("Ends", p.free_ends, rest.free_ends, "move freely", help_of("free_ends"));
}

void fit_rows(ValueRows& rows, PlacementParameters& p)
{
    const PlacementParameters rest;
    rows.number("Start", p.start, rest.start, {.lo = 0, .hi = 1 - 1e-3, .bar_hi = 1},
                help_of("start"));
    rows.number("Fill", p.fill, rest.fill, {.lo = 1e-3, .hi = 1, .bar_hi = 1}, help_of("fill"));
    // The two share the stroke: what was not touched gives way.
    if (p.start + p.fill > 1) p.fill = std::max(1e-3, 1 - p.start);
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
                {"about the vertical, toward the left, degrees", turns},
                [&](int chosen) { lying.quarters = chosen; });
    if (!(lying == before)) p = with_lying(std::move(p), lying);
}

void contact_rows(ValueRows& rows, PlacementParameters& p)
{
    const PlacementParameters rest;
    int misses = static_cast<int>(p.misses);
    rows.row("Misses", misses, static_cast<int>(rest.misses), help_of("misses"), [&](float width) {
        return ui::choice(rows.theme, "misses", misses,
                          {"Membrane", "Drop to the ground", "Nearest point", "Shrink"}, width);
    });
    p.misses = static_cast<Misses>(misses);
    rows.check("Edges", p.sharp, rest.sharp, "stay sharp", help_of("sharp"));
    rows.number("Clearance", p.clearance, rest.clearance, {.lo = 0, .hi = 1e6, .unit = "m"},
                help_of("clearance"));
    rows.number("Sinking", p.lift_tolerance, rest.lift_tolerance, {.lo = 0, .hi = 1},
                help_of("lift_tolerance"));
    rows.check("Back faces", p.skip_back_faces, rest.skip_back_faces, "rays pass through",
               help_of("skip_back_faces"));
}

} // namespace

void draw_placement(Editor& editor, const ui::Theme& theme, Id id)
{
    const Object& each = object(editor.session.document(), id);
    PlacementParameters p = each.placement->parameters;
    const auto effects = editor.session.evaluated().objects.find(id);
    const Placement* placement = effects == editor.session.evaluated().objects.end()
                                     ? nullptr
                                     : effects->second->placement.get();
    const bool round = each.placement->round.has_value();
    const KeyGutter keys(editor, {id});
    ValueRows rows{theme, &keys};
    const auto part = [&](const char* title, bool open, auto&& fill) {
        ImGui::PushID(title);
        if (ui::section(theme, title, open)) {
            fill();
            ui::gap(theme, 8);
        }
        ImGui::PopID();
    };
    part("Volume", true,
         [&] { volume_rows(rows, p, round, placement ? &placement->report : nullptr, editor); });
    if (!round) part("Springs", true, [&] { spring_rows(rows, p); });
    part("Fit", true, [&] { fit_rows(rows, p); });
    if (!round) part("Contact", false, [&] { contact_rows(rows, p); });
    draw_travel(editor, theme, {id});
    draw_refinement(editor, theme, {id});
    if (placement) part("Checks", true, [&] { report_rows(theme, placement->report); });
    propose_edit(editor, rows.edit, [&] { return EditPlacement{id, p, {}, {}}; });
}

} // namespace trivar
