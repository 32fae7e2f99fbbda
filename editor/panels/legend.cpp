// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/foot_cards.h"
#include "editor/panels/panels.h"
#include "gpu/color_map.h"
#include "ui/widgets.h"

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

} // namespace

std::optional<ui::Rect> draw_legend(const ui::Theme& theme, const FootCards& foot)
{
    const glm::vec2 size(theme.px(292), theme.px(72));
    const float left_of_all = foot.view().lo.x + theme.px(12);
    const ui::Rect view = foot.above(left_of_all, left_of_all + size.x);
    if (view.width() < size.x + theme.px(24)) return {};
    const ui::Rect card =
        ui::rect_at({view.lo.x + theme.px(12), view.hi.y - size.y - theme.px(12)}, size);
    ui::paint_card(theme, card);
    ui::lower_area("legend", card); // takes the clicks
    const float left = card.lo.x + theme.px(12), width = theme.px(204);
    const auto words = [&](float x, float y, float room, const char* text) {
        ui::paint_text(theme.font.small,
                       {{x, card.lo.y + theme.px(y)}, {x + room, card.lo.y + theme.px(y + 18)}},
                       theme.color.text_2, text);
    };
    ui::paint_text(theme.font.small_strong,
                   {{left, card.lo.y + theme.px(6)}, {card.hi.x, card.lo.y + theme.px(24)}},
                   theme.color.text, "Volume, beside what is usual in it");
    const float top = card.lo.y + theme.px(28), bottom = top + theme.px(14);
    constexpr int steps = 64;
    for (int i = 0; i < steps; ++i) {
        const float a = static_cast<float>(i) / steps, b = static_cast<float>(i + 1) / steps;
        ui::paint_box({{std::round(left + a * width), top}, {std::round(left + b * width), bottom}},
                      screen_color(gpu::diverging_color(a + b - 1)));
    }
    const auto rim = [&](float from, float to) { // white and pale ones stand on a white card
        ui::paint_rim({{from, top}, {to, bottom}}, theme.color.text_3, 0, theme.size.hairline);
    };
    rim(left, std::round(left + width));
    words(left, 46, width, "half");
    words(left + width / 2 - ui::text_width(theme.font.small, "usual") / 2, 46, width, "usual");
    words(left + width - ui::text_width(theme.font.small, "double"), 46, width, "double");
    const float x = left + width + theme.px(12), right = x + theme.px(40), period = theme.px(10);
    ui::paint_box({{x, top}, {right, bottom}}, screen_color(gpu::folded_color(false)));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRect({x, top}, {right, bottom}, true);
    for (float at = x; at < right + (bottom - top); at += period)
        list.AddLine({at, top}, {at - (bottom - top), bottom},
                     screen_color(gpu::folded_color(true)), period * 0.35f);
    list.PopClipRect();
    rim(x, right);
    words(x, 46, theme.px(52), "folded");
    return card;
}

} // namespace trivar
