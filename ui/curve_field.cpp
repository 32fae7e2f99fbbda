// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/curve_field.h"

#include "ui/held_value.h"
#include "ui/input.h"
#include "ui/keys.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar::ui {
namespace {

constexpr float height_at_1 = 116, reach_at_1 = 9;
constexpr double closest = 0.01; // that points may come to one another
constexpr double round_factor = 0.05;

// A round number above: the top of the picture.
double round_above(double value)
{
    const double unit = std::pow(10, std::floor(std::log10(std::max(value, 1e-6))));
    for (const double step : {1.0, 1.5, 2.0, 3.0, 5.0, 10.0})
        if (value <= step * unit * 1.0001) return step * unit;
    return 10 * unit;
}

// Between the picture of the curve and its values.
struct Plot {
    Rect rect;
    double top = 1;
    glm::vec2 seen(glm::dvec2 p) const
    {
        return {rect.lo.x + static_cast<float>(p.x) * rect.width(),
                rect.hi.y - static_cast<float>(p.y / top) * rect.height()};
    }
    glm::dvec2 meant(glm::vec2 p) const
    {
        return {(p.x - rect.lo.x) / rect.width(), (rect.hi.y - p.y) / rect.height() * top};
    }
};

// Returns the range of the value of a point between two others; `after` is the index of the next
// one.
glm::dvec2 range_between(const std::vector<glm::dvec2>& points, std::size_t before,
                         std::size_t after, const CurveStyle& style)
{
    if (!style.ascends) return {style.lo, style.hi};
    return {points[before].y + style.least_step, points[after].y - style.least_step};
}

// Adds a point where the mouse is, if its neighbours leave room; its index or -1.
int add_point(std::vector<glm::dvec2>& points, glm::dvec2 p, const CurveStyle& style)
{
    const auto after = std::upper_bound(points.begin(), points.end(), p.x,
                                        [](double x, const glm::dvec2& q) { return x < q.x; });
    if (points.size() >= style.most_points || after == points.begin() || after == points.end() ||
        p.x - (after - 1)->x < closest || after->x - p.x < closest)
        return -1;
    const auto next = static_cast<std::size_t>(after - points.begin());
    const glm::dvec2 range = range_between(points, next - 1, next, style);
    if (range.x > range.y) return -1;
    p.y = std::clamp(p.y, range.x, range.y);
    const auto inserted = points.insert(after, p);
    return static_cast<int>(inserted - points.begin());
}

void drag_point(std::vector<glm::dvec2>& points, std::size_t i, glm::dvec2 to,
                const CurveStyle& style)
{
    const ImGuiIO& io = ImGui::GetIO();
    if (io.KeyCtrl) to = glm::round(to / round_factor) * round_factor;
    const bool end = i == 0 || i + 1 == points.size();
    if (end && style.ascends) return;
    const glm::dvec2 range =
        end ? glm::dvec2(style.lo, style.hi) : range_between(points, i - 1, i + 1, style);
    to.y = std::clamp(to.y, range.x, std::max(range.x, range.y));
    to.x =
        end ? points[i].x : std::clamp(to.x, points[i - 1].x + closest, points[i + 1].x - closest);
    // Values that people can read.
    points[i] = {std::round(to.x * 1e4) / 1e4,
                 std::clamp(std::round(to.y * 1e4) / 1e4, range.x, std::max(range.x, range.y))};
}

void paint(const Theme& theme, const Rect& box, const Plot& plot,
           const std::vector<glm::dvec2>& points, int chosen, int hovered, const CurveStyle& style)
{
    const Palette& c = theme.color;
    paint_box(box, c.base, theme.size.rounding_small);
    for (int i = 0; i <= 4; ++i) {
        const float x = plot.seen({i / 4.0, 0}).x;
        paint_line({x, plot.rect.lo.y}, {x, plot.rect.hi.y}, c.line_soft, theme.size.hairline);
    }
    for (int i = 0; i <= 2; ++i) {
        const float y = plot.seen({0, plot.top * i / 2}).y;
        paint_line({plot.rect.lo.x, y}, {plot.rect.hi.x, y}, c.line_soft, theme.size.hairline);
    }
    std::vector<glm::vec2> curve, polygon;
    const int steps = std::max(2, static_cast<int>(plot.rect.width() / 2));
    for (int i = 0; i <= steps; ++i) {
        const double t = static_cast<double>(i) / steps;
        curve.push_back(plot.seen({t, style.at(t)}));
    }
    for (const glm::dvec2& p : points) polygon.push_back(plot.seen(p));
    ImGui::PushClipRect({box.lo.x, box.lo.y}, {box.hi.x, box.hi.y}, true);
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    for (std::size_t i = 1; i < curve.size(); ++i)
        draw.AddQuadFilled({curve[i - 1].x, curve[i - 1].y}, {curve[i].x, curve[i].y},
                           {curve[i].x, plot.rect.hi.y}, {curve[i - 1].x, plot.rect.hi.y},
                           faded(style.color, 0.12f));
    paint_path(polygon, c.text_3, theme.size.hairline);
    paint_path(curve, style.color, 2 * theme.scale);
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const bool lit = static_cast<int>(i) == chosen, hot = static_cast<int>(i) == hovered;
        paint_dot(polygon[i], theme.scale * (lit || hot ? 5.5f : 4.0f),
                  lit ? c.accent : c.field_active, c.text, 1.5f * theme.scale);
    }
    ImGui::PopClipRect();
    const auto caption = [&](glm::vec2 lo, glm::vec2 hi, const std::string& words, Align align) {
        paint_text(theme.font.small, {lo, hi}, c.text_3, words, align);
    };
    const float left = box.lo.x, line = theme.px(16);
    const auto number = [&](double value) { return short_number(value * style.scale); };
    caption({left, plot.rect.lo.y - line / 2},
            {plot.rect.lo.x - theme.px(5), plot.rect.lo.y + line / 2}, number(plot.top),
            Align::right);
    caption({left, plot.rect.hi.y - line / 2},
            {plot.rect.lo.x - theme.px(5), plot.rect.hi.y + line / 2}, "0", Align::right);
    const glm::vec2 foot{plot.rect.lo.x, plot.rect.hi.y + theme.px(3)};
    const glm::vec2 end{plot.rect.hi.x, foot.y + line};
    caption(foot, end, style.ends[0], Align::left);
    caption(foot, end, style.ends[1], Align::right);
    const int told = hovered >= 0 ? hovered : chosen;
    if (told < 0 || told >= static_cast<int>(points.size())) return;
    const glm::dvec2 p = points[static_cast<std::size_t>(told)];
    paint_text(theme.font.small, {foot, end}, c.text_2,
               fmt::format("{} {} at {}", number(p.y), style.unit, short_number(p.x)),
               Align::center);
}

} // namespace

