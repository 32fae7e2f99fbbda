// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/inspector/wound_section.h"

#include "ui/held_value.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar {
namespace {

constexpr float section_height = 148;     // at scale 1
constexpr double above_share = 0.3;       // of the height, over the skin
constexpr std::size_t profile_cells = 20; // of a profile that a hand draws
constexpr double deeper = 1.35;           // that is shown below the greatest depth

// Between the picture and the wound.
struct SectionPlot {
    ui::Rect rect;
    double below = 1, above = 1; // metres from the skin to the edges
    float skin() const { return rect.lo.y + static_cast<float>(above_share) * rect.height(); }
    float x(double share) const { return rect.lo.x + static_cast<float>(share) * rect.width(); }
    float depth(double metres) const
    {
        return skin() + static_cast<float>(metres / below) * (rect.hi.y - skin());
    }
    float gap(double metres) const
    {
        return skin() - static_cast<float>(metres / above) * (skin() - rect.lo.y);
    }
    double share(float at) const
    {
        return std::clamp(static_cast<double>((at - rect.lo.x) / rect.width()), 0.0, 1.0);
    }
    double depth_at(float y) const
    {
        return static_cast<double>((y - skin()) / (rect.hi.y - skin())) * below;
    }
    double gap_at(float y) const
    {
        return static_cast<double>((skin() - y) / (skin() - rect.lo.y)) * above;
    }
};

// Fills between two curves, both y by share of the length.
template <class Upper, class Lower>
void fill_between(const SectionPlot& plot, ui::Color color, const Upper& upper, const Lower& lower)
{
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const int steps = std::max(16, static_cast<int>(plot.rect.width() / 2));
    for (int i = 0; i < steps; ++i) {
        const double a = static_cast<double>(i) / steps, b = static_cast<double>(i + 1) / steps;
        const float ya = lower(a), yb = lower(b), ua = upper(a), ub = upper(b);
        if (ya <= ua && yb <= ub) continue;
        list.AddQuadFilled({plot.x(a), ua}, {plot.x(b), ub}, {plot.x(b), yb}, {plot.x(a), ya},
                           color);
    }
}

template <class Curve>
std::vector<glm::vec2> section_path(const SectionPlot& plot, const Curve& curve)
{
    std::vector<glm::vec2> out;
    const int steps = std::max(16, static_cast<int>(plot.rect.width() / 2));
    for (int i = 0; i <= steps; ++i) {
        const double x = static_cast<double>(i) / steps;
        out.emplace_back(plot.x(x), curve(x));
    }
    return out;
}

ui::Color wall_color(const glm::vec4& linear)
{
    const auto byte = [](float v) {
        const float s = v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f;
        return static_cast<unsigned>(std::clamp(s, 0.0f, 1.0f) * 255 + 0.5f);
    };
    return ui::rgb(byte(linear.r) << 16 | byte(linear.g) << 8 | byte(linear.b));
}

double thickness_at(const WoundSection& section, double x)
{
    if (section.thickness.empty()) return 0;
    const double at = x * static_cast<double>(section.thickness.size() - 1);
    return section.thickness[static_cast<std::size_t>(at + 0.5)];
}

void paint_section(const ui::Theme& theme, const ui::Rect& box, const SectionPlot& plot,
                   const WoundSection& section, const Incision& cut)
{
    const ui::Palette& c = theme.color;
    ui::paint_box(box, c.base, theme.size.rounding_small);
    ImGui::PushClipRect({box.lo.x, box.lo.y}, {box.hi.x, box.hi.y}, true);
    const auto skin = [&](double) { return plot.skin(); };
    const auto bottom = [&](double x) {
        const double thick = thickness_at(section, x);
        return thick > 0 ? std::min(plot.depth(thick), plot.rect.hi.y) : plot.rect.hi.y;
    };
    const auto floor = [&](double x) {
        return plot.depth(cut.depth * value_at(cut.depth_profile, x));
    };
    const auto lips = [&](double x) {
        return plot.gap(cut.width * value_at(cut.opening_profile, x));
    };
    fill_between(plot, c.field, skin, bottom);
    ui::paint_path(section_path(plot, bottom), c.text_3, theme.size.hairline);
    double from = 0;
    const auto layers = section.layers.empty()
                            ? std::vector<std::pair<double, glm::vec4>>{{0, glm::vec4(0)}}
                            : section.layers;
    for (std::size_t k = 0; k < layers.size(); ++k) {
        const bool last = k + 1 == layers.size();
        const double to = last ? 1e9 : layers[k].first;
        const ui::Color color =
            section.layers.empty() ? ui::faded(c.incision, 0.3f) : wall_color(layers[k].second);
        fill_between(
            plot, color, [&](double x) { return std::min(plot.depth(from), floor(x)); },
            [&](double x) { return last ? floor(x) : std::min(plot.depth(to), floor(x)); });
        from = to;
    }
    fill_between(plot, ui::faded(c.incision, 0.22f), lips, skin);
    ui::paint_line({plot.rect.lo.x, plot.skin()}, {plot.rect.hi.x, plot.skin()}, c.text_2,
                   theme.size.hairline);
    ui::paint_path(section_path(plot, lips), c.incision, 2 * theme.scale);
    ui::paint_path(section_path(plot, floor), c.lattice, 2 * theme.scale);
    ImGui::PopClipRect();
}

void paint_section_words(const ui::Theme& theme, const ui::Rect& box, const SectionPlot& plot,
                         const WoundSection& section, const Incision& cut, bool hovered)
{
    const ui::Palette& c = theme.color;
    const float line = theme.px(16), left = box.lo.x, right = plot.rect.lo.x - theme.px(5);
    const auto beside = [&](float y, double metres) {
        ui::paint_text(theme.font.small, {{left, y - line / 2}, {right, y + line / 2}}, c.text_3,
                       ui::short_number(metres), ui::Align::right);
    };
    beside(plot.gap(cut.width), cut.width);
    beside(plot.depth(cut.depth), cut.depth);
    const glm::vec2 foot{plot.rect.lo.x, plot.rect.hi.y + theme.px(3)};
    const glm::vec2 end{plot.rect.hi.x, foot.y + line};
    ui::paint_text(theme.font.small, {foot, end}, c.text_3, "start", ui::Align::left);
    ui::paint_text(theme.font.small, {foot, end}, c.text_3, "end", ui::Align::right);
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const double x = plot.share(mouse.x);
    const std::string words =
        !hovered ? ui::short_number(section.length) + " m"
        : mouse.y < plot.skin()
            ? fmt::format("{} m wide",
                          ui::short_number(cut.width * value_at(cut.opening_profile, x)))
            : fmt::format("{} of {} m deep",
                          ui::short_number(cut.depth * value_at(cut.depth_profile, x)),
                          ui::short_number(thickness_at(section, x)));
    ui::paint_text(theme.font.small, {foot, end}, c.text_2, words, ui::Align::center);
}

// Before the soft ends: what a custom profile must say so that this value comes out.
double before_ends(double x, double value)
{
    const double ends = value_at({IncisionProfile::Shape::even, {}}, x);
    return ends > 0.05 ? std::clamp(value / ends, 0.0, 1.0) : std::clamp(value, 0.0, 1.0);
}

} // namespace

