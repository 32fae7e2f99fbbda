// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/foot_cards.h"
#include "editor/panels/panels.h"
#include "editor/picture/limit_colors.h"
#include "editor/picture/shown_values.h"
#include "editor/session/session_facts.h"
#include "gpu/color_map.h"
#include "ui/widgets.h"

#include <array>
#include <cmath>
#include <imgui.h>

namespace trivar {
namespace {

ui::Color screen_color(const glm::vec3& linear)
{
    const auto byte = [](float c) {
        const float s = c <= 0.0031308f ? 12.92f * c : 1.055f * std::pow(c, 1 / 2.4f) - 0.055f;
        return static_cast<unsigned>(std::lround(255 * s));
    };
    return ui::rgb(byte(linear.r) << 16 | byte(linear.g) << 8 | byte(linear.b));
}

// A Legend names the colours of a picture.
struct Legend {
    std::string title;
    std::array<std::string, 3> marks;      // at the lower end, in the middle and at the upper end
    glm::vec3 (*color)(float t) = nullptr; // -1..1
    std::string turned = {}; // the word for what is turned inside out; empty: nothing is
};

std::string millimetres(double metres)
{
    return ui::short_number(metres * 1000) + " mm";
}

std::optional<Legend> legend_of(const Session& session)
{
    if (heights_in_hand(session) != 0) {
        const auto color = [](float t) { return limit_color((static_cast<double>(t) + 1) / 2); };
        return Legend{
            "Height of tiles relative to their fold limit", {"0 %", "50 %", "100 %"}, color};
    }
    const Document& document = session.document();
    const ColorBy by = document.render->color_by;
    if (by == ColorBy::material || by == ColorBy::uv_checker) return std::nullopt;
    if (by == ColorBy::stretch)
        return Legend{"Local volume relative to the average",
                      {"half", "average", "double"},
                      gpu::diverging_color,
                      "folded"};
    if (by == ColorBy::uv_areas)
        return Legend{"Area in the texture, relative to the average",
                      {"half", "average", "double"},
                      gpu::diverging_color,
                      "mirrored"};
    const auto color = [](float t) { return gpu::sequential_color((t + 1) / 2); };
    if (by == ColorBy::uv_angles)
        return Legend{"Stretch one way, relative to the other",
                      {"none", "1.4 times", "double"},
                      color,
                      "mirrored"};
    const std::optional<double> tolerance = shown_tolerance(document);
    if (!tolerance)
        return Legend{
            "Certified error relative to the tolerance", {"1/8", "tolerance", "8 times"}, color};
    return Legend{"Certified error, the tolerance in the middle",
                  {millimetres(*tolerance * std::exp2(shown_errors.x)), millimetres(*tolerance),
                   millimetres(*tolerance * std::exp2(shown_errors.y))},
                  color};
}

void draw_folded(const ui::Theme& theme, const ui::Rect& box)
{
    ui::paint_box(box, screen_color(gpu::folded_color(false)));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float period = theme.px(10), slant = box.hi.y - box.lo.y;
    list.PushClipRect({box.lo.x, box.lo.y}, {box.hi.x, box.hi.y}, true);
    for (float at = box.lo.x; at < box.hi.x + slant; at += period)
        list.AddLine({at, box.lo.y}, {at - slant, box.hi.y}, screen_color(gpu::folded_color(true)),
                     period * 0.35f);
    list.PopClipRect();
}

} // namespace

std::optional<ui::Rect> draw_legend(const Session& session, const ui::Theme& theme,
                                    const FootCards& foot)
{
    const std::optional<Legend> legend = legend_of(session);
    if (!legend) return {};
    const glm::vec2 size(theme.px(292), theme.px(72));
    const float left_of_all = foot.view().lo.x + theme.px(12);
    const ui::Rect view = foot.above(left_of_all, left_of_all + size.x);
    if (view.width() < size.x + theme.px(24)) return {};
    const ui::Rect card =
        ui::rect_at({view.lo.x + theme.px(12), view.hi.y - size.y - theme.px(12)}, size);
    ui::paint_card(theme, card);
    ui::lower_area("legend", card); // takes the clicks
    const float left = card.lo.x + theme.px(12);
    const float width = theme.px(legend->turned.empty() ? 268 : 204);
    const auto words = [&](float from, float to, const std::string& text, ui::Align align) {
        ui::paint_text(theme.font.small,
                       {{from, card.lo.y + theme.px(46)}, {to, card.lo.y + theme.px(64)}},
                       theme.color.text_2, text, align);
    };
    ui::paint_text(theme.font.small_strong,
                   {{left, card.lo.y + theme.px(6)}, {card.hi.x, card.lo.y + theme.px(24)}},
                   theme.color.text, legend->title);
    const float top = card.lo.y + theme.px(28), bottom = top + theme.px(14);
    constexpr int steps = 64;
    for (int i = 0; i < steps; ++i) {
        const float a = static_cast<float>(i) / steps, b = static_cast<float>(i + 1) / steps;
        ui::paint_box({{std::round(left + a * width), top}, {std::round(left + b * width), bottom}},
                      screen_color(legend->color(a + b - 1)));
    }
    const auto rim = [&](const ui::Rect& box) { // white and pale ones stand on a white card
        ui::paint_rim(box, theme.color.text_3, 0, theme.size.hairline);
    };
    rim({{left, top}, {std::round(left + width), bottom}});
    words(left, left + width, legend->marks[0], ui::Align::left);
    words(left, left + width, legend->marks[1], ui::Align::center);
    words(left, left + width, legend->marks[2], ui::Align::right);
    if (!legend->turned.empty()) {
        const float x = left + width + theme.px(12);
        const ui::Rect folded{{x, top}, {x + theme.px(40), bottom}};
        draw_folded(theme, folded);
        rim(folded);
        words(x, x + theme.px(52), legend->turned, ui::Align::left);
    }
    return card;
}

} // namespace trivar