Edit curve_field(const Theme& theme, const std::string& id, std::vector<glm::dvec2>& points,
                 int& chosen, const CurveStyle& style, float width)
{
    ImGui::PushID(id.c_str());
    ImGuiStorage& kept = *ImGui::GetStateStorage();
    const ImGuiID top_id = ImGui::GetID("top"), x_id = ImGui::GetID("x"), y_id = ImGui::GetID("y");
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Rect box = rect_at({at.x, at.y}, {width, theme.px(height_at_1)});
    ImGui::InvisibleButton("curve", {std::max(1.0f, width), box.height()});
    const bool active = ImGui::IsItemActive(), begun = ImGui::IsItemActivated();
    double highest = 0;
    for (const glm::dvec2& p : points) highest = std::max(highest, p.y);
    // The picture must not change under a hand.
    double top = style.ascends ? highest : round_above(highest * 1.1);
    if (active && !begun) top = std::max(1e-6, static_cast<double>(kept.GetFloat(top_id, 1)));
    kept.SetFloat(top_id, static_cast<float>(top));
    const Plot plot{{box.lo + glm::vec2(theme.px(34), theme.px(10)),
                     box.hi - glm::vec2(theme.px(10), theme.px(22))},
                    top};
    const ImGuiIO& io = ImGui::GetIO();
    const glm::vec2 mouse{io.MousePos.x, io.MousePos.y};
    const int under = point_at(points, plot, mouse, reach_at_1 * theme.scale);
    const bool hovered = ImGui::IsItemHovered() || active;
    Edit edit = Edit::none;
    if (begun) {
        chosen = under;
        if (io.KeyCtrl && under > 0 && under + 1 < static_cast<int>(points.size())) {
            points.erase(points.begin() + under);
            chosen = -1;
            edit = Edit::changed;
        } else if (io.KeyCtrl && under < 0) {
            chosen = add_point(points, plot.meant(mouse), style);
            if (chosen >= 0) edit = Edit::changed;
        }
        if (chosen >= 0) { // from where the point is, not from where the hand is on it
            const glm::dvec2 p = points[static_cast<std::size_t>(chosen)];
            kept.SetFloat(x_id, static_cast<float>(p.x));
            kept.SetFloat(y_id, static_cast<float>(p.y));
        }
    } else if (active && chosen >= 0 && chosen < static_cast<int>(points.size()) &&
               ImGui::IsMouseDragging(ImGuiMouseButton_Left, 2)) {
        const float fine = io.KeyShift ? 0.1f : 1.0f;
        const glm::dvec2 per_px{1 / plot.rect.width(), -plot.top / plot.rect.height()};
        const glm::dvec2 to{kept.GetFloat(x_id) + io.MouseDelta.x * fine * per_px.x,
                            kept.GetFloat(y_id) + io.MouseDelta.y * fine * per_px.y};
        kept.SetFloat(x_id, static_cast<float>(to.x));
        kept.SetFloat(y_id, static_cast<float>(to.y));
        const std::vector<glm::dvec2> before = points;
        drag_point(points, static_cast<std::size_t>(chosen), to, style);
        if (points != before) edit = Edit::changed;
    }
    if (hovered && chosen >= 0) {
        hands().keep_key(key_delete); // an end stays: nothing else is deleted in its place
        const bool inner = chosen > 0 && chosen + 1 < static_cast<int>(points.size());
        if (inner && !active && struck({key_delete})) {
            points.erase(points.begin() + chosen);
            chosen = -1;
            edit = Edit::changed;
        }
    }
    edit = after_drag(edit, chosen >= 0);
    if (hovered && (under >= 0 || io.KeyCtrl)) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    paint(theme, box, plot, points, chosen, hovered && !active ? under : -1, style);
    ImGui::PopID();
    return edit;
}

} // namespace trivar::ui
