// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspect.h"
#include "editor/panels/panels.h"
#include "editor/panels/profile_rows.h"
#include "editor/panels/value_rows.h"

#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

std::string percent(double share)
{
    return fmt::format("{:.0f} %", share * 100);
}

void report_rows(const ui::Theme& theme, const PlacementReport& r)
{
    ui::fact_row(theme, "Length", ui::short_number(r.length_world) + " m");
    ui::fact_row(theme, "On the scene", percent(r.contact_share) + " of the nodes");
    ui::fact_row(theme, "Missed", percent(r.missed_share) + " of the rays");
    ui::fact_row(theme, "Largest gap", ui::short_number(r.largest_gap) + " m");
    // Above one and a half a pattern is seen to be drawn out.
    ui::fact_row(theme, "Stretch", fmt::format("{:.2g} times along", r.largest_stretch),
                 r.largest_stretch > 1.5 ? theme.color.warn : 0);
    if (r.narrowed > 0)
        ui::fact_row(theme, "Narrowed",
                     fmt::format("{} {}", r.narrowed, r.narrowed == 1 ? "column" : "columns"),
                     theme.color.warn);
    const bool through = r.penetration > 1e-3;
    ui::fact_row(theme, "Penetration",
                 r.penetration <= 0 ? "none"
                                    : fmt::format("{:.2g} % of height", r.penetration * 100),
                 through ? theme.color.warn : 0);
    const bool folds = r.smallest_jacobian <= 0;
    ui::fact_row(theme, "Folds", folds ? "yes, at a node" : "none",
                 folds ? theme.color.bad : theme.color.good);
}

void volume_rows(ValueRows& rows, PlacementParameters& p, const PlacementReport* report,
                 Editor& editor)
{
    const PlacementParameters rest;
    const auto size = [&](double present) {
        return ui::NumberStyle{.lo = 0,
                               .hi = 1e6,
                               .unit = "m",
                               .zero = present > 0 ? "auto, " + ui::short_number(present) : "auto"};
    };
    // A drag from "auto" begins at the size that stands there.
    const auto sized = [&](const char* label, double& value, double present, const char* help) {
        const double before = value;
        double shown = value > 0 ? value : present;
        const ui::Row at = ui::label_row(rows.theme, label, value != 0, help);
        if (at.reset) {
            value = 0;
            return rows.take(ui::Edit::changed);
        }
        ui::NumberStyle style = size(present);
        if (value == 0) style.words = style.zero;
        const ui::Edit one = ui::number_field(rows.theme, label, shown, style, at.width);
        value = one == ui::Edit::changed ? shown : before;
        rows.take(one);
    };
    const auto profile = [&](const std::string& of, double present, ui::Color color,
                             std::vector<glm::dvec2>& points, int& chosen) {
        rows.take(draw_profile(rows.theme,
                               {of + " profile",
                                "How it changes along the stroke. In the curve: drag a point; "
                                "Ctrl and click adds one or takes one away.",
                                present, color},
                               points, chosen));
    };
    const double width = report ? report->width_world : 0;
    const double height = report ? report->height_world : 0;
    sized("Width", p.width, width,
          "Of the strip, across the stroke. Reset: in proportion to the model.");
    profile("Width", width, rows.theme.color.stroke, p.width_profile, editor.width_point);
    sized("Height", p.height, height,
          "Of the volume, away from the scene. Reset: in proportion to the model.");
    profile("Height", height, rows.theme.color.lattice, p.height_profile, editor.height_point);
    rows.number("Offset", p.offset, rest.offset, {.lo = 0, .hi = 1, .bar_hi = 1},
                "0: the volume is extruded toward the camera. 1: it stands on the surface along "
                "its normals.");
    rows.triple("Density", p.grid, rest.grid, {.lo = 2, .hi = 1024},
                "Control points along, across and above the stroke.");
    rows.triple("Order", p.orders, rest.orders, {.lo = 2, .hi = 6},
                "Of the B-splines; 3 is quadratic, 4 is cubic.");
}

