// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/height_field.h"

#include "core/base/number_text.h"
#include "ui/held_value.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar::ui {
namespace {

constexpr float picture_at_1 = 128, cells_at_1 = 96, least_cell_at_1 = 22, foot_at_1 = 22,
                gutter_at_1 = 34, grip_at_1 = 9;
constexpr double round_height = 0.05;
constexpr int steps_u = 36, steps_v = 14; // of the picture

using Grid = std::vector<std::vector<double>>;

// Where things are: the surface seen askew, and the cells below it.
struct HeightPlot {
    Rect picture, cells;
    double top = 1;
    int rows = 1, columns = 1;                           // along u, along v
    static constexpr float shear = 0.24f, depth = 0.34f; // of the picture, from v = 0 to 1
    glm::vec2 seen(double u, double v, double h) const
    {
        const glm::vec2 size = picture.size();
        return {picture.lo.x + size.x * static_cast<float>(u * (1 - shear) + v * shear),
                picture.hi.y - size.y * static_cast<float>(v * depth + h / top * (1 - depth))};
    }
    double per_px() const { return top / ((1 - depth) * picture.height()); }
    Rect cell(int i, int j) const
    {
        const glm::vec2 size = cells.size() / glm::vec2(rows, columns);
        const glm::vec2 lo = cells.lo + size * glm::vec2(i, columns - 1 - j);
        return {glm::round(lo), glm::round(lo + size) - glm::vec2(1)};
    }
    int index(int i, int j) const { return i * columns + j; }
};

int value_at(const HeightPlot& plot, const HeightStyle& style, glm::vec2 mouse, float reach)
{
    int nearest = -1;
    for (int i = 0; i < plot.rows; ++i)
        for (int j = 0; j < plot.columns; ++j) {
            if (plot.cell(i, j).contains(mouse)) return plot.index(i, j);
            const double u = style.along[static_cast<std::size_t>(i)],
                         v = style.across[static_cast<std::size_t>(j)];
            const float distance = glm::distance(plot.seen(u, v, style.at(u, v)), mouse);
            if (distance > reach) continue;
            reach = distance;
            nearest = plot.index(i, j);
        }
    return nearest;
}

Color mixed_color(Color a, Color b, float share)
{
    Color out = 0xFF000000u;
    for (int shift = 0; shift < 24; shift += 8) {
        const auto channel = [&](Color c) { return static_cast<float>(c >> shift & 255u); };
        out |= static_cast<Color>(std::lround(channel(a) + (channel(b) - channel(a)) * share))
               << shift;
    }
    return out;
}

// Paints from back to front, lit from the left and above.
void paint_surface(const Theme& theme, const HeightPlot& plot, const HeightStyle& style)
{
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const Color dark = mixed_color(theme.color.field_active, style.color, 0.25f);
    const auto height = [&](int i, int j) {
        return style.at(static_cast<double>(i) / steps_u, static_cast<double>(j) / steps_v);
    };
    const auto seen = [&](int i, int j) {
        const glm::vec2 p = plot.seen(static_cast<double>(i) / steps_u,
                                      static_cast<double>(j) / steps_v, height(i, j));
        return ImVec2(p.x, p.y);
    };
    const ImDrawListFlags flags = draw.Flags;
    draw.Flags &= ~ImDrawListFlags_AntiAliasedFill; // no seams
    for (int j = steps_v; j-- > 0;)
        for (int i = 0; i < steps_u; ++i) {
            const double along = (height(i + 1, j) - height(i, j)) * steps_u / plot.top,
                         across = (height(i, j + 1) - height(i, j)) * steps_v / plot.top;
            const double light = (1 - 0.7 * along + 0.4 * across) /
                                 std::sqrt(1 + 0.5 * (along * along + across * across));
            const ImVec2 corners[] = {seen(i, j), seen(i + 1, j), seen(i + 1, j + 1),
                                      seen(i, j + 1)};
            draw.AddConvexPolyFilled(
                corners, 4,
                mixed_color(dark, style.color,
                            static_cast<float>(std::clamp(0.6 * light, 0.0, 1.0))));
        }
    draw.Flags = flags;
    const auto line = [&](bool along, double at, float alpha) {
        std::vector<glm::vec2> path;
        const int steps = along ? steps_u : steps_v;
        for (int i = 0; i <= steps; ++i) {
            const double t = static_cast<double>(i) / steps;
            const double u = along ? t : at, v = along ? at : t;
            path.push_back(plot.seen(u, v, style.at(u, v)));
        }
        paint_path(path, faded(theme.color.text, alpha), theme.size.hairline);
    };
    for (const double u : style.along) line(false, u, 0.22f);
    for (const double v : style.across) line(true, v, 0.22f);
}

void paint_heights(const Theme& theme, const Rect& box, const HeightPlot& plot, const Grid& values,
                   int chosen, int hovered, const HeightStyle& style)
{
    const Palette& c = theme.color;
    paint_box({box.lo, {box.hi.x, plot.picture.hi.y + theme.px(10)}}, c.field_active,
              theme.size.rounding);
    const glm::vec2 floor[] = {plot.seen(0, 0, 0), plot.seen(1, 0, 0), plot.seen(1, 1, 0),
                               plot.seen(0, 1, 0)};
    paint_path({std::begin(floor), std::end(floor)}, c.line, theme.size.hairline, true);
    paint_surface(theme, plot, style);
    const ImFont* font = theme.font.small;
    for (int i = 0; i < plot.rows; ++i)
        for (int j = 0; j < plot.columns; ++j) {
            const bool lit = plot.index(i, j) == chosen, hot = plot.index(i, j) == hovered;
            const double u = style.along[static_cast<std::size_t>(i)],
                         v = style.across[static_cast<std::size_t>(j)],
                         value = values[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
            const bool few = plot.rows * plot.columns <= 80;
            if (lit || hot || few)
                paint_dot(plot.seen(u, v, style.at(u, v)), theme.scale * (lit || hot ? 5.0f : 3.0f),
                          lit ? c.accent : c.field_active, c.text, 1.3f * theme.scale);
            const Rect cell = plot.cell(i, j);
            const auto full = static_cast<float>(std::clamp(value / plot.top, 0.0, 1.0));
            paint_box(cell, c.field);
            paint_box({{cell.lo.x, std::round(cell.hi.y - full * cell.height())}, cell.hi},
                      faded(style.color, 0.42f));
            if (lit || hot)
                paint_rim(cell, lit ? c.accent : c.text_2, 0, std::max(1.0f, 1.5f * theme.scale));
            const std::string number = number_text(value, {.digits = 2});
            if (text_width(font, number) + theme.px(6) < cell.width() &&
                cell.height() >= theme.px(16))
                paint_text(font, cell, c.text, number, Align::center);
        }
    const float line = theme.px(16);
    const auto caption = [&](const Rect& in, const std::string& words, Align align, Color color) {
        paint_text(font, in, color, words, align);
    };
    const float right = plot.cells.lo.x - theme.px(5);
    const Rect first = plot.cell(0, plot.columns - 1), last = plot.cell(0, 0);
    caption({{box.lo.x, first.lo.y}, {right, first.hi.y}}, "left", Align::right, c.text_3);
    caption({{box.lo.x, last.lo.y}, {right, last.hi.y}}, "right", Align::right, c.text_3);
    const glm::vec2 foot{plot.cells.lo.x, plot.cells.hi.y + theme.px(3)};
    const Rect below{foot, {plot.cells.hi.x, foot.y + line}};
    caption(below, "start", Align::left, c.text_3);
    caption(below, "end", Align::right, c.text_3);
    const int told = hovered >= 0 ? hovered : chosen;
    if (told < 0 || told >= plot.rows * plot.columns) return;
    const double u = style.along[static_cast<std::size_t>(told / plot.columns)],
                 v = style.across[static_cast<std::size_t>(told % plot.columns)];
    caption(below,
            fmt::format("{} {} at {}, {}", short_number(style.at(u, v) * style.scale), style.unit,
                        short_number(u), short_number(v)),
            Align::center, c.text_2);
}

} // namespace

Edit height_field(const Theme& theme, const std::string& id, Grid& values, int& chosen,
                  const HeightStyle& style, float width)
{
    ImGui::PushID(id.c_str());
    ImGuiStorage& kept = *ImGui::GetStateStorage();
    const ImGuiID top_id = ImGui::GetID("top"), value_id = ImGui::GetID("value");
    const auto rows = static_cast<int>(values.size()),
               columns = static_cast<int>(values.front().size());
    const float cells = std::max(
        theme.px(cells_at_1) * std::min(1.0f, static_cast<float>(columns) / 4),
        std::min(theme.px(least_cell_at_1) * static_cast<float>(columns), theme.px(cells_at_1)));
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Rect box =
        rect_at({at.x, at.y}, {width, theme.px(picture_at_1 + foot_at_1 + 20) + cells});
    ImGui::InvisibleButton("heights", {std::max(1.0f, width), box.height()});
    const bool active = ImGui::IsItemActive(), begun = ImGui::IsItemActivated();
    double top = 0;
    for (const std::vector<double>& row : values)
        for (const double value : row) top = std::max(top, value);
    top *= 1.1;
    // The picture must not change under a hand.
    if (active && !begun) top = std::max(1e-6, static_cast<double>(kept.GetFloat(top_id, 1)));
    kept.SetFloat(top_id, static_cast<float>(top));
    const float under_picture = box.lo.y + theme.px(picture_at_1 + 20);
    const HeightPlot plot{
        {box.lo + theme.px(10), {box.hi.x - theme.px(10), under_picture - theme.px(14)}},
        {{box.lo.x + theme.px(gutter_at_1), under_picture}, {box.hi.x, under_picture + cells}},
        top,
        rows,
        columns};
    const ImGuiIO& io = ImGui::GetIO();
    const int under =
        value_at(plot, style, {io.MousePos.x, io.MousePos.y}, grip_at_1 * theme.scale);
    const bool hovered = ImGui::IsItemHovered() || active;
    Edit edit = Edit::none;
    const auto value = [&]() -> double& {
        return values[static_cast<std::size_t>(chosen / columns)]
                     [static_cast<std::size_t>(chosen % columns)];
    };
    if (chosen >= rows * columns) chosen = -1;
    if (begun) {
        chosen = under;
        if (chosen >= 0) kept.SetFloat(value_id, static_cast<float>(value()));
    } else if (active && chosen >= 0 && ImGui::IsMouseDragging(ImGuiMouseButton_Left, 2)) {
        const double to = kept.GetFloat(value_id) - static_cast<double>(io.MouseDelta.y) *
                                                        (io.KeyShift ? 0.1 : 1.0) * plot.per_px();
        kept.SetFloat(value_id, static_cast<float>(to));
        const double now = std::clamp(io.KeyCtrl ? std::round(to / round_height) * round_height
                                                 : std::round(to * 1000) / 1000,
                                      style.lo, style.hi);
        if (now != value()) edit = Edit::changed;
        value() = now;
    }
    edit = after_drag(edit, chosen >= 0);
    if (hovered && under >= 0) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
    paint_heights(theme, box, plot, values, chosen, hovered && !active ? under : -1, style);
    ImGui::PopID();
    return edit;
}

} // namespace trivar::ui
