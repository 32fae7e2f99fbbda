// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/timeline/timeline.h"
#include "ui/icons.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>

namespace trivar {

float names_end(const ui::Theme& theme, const ui::Rect& r)
{
    return r.lo.x + std::min(theme.px(200), std::round(r.width() * 0.35f));
}

FrameScale track_scale(const ui::Theme& theme, const ui::Rect& r, const Editor& editor)
{
    const Document& document = editor.session.document();
    const Time& time = document.time;
    const glm::dvec2 scenes(time.first_frame, time.last_frame);
    const std::optional<glm::dvec2> keys = keyed_frames(document);
    const glm::dvec2 all =
        keys ? glm::dvec2(std::min(scenes.x, keys->x), std::max(scenes.y, keys->y)) : scenes;
    glm::dvec2 shown = editor.timeline.shown.value_or(scenes);
    if (shown.x < all.x || shown.y > all.y) shown = scenes; // the range was changed
    const float at_ends = theme.px(52); // room for a number, and the mark of keys beyond it
    return {names_end(theme, r) + at_ends, r.hi.x - at_ends, shown.x, shown.y, time, all, keys};
}

glm::dvec2 zoomed_frames(glm::dvec2 shown, glm::dvec2 all, double frame, double notches)
{
    constexpr double least = 10;
    const double width = shown.y - shown.x;
    const double wanted =
        std::clamp(width * std::pow(0.8, notches), std::min(least, all.y - all.x), all.y - all.x);
    if (!(width > 0)) return all;
    // The frame stays under the mouse, unless an end comes into sight.
    frame = std::clamp(frame, shown.x, shown.y);
    const double share = (frame - shown.x) / width;
    const double first = std::clamp(frame - share * wanted, all.x, all.y - wanted);
    return {first, first + wanted};
}

glm::dvec2 rolled_frames(glm::dvec2 shown, glm::dvec2 all, double notches)
{
    constexpr double share = 0.1; // of what is shown, a notch
    const double width = shown.y - shown.x;
    const double first =
        std::clamp(shown.x - notches * share * width, all.x, std::max(all.x, all.y - width));
    return {first, first + width};
}

std::optional<glm::dvec2> kept_frames(glm::dvec2 shown, const Time& time)
{
    if (shown == glm::dvec2(time.first_frame, time.last_frame)) return std::nullopt;
    return shown;
}

void draw_marks_of_keys(Editor& editor, const ui::Theme& theme, const ui::Rect& ruler,
                        const FrameScale& scale)
{
    if (!scale.keys) return;
    const glm::vec2 side(theme.size.icon_button);
    const float top = std::round(ruler.center().y - side.y / 2);
    const auto mark = [&](float x, const char* id, const char* icon, const char* where,
                          glm::dvec2 shown) {
        ImGui::SetCursorScreenPos({x, top});
        if (ui::icon_button(theme, id, icon, side,
                            {fmt::format("There are keys {} these frames", where),
                             {},
                             "Click to show them as well."}))
            editor.timeline.shown = kept_frames(shown, scale.time);
    };
    if (scale.keys->x < scale.first)
        mark(ruler.lo.x + theme.px(2), "before", ui::icon::back, "before",
             {scale.keys->x, scale.last});
    if (scale.keys->y > scale.last)
        mark(ruler.hi.x - side.x - theme.px(2), "after", ui::icon::forward, "after",
             {scale.first, scale.keys->y});
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
