// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/transfer_rows.h"

#include "core/document/fields/volume_casting_fields.h"
#include "editor/panels/inspector/field_rows.h"
#include "editor/panels/inspector/srgb_field.h"
#include "editor/session/volume_levels.h"
#include "ui/transfer_field.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

std::vector<TransferPoint> points_of(const VolumeCasting& casting, const ShownVolume& shown)
{
    std::vector<TransferPoint> out = casting.points.empty()
                                         ? usual_transfer(*shown.summary, shown.field->grid())
                                         : casting.points;
    std::ranges::stable_sort(out, {}, &TransferPoint::value);
    return out;
}

// Says where the function is from; its reset makes it from the histogram again.
void function_row(ValueRows& rows, VolumeCasting& casting)
{
    const ui::Theme& theme = rows.theme;
    rows.row("Colours", casting.points, {},
             "How values look: the transfer function, a colour and an opacity for every value.",
             [&](float width) {
                 const ImVec2 at = ImGui::GetCursorScreenPos();
                 ui::paint_text(theme.font.body, ui::rect_at({at.x, at.y}, {width, theme.size.row}),
                                theme.color.text_2,
                                casting.points.empty()
                                    ? "from the histogram"
                                    : fmt::format("{} points", casting.points.size()));
                 ImGui::Dummy({width, theme.size.row});
                 return ui::Edit::none;
             });
}

// A point lies between its neighbours.
glm::dvec2 range_of(const std::vector<TransferPoint>& points, std::size_t i,
                    const VolumeSummary& summary)
{
    return {i > 0 ? points[i - 1].value : std::min(summary.least, points[i].value),
            i + 1 < points.size() ? points[i + 1].value
                                  : std::max(summary.greatest, points[i].value)};
}

ui::Edit draw_function(const ui::Theme& theme, const LevelRows& of,
                       std::vector<TransferPoint>& points, int& chosen)
{
    const VolumeSummary& summary = *of.shown->summary;
    ImGui::SetCursorScreenPos(
        {ImGui::GetWindowPos().x + theme.size.padding, ImGui::GetCursorScreenPos().y});
    const ui::Edit edit = ui::transfer_field(
        theme, "function", points, chosen,
        {.counts = summary.histogram,
         .lo = summary.least,
         .hi = summary.greatest,
         .ends = {ui::short_number(summary.least), ui::short_number(summary.greatest)},
         .unit = of.unit,
         .most_points = 256},
        ImGui::GetWindowWidth() - 2 * theme.size.padding);
    ui::tooltip({"Transfer function",
                 {},
                 "To the right the value, upward how dense it looks. Drag a point. A double click "
                 "adds one, a right click or Del removes it."});
    if (edit == ui::Edit::changed && chosen >= 0) {
        const auto i = static_cast<std::size_t>(chosen);
        const glm::dvec2 range = range_of(points, i, summary);
        points[i].value = std::clamp(readable_value(points[i].value, summary), range.x, range.y);
    }
    ui::gap(theme, 6);
    return edit;
}

void point_rows(ValueRows& rows, std::vector<TransferPoint>& points, std::size_t i,
                const std::string& parameter, const LevelRows& of)
{
    TransferPoint& point = points[i];
    FieldRows<TransferPoint> fields(rows, point, parameter);
    const TransferPoint rest = point; // it has no usual values
    const glm::dvec2 range = range_of(points, i, *of.shown->summary);
    rows.number(fields.label(&TransferPoint::value), point.value, rest.value,
                {.lo = range.x, .hi = range.y, .unit = of.unit},
                fields.words_of(&TransferPoint::value));
    fields.resting_at(rest.opacity, &TransferPoint::opacity);
    RowWords words = fields.words_of(&TransferPoint::color);
    if (!words.parameters.empty()) words.parameters = axes_of(words.parameters.front());
    rows.row(fields.label(&TransferPoint::color), point.color, rest.color, words,
             [&](float width) { return srgb_field(rows.theme, "color", point.color, width); });
}

} // namespace

void draw_transfer(ValueRows& rows, const LevelRows& of, VolumeCasting& casting, int& chosen)
{
    if (!of.shown || !of.shown->summary || !of.shown->field) return;
    ImGui::PushID("transfer");
    function_row(rows, casting);
    std::vector<TransferPoint> points = points_of(casting, *of.shown);
    // Points that are made from the histogram, or are not in their order, have no keys.
    const bool have_keys = points == casting.points;
    ValueRows own{rows.theme, rows.keys};
    own.take(draw_function(rows.theme, of, points, chosen));
    chosen = std::min(chosen, static_cast<int>(points.size()) - 1);
    if (points.empty()) chosen = -1;
    const int shown = std::max(chosen, 0);
    const std::string parameter = have_keys ? fmt::format("shape.casting.points.{}", shown) : "";
    ImGui::PushID(shown);
    if (!points.empty())
        ui::rows_if(rows.theme, chosen >= 0, "No point of the curve is selected.", [&] {
            point_rows(own, points, static_cast<std::size_t>(shown), parameter, of);
        });
    ImGui::PopID();
    ImGui::PopID();
    if (own.edit == ui::Edit::changed) casting.points = points;
    rows.take(own.edit);
}

} // namespace trivar
