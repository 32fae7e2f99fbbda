// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/timing_overlay.h"

#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar::ui {
namespace {

std::string milliseconds(double ms)
{
    return ms < 10 ? fmt::format("{:.2f} ms", ms) : fmt::format("{:.1f} ms", ms);
}

// Good within a frame of 60 Hz, tolerable within one of 30.
Color verdict(const Theme& theme, double ms)
{
    return ms < 16.7 ? theme.color.good : ms < 33 ? theme.color.warn : theme.color.bad;
}

void draw_group(const Theme& theme, const TimingGroup& group, float& y, float left, float right)
{
    const Palette& c = theme.color;
    const float line = theme.px(20);
    const auto row = [&] {
        const Rect r{{left, y}, {right, y + line}};
        y += line;
        return r;
    };
    const double total = total_ms(*group.timings);
    Rect head = row();
    paint_text(theme.font.strong, head, c.text, group.title);
    paint_text(theme.font.strong, head, c.text, milliseconds(total), Align::right);
    for (const Timings::Stage& stage : group.timings->stages) {
        const Rect r = row();
        const auto share = static_cast<float>(stage.time_ms / std::max(total, 1e-9));
        const float bar_left = left + theme.px(128), bar_right = right - theme.px(72);
        paint_text(theme.font.small, r, c.text_2,
                   elided(theme.font.small, stage.name, theme.px(120)));
        paint_text(theme.font.small, r, c.text, milliseconds(stage.time_ms), Align::right);
        const Rect bar{{bar_left, r.center().y - theme.px(3)},
                       {bar_right, r.center().y + theme.px(3)}};
        paint_box(bar, c.field, theme.px(3));
        paint_box({bar.lo, {bar.lo.x + std::max(theme.px(2), bar.width() * share), bar.hi.y}},
                  group.color, theme.px(3));
    }
    y += theme.px(8);
}

} // namespace

double total_ms(const Timings& timings)
{
    double total = 0;
    for (const Timings::Stage& stage : timings.stages) total += stage.time_ms;
    return total;
}

void draw_timing(const Theme& theme, glm::vec2 at, float max_height,
                 const std::vector<TimingGroup>& groups, bool& open)
{
    double slowest = 0;
    std::size_t lines = 0;
    for (const TimingGroup& group : groups) {
        if (group.waited_for) slowest = std::max(slowest, total_ms(*group.timings));
        lines += group.timings->stages.size() + 1;
    }
    ImGui::SetCursorScreenPos({at.x, at.y});
    ImGui::PushID("timing");
    const Chip pill{milliseconds(slowest), verdict(theme, slowest)};
    const float width = text_width(theme.font.small, pill.text) + theme.px(30);
    if (ImGui::InvisibleButton("pill", {width, theme.size.row})) open = !open;
    tooltip(theme, "Timing", "F10", "The slower of the last evaluation and the last picture.");
    paint_chip(theme, at, pill);
    if (open) {
        const float height = theme.px(20) * static_cast<float>(lines) +
                             theme.px(8) * static_cast<float>(groups.size()) + theme.px(16);
        const Rect card =
            rect_at(at + glm::vec2(0, theme.px(28)), {theme.px(340), std::min(height, max_height)});
        paint_box(card, faded(theme.color.raised, 0.94f), theme.size.rounding_card);
        paint_rim(card, theme.color.raised_rim, theme.size.rounding_card, theme.size.hairline);
        ImGui::PushClipRect({card.lo.x, card.lo.y}, {card.hi.x, card.hi.y}, true);
        float y = card.lo.y + theme.px(12);
        for (const TimingGroup& group : groups)
            draw_group(theme, group, y, card.lo.x + theme.px(14), card.hi.x - theme.px(14));
        ImGui::PopClipRect();
    }
    ImGui::PopID();
}

} // namespace trivar::ui
