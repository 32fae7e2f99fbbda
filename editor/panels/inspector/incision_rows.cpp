// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/incision_rows.h"

#include "core/document/fields/incising_fields.h"
#include "editor/panels/inspector/field_rows.h"
#include "ui/curve_field.h"

#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

// Finds the facts of a number of an incision in the list of fields.
FieldFacts incision_facts(std::string_view wanted)
{
    FieldFacts found;
    const NamedIncision probe{};
    each_field(probe, [&](std::string_view name, const auto&, std::string_view help,
                          const Rule& rule = {}) {
        if (name == wanted) found = {std::string(name), std::string(help), rule};
    });
    return found;
}

RowWords incision_words(const FieldFacts& facts, int number)
{
    const std::string help = without_unit(facts.help);
    if (facts.rule.fixed) return RowWords(help);
    return {help, fmt::format("incising.cuts.{}.{}", number - 1, facts.name)};
}

void number_row(ValueRows& rows, const char* name, int number, double& value, double rest)
{
    const FieldFacts facts = incision_facts(name);
    const double factor = shown_factor(facts.rule.unit);
    double shown = value * factor;
    const double was = shown;
    rows.number(label_of(facts.name, facts.rule), shown, rest * factor,
                number_style(facts.rule, false, {}), incision_words(facts, number));
    if (shown != was) value = shown / factor;
}

template <class E>
void choice_row(ValueRows& rows, const char* name, E& value, E rest,
                const std::vector<std::string>& names)
{
    const FieldFacts facts = incision_facts(name);
    rows.choice(label_of(facts.name, facts.rule), static_cast<int>(value), static_cast<int>(rest),
                names, RowWords(without_unit(facts.help)),
                [&](int chosen) { value = static_cast<E>(chosen); });
}

// Edits how a size goes along the cut: a shape, and for a custom one its curve.
void profile_row(ValueRows& rows, const char* name, IncisionProfile& profile,
                 IncisionProfile::Shape rest, double size, ui::Color color, int& chosen)
{
    const ui::Theme& theme = rows.theme;
    const FieldFacts facts = incision_facts(name);
    const std::string label = label_of(facts.name, facts.rule);
    constexpr int custom = static_cast<int>(IncisionProfile::Shape::custom);
    int shape = static_cast<int>(profile.shape);
    bool open = false;
    rows.row(label, shape, static_cast<int>(rest), RowWords(without_unit(facts.help)),
             [&](float width) {
                 ui::Row row{width};
                 open = ui::unfolded(theme, row, label, shape == custom);
                 return ui::segments(theme, label, shape, {"Lens", "Even", "Custom"}, row.width);
             });
    std::vector<glm::dvec2> points = custom_points(profile);
    if (shape == custom && profile.shape != IncisionProfile::Shape::custom) {
        profile.points = points;
        ui::unfold(label);
    }
    profile.shape = static_cast<IncisionProfile::Shape>(shape);
    if (!open) return;
    ImGui::SetCursorScreenPos(
        {ImGui::GetWindowPos().x + theme.size.padding, ImGui::GetCursorScreenPos().y});
    const float width =
        ImGui::GetWindowWidth() - 2 * theme.size.padding - theme.px(ui::key_gutter - 12);
    const IncisionProfile drawn = profile;
    const ui::Edit edit = ui::curve_field(theme, label, points, chosen,
                                          {.at = [drawn](double x) { return value_at(drawn, x); },
                                           .lo = 0,
                                           .hi = 1,
                                           .scale = size,
                                           .unit = "m",
                                           .color = color,
                                           .ends = {"start", "end"}},
                                          width);
    if (edit == ui::Edit::changed) profile = {IncisionProfile::Shape::custom, points};
    rows.take(edit);
    ui::tooltip({label,
                 {},
                 "Drag a point. Ctrl click adds a point or removes one, Del removes the selected "
                 "point."});
    ui::gap(theme, 8);
}

} // namespace

std::vector<glm::dvec2> custom_points(const IncisionProfile& profile)
{
    if (profile.shape == IncisionProfile::Shape::custom && profile.points.size() > 1)
        return profile.points;
    if (profile.shape == IncisionProfile::Shape::even) return {{0, 1}, {0.5, 1}, {1, 1}};
    return {{0, 0}, {0.25, 0.55}, {0.5, 1}, {0.75, 0.55}, {1, 0}};
}

void draw_incision_rows(ValueRows& rows, NamedIncision& incision, int number,
                        ChosenCutPoints& chosen)
{
    const NamedIncision rest;
    Incision& cut = incision.cut;
    const ui::Palette& c = rows.theme.color;
    number_row(rows, "opening", number, incision.opening.share, rest.opening.share);
    number_row(rows, "width", number, cut.width, rest.cut.width);
    number_row(rows, "depth", number, cut.depth, rest.cut.depth);
    choice_row(rows, "floor", cut.floor, rest.cut.floor, {"Sharp", "Flat", "Through"});
    const ui::Theme& theme = rows.theme;
    ui::rows_if(theme, cut.floor == Incision::Floor::u, "Only for a flat floor.", [&] {
        number_row(rows, "floor_width", number, cut.floor_width, rest.cut.floor_width);
    });
    const bool loop = cut.stroke.size() > 1 && cut.stroke.front().p == cut.stroke.back().p;
    ui::rows_if(theme, cut.floor == Incision::Floor::through && loop,
                "Only for a closed incision that goes through.", [&] {
                    choice_row(rows, "piece", cut.piece, rest.cut.piece, {"Kept", "Left out"});
                });
    number_row(rows, "lean_deg", number, cut.lean_deg, rest.cut.lean_deg);
    number_row(rows, "bevel", number, cut.bevel, rest.cut.bevel);
    ui::rows_if(theme, cut.bevel > 0, "There is no bevel.",
                [&] { number_row(rows, "roundness", number, cut.roundness, rest.cut.roundness); });
    number_row(rows, "reach", number, cut.reach, rest.cut.reach);
    number_row(rows, "from", number, incision.opening.from, rest.opening.from);
    number_row(rows, "to", number, incision.opening.to, rest.opening.to);
    profile_row(rows, "opening_profile", cut.opening_profile, IncisionProfile::Shape::lens,
                cut.width, c.incision, chosen.width);
    profile_row(rows, "depth_profile", cut.depth_profile, IncisionProfile::Shape::even, cut.depth,
                c.lattice, chosen.depth);
}

} // namespace trivar
