// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/timeline.h"

#include <algorithm>
#include <cmath>

namespace trivar {

float names_end(const ui::Theme& theme, const ui::Rect& r)
{
    return r.lo.x + std::min(theme.px(200), std::round(r.width() * 0.35f));
}

FrameScale track_scale(const ui::Theme& theme, const ui::Rect& r, const Editor& editor)
{
    const Time& time = editor.session.document().time;
    const glm::dvec2 all(time.first_frame, time.last_frame);
    glm::dvec2 shown = editor.timeline.shown.value_or(all);
    if (shown.x < all.x || shown.y > all.y) shown = all; // the range was changed
    return {names_end(theme, r) + theme.px(48), r.hi.x - theme.px(28), shown.x, shown.y, time};
}

glm::dvec2 zoomed_frames(glm::dvec2 shown, const Time& time, double frame, double notches)
{
    constexpr double least = 10;
    const glm::dvec2 all(time.first_frame, time.last_frame);
    const double width = shown.y - shown.x;
    const double wanted =
        std::clamp(width * std::pow(0.8, notches), std::min(least, all.y - all.x), all.y - all.x);
    if (!(width > 0)) return all;
    // The frame stays under the mouse, unless an end comes into sight.
    const double share = std::clamp((frame - shown.x) / width, 0.0, 1.0);
    const double first =
        std::clamp(std::clamp(frame, all.x, all.y) - share * wanted, all.x, all.y - wanted);
    return {first, first + wanted};
}

glm::dvec2 rolled_frames(glm::dvec2 shown, const Time& time, double notches)
{
    constexpr double share = 0.1; // of what is shown, a notch
    const double width = shown.y - shown.x;
    const double first =
        std::clamp(shown.x - notches * share * width, static_cast<double>(time.first_frame),
                   std::max<double>(time.first_frame, time.last_frame - width));
    return {first, first + width};
}

float FrameScale::x(double frame) const
{
    return lo + static_cast<float>((frame - first) / std::max(1.0, last - first)) * (hi - lo);
}

double FrameScale::frame_at(float at) const
{
    return first +
           static_cast<double>((at - lo) / std::max(1.0f, hi - lo)) * std::max(1.0, last - first);
}

} // namespace trivar