WoundSection section_of(const IncisedSkin& skin, const NamedIncision& incision,
                        const std::vector<IncisionLayer>& layers)
{
    WoundSection out;
    const std::optional<SeenIncision> seen = seen_incision(skin, incision, nullptr);
    if (!seen) return out;
    std::vector<SurfacePoint> at;
    for (const SurfaceHit& each : seen->line) at.push_back(each.at_rest);
    out.thickness = skin.thickness(at);
    out.length = seen->length;
    for (const IncisionLayer& layer : layers)
        out.layers.emplace_back(layer.depth, layer.look.base_color);
    return out;
}

IncisionProfile drawn_over(const IncisionProfile& profile, glm::dvec2 from, glm::dvec2 to)
{
    if (from.x > to.x) std::swap(from, to);
    IncisionProfile out{IncisionProfile::Shape::custom, {}};
    for (std::size_t i = 0; i <= profile_cells; ++i) {
        const double x = static_cast<double>(i) / profile_cells, half = 0.5 / profile_cells;
        double y = before_ends(x, value_at(profile, x));
        if (i == 0 || i == profile_cells) { // where the ends make it 0 anyway
            const double beside = i == 0 ? half : 1 - half;
            y = before_ends(beside, value_at(profile, beside));
        }
        if (x >= from.x - half && x <= to.x + half) {
            const double t =
                to.x > from.x ? std::clamp((x - from.x) / (to.x - from.x), 0.0, 1.0) : 1;
            y = before_ends(x, glm::mix(from.y, to.y, t));
        }
        out.points.emplace_back(x, std::round(y * 1e3) / 1e3);
    }
    return out;
}

ui::Edit draw_wound_section(const ui::Theme& theme, const WoundSection& section, Incision& cut,
                            float width)
{
    ImGui::PushID("section");
    ImGuiStorage& kept = *ImGui::GetStateStorage();
    const ImGuiID x_id = ImGui::GetID("x"), y_id = ImGui::GetID("y"),
                  part_id = ImGui::GetID("part");
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ui::Rect box = ui::rect_at({at.x, at.y}, {width, theme.px(section_height)});
    ImGui::InvisibleButton("wound", {std::max(1.0f, width), box.height()});
    const bool active = ImGui::IsItemActive(), begun = ImGui::IsItemActivated();
    const bool hovered = ImGui::IsItemHovered() || active;
    const float numbers = std::max(ui::text_width(theme.font.small, ui::short_number(cut.width)),
                                   ui::text_width(theme.font.small, ui::short_number(cut.depth)));
    const float left = std::max(theme.px(40), std::ceil(numbers) + theme.px(13));
    const SectionPlot plot{
        {box.lo + glm::vec2(left, theme.px(8)), box.hi - glm::vec2(theme.px(10), theme.px(22))},
        cut.depth * deeper,
        cut.width * 1.15};
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    ui::Edit edit = ui::Edit::none;
    if (active) {
        if (begun) kept.SetBool(part_id, mouse.y < plot.skin());
        const bool gap = kept.GetBool(part_id);
        const double value =
            gap ? plot.gap_at(mouse.y) / cut.width : plot.depth_at(mouse.y) / cut.depth;
        const glm::dvec2 now(plot.share(mouse.x), std::clamp(value, 0.0, 1.0));
        const glm::dvec2 before =
            begun ? now : glm::dvec2(kept.GetFloat(x_id), kept.GetFloat(y_id));
        if (!begun && glm::dvec2(glm::vec2(now)) != before) {
            IncisionProfile& profile = gap ? cut.opening_profile : cut.depth_profile;
            profile = drawn_over(profile, before, now);
            edit = ui::Edit::changed;
        }
        kept.SetFloat(x_id, static_cast<float>(now.x));
        kept.SetFloat(y_id, static_cast<float>(now.y));
    }
    edit = ui::after_drag(edit, active);
    paint_section(theme, box, plot, section, cut);
    paint_section_words(theme, box, plot, section, cut, hovered);
    ui::tooltip({"Section along the incision",
                 {},
                 "Draw above the skin how wide it gapes, and below it how deep it goes; the grey "
                 "is the body with its real thickness."});
    ImGui::PopID();
    return edit;
}

} // namespace trivar
