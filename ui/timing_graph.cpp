// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/timing_graph.h"

#include <algorithm>
#include <cmath>

namespace trivar::ui {
namespace {

constexpr double good_ms = 16.7, slow_ms = 33.3;

float bar_width(const Rect& graph)
{
    return graph.width() / static_cast<float>(TimingHistory::length);
}

} // namespace

Color timing_color(const Theme& theme, double ms)
{
    return ms < good_ms ? theme.color.good : ms < slow_ms ? theme.color.warn : theme.color.bad;
}

void draw_timing_graph(const Theme& theme, const TimingHistory& history, const Rect& in,
                       long marked)
{
    const Palette& c = theme.color;
    double top_ms = slow_ms * 1.2;
    for (const TimedPicture& picture : history.pictures())
        top_ms = std::max(top_ms, total_ms(picture));
    const auto level = [&](double ms) {
        return in.hi.y - static_cast<float>(ms / top_ms) * in.height();
    };
    paint_box(in, c.field, theme.px(3));
    const float step = bar_width(in);
    long number = history.count() - static_cast<long>(history.pictures().size()) + 1;
    float x = in.hi.x - step * static_cast<float>(history.pictures().size());
    for (const TimedPicture& picture : history.pictures()) {
        const float evaluation = level(total_ms(picture.evaluation)),
                    whole = std::min(level(total_ms(picture)), in.hi.y - 1);
        const float right = x + std::max(1.0f, step - theme.px(1));
        if (number == marked) paint_box({{x, in.lo.y}, {right, in.hi.y}}, faded(c.text, 0.25f));
        paint_box({{x, whole}, {right, evaluation}}, c.gpu);
        paint_box({{x, evaluation}, {right, in.hi.y}}, c.cpu);
        x += step;
        ++number;
    }
    for (const double ms : {good_ms, slow_ms}) {
        if (ms == good_ms && level(good_ms) - level(slow_ms) < theme.px(3)) continue; // as one
        paint_line({in.lo.x, level(ms)}, {in.hi.x, level(ms)},
                   faded(timing_color(theme, ms - 1), 0.8f), theme.size.hairline);
    }
}

long picture_at(const TimingHistory& history, const Rect& graph, float x)
{
    const auto back = static_cast<long>(std::floor((graph.hi.x - x) / bar_width(graph)));
    const long number = history.count() - back;
    return x < graph.hi.x && history.find(number) ? number : 0;
}

} // namespace trivar::ui