void spring_rows(ValueRows& rows, PlacementParameters& p)
{
    const PlacementParameters rest;
    rows.choice("Gaps", p.springs ? 0 : 1, rest.springs ? 0 : 1, {"Bridge", "Follow"},
                "Bridge: springs hold the model over gaps. Follow: it drops into them.",
                [&](int chosen) { p.springs = chosen == 0; });
    if (!p.springs) return;
    rows.number("Stiffness", p.stiffness, rest.stiffness, {.lo = 1e-3, .hi = 1e3},
                "A span of stiffness x length sags by a tenth of the gap.");
    rows.number("Bending", p.bending, rest.bending, {.lo = 0, .hi = 10, .bar_hi = 10},
                "Resistance to bending, relative to the stiffness.");
    rows.integer("Reach", p.neighborhood, rest.neighborhood, {.lo = 0, .hi = 1024},
                 "Grid steps round a rough node that are let loose.");
    rows.number("Roughness", p.roughness_deg, rest.roughness_deg,
                {.lo = 1, .hi = 90, .bar_hi = 90, .unit = "deg"},
                "The angle between neighbouring faces that counts as rough.");
    rows.check("Ends", p.free_ends, rest.free_ends, "move freely",
               "Nodes on the rim of the strip may move too.");
}

void fit_rows(ValueRows& rows, PlacementParameters& p)
{
    const PlacementParameters rest;
    rows.number("Start", p.start, rest.start, {.lo = 0, .hi = 1 - 1e-3, .bar_hi = 1},
                "Where along the stroke the model begins.");
    rows.number("Fill", p.fill, rest.fill, {.lo = 1e-3, .hi = 1, .bar_hi = 1},
                "How much of the stroke the model fills.");
    // The two share the stroke: what was not touched gives way.
    if (p.start + p.fill > 1) p.fill = std::max(1e-3, 1 - p.start);
    rows.check("Direction", p.reverse, rest.reverse, "toward the start",
               "The model looks toward the start of the stroke.");
    rows.choice("Roll", static_cast<int>(p.roll_deg / 90 + 0.5) % 4, 0, {"0", "90", "180", "270"},
                "Quarter turns of the model about its length, in degrees.",
                [&](int chosen) { p.roll_deg = chosen * 90; });
}

void contact_rows(ValueRows& rows, PlacementParameters& p)
{
    const PlacementParameters rest;
    int misses = static_cast<int>(p.misses);
    const ui::Row at = ui::label_row(rows.theme, "Misses", p.misses != rest.misses,
                                     "What a node does whose ray hits nothing.");
    if (at.reset) {
        p.misses = rest.misses;
        rows.take(ui::Edit::changed);
    } else {
        rows.take(ui::choice(rows.theme, "misses", misses,
                             {"Membrane", "Drop to the ground", "Nearest point", "Shrink"},
                             at.width));
        p.misses = static_cast<Misses>(misses);
    }
    rows.number("Clearance", p.clearance, rest.clearance, {.lo = 0, .hi = 1e6, .unit = "m"},
                "Kept between the scene and the model.");
    rows.number("Sinking", p.lift_tolerance, rest.lift_tolerance, {.lo = 0, .hi = 1},
                "Penetration that may stay, as a fraction of the height.");
    rows.check("Back faces", p.skip_back_faces, rest.skip_back_faces, "rays pass through",
               "Rays pass through faces that are seen from behind.");
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
    ValueRows rows{theme};
    const auto part = [&](const char* title, bool open, auto&& fill) {
        ImGui::PushID(title);
        if (ui::section(theme, title, open)) {
            fill();
            ui::gap(theme, 8);
        }
        ImGui::PopID();
    };
    part("Volume", true,
         [&] { volume_rows(rows, p, placement ? &placement->report : nullptr, editor); });
    if (!each.placement->round) part("Springs", true, [&] { spring_rows(rows, p); });
    part("Fit", true, [&] { fit_rows(rows, p); });
    if (!each.placement->round) part("Contact", false, [&] { contact_rows(rows, p); });
    draw_travel(editor, theme, id);
    if (placement) part("Checks", true, [&] { report_rows(theme, placement->report); });
    propose_edit(editor, rows.edit, [&] { return EditPlacement{id, p, {}, {}}; });
}

} // namespace trivar
