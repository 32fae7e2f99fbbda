// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/notices.h"

#include "core/base/text.h"
#include "ui/icons.h"
#include "ui/sentence.h"
#include "ui/widgets.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>
#include <imgui_internal.h>

namespace trivar::ui {
namespace {

constexpr std::size_t most_shown = 3;

// Longer where there is something to press.
double lifetime_s(const Notices::Notice& notice)
{
    if (notice.stays) return 1e300;
    if (notice.kind == NoticeKind::error) return notice.actions.empty() ? 30 : 1e300;
    return notice.actions.empty() ? notice.kind == NoticeKind::good ? 4 : 10 : 20;
}

// Names that files and logs contribute may hold anything and be of any length.
std::string short_lines(const std::string& text)
{
    std::string out;
    for (const std::string_view line : trimmed_lines(text))
        out += (out.empty() ? "" : "\n") + short_sentence(line);
    return out;
}

// An undecorated window over everything else, of just this place.
void begin_card(const Theme& theme, const char* name, const Rect& rect)
{
    ImGui::SetNextWindowPos({rect.lo.x, rect.lo.y});
    ImGui::SetNextWindowSize({rect.width(), rect.height()});
    ImGui::SetNextWindowBgAlpha(0);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoNav);
    ImGui::PopStyleVar();
    paint_card(theme, rect);
}

// Cards stand on each other in the lower right corner, or hang from the upper right one.
enum class Stack { stands, hangs };

// No higher than that, but for a line of its body: the rest of this is in a tooltip.
// Returns the card's rectangle; `close` says whether its cross was pressed, `act` which button.
struct DrawnCard {
    Rect rect;
    bool close = false, hovered = false;
    std::function<void()> act = {};
};
DrawnCard draw_one(const Theme& theme, const Notices::Notice& notice, glm::vec2 corner, Stack stack,
                   float width, float most_height, const char* name)
{
    const Palette& c = theme.color;
    const Color color = notice.kind == NoticeKind::good      ? c.good
                        : notice.kind == NoticeKind::warning ? c.warn
                                                             : c.bad;
    const char* icon = notice.kind == NoticeKind::good ? icon::check : icon::warning;
    const float left = theme.px(44), line = theme.px(18), pad = theme.px(10);
    const float room = width - left - theme.px(40);
    const std::string counted =
        notice.count > 1 ? notice.title + "  (" + std::to_string(notice.count) + ")" : notice.title;
    const std::vector<std::string> title = wrapped(theme.font.strong, counted, room);
    std::vector<std::vector<std::string>> body; // each a little below the one before
    std::size_t lines = title.size();
    for (const std::string_view each : trimmed_lines(notice.body)) {
        body.push_back(wrapped(theme.font.body, each, room));
        lines += body.back().size();
    }
    const float buttons = notice.actions.empty() ? 0 : theme.px(36);
    const auto height_of_all = [&] {
        return 2 * pad + line * static_cast<float>(lines) +
               theme.px(4) * static_cast<float>(body.size()) + buttons;
    };
    bool cut = false;
    while (!body.empty() && height_of_all() > most_height && lines > title.size() + 1) {
        cut = true;
        body.back().pop_back();
        if (body.back().empty()) body.pop_back();
        --lines;
    }
    if (cut) body.back().back() += " …";
    const float height = height_of_all();
    const glm::vec2 size{width, height};
    const glm::vec2 lower_right = corner + glm::vec2(0, stack == Stack::hangs ? height : 0);
    DrawnCard drawn{.rect = {lower_right - size, lower_right}};
    begin_card(theme, name, drawn.rect);
    const Rect& r = drawn.rect;
    paint_box(
        {r.lo + glm::vec2(theme.px(1), theme.px(8)), {r.lo.x + theme.px(4), r.hi.y - theme.px(8)}},
        color, theme.px(2));
    float y = r.lo.y + pad;
    paint_text(theme.font.body, {{r.lo.x + theme.px(16), y}, {r.hi.x, y + line}}, color, icon);
    const auto write = [&](const ImFont* font, Color ink, const std::vector<std::string>& text) {
        for (const std::string& words : text) {
            paint_text(font, {{r.lo.x + left, y}, {r.hi.x, y + line}}, ink, words);
            y += line;
        }
    };
    write(theme.font.strong, c.text, title);
    const float body_begin = y;
    for (const std::vector<std::string>& each : body) {
        y += theme.px(4);
        write(theme.font.body, c.text_2, each);
    }
    if (cut)
        tooltip_in({{r.lo.x + left, body_begin}, {r.hi.x, y}}, {notice.title, {}, notice.body});
    float x = r.lo.x + left;
    for (const Notices::Action& each : notice.actions) {
        ImGui::SetCursorScreenPos({x, y + theme.px(8)});
        const float wide = button_width(theme, each.words);
        if (button(theme, each.words, ButtonKind::plain, {wide, theme.px(28)}))
            drawn.act = each.act;
        x += wide + theme.px(8);
    }
    ImGui::SetCursorScreenPos({r.hi.x - theme.px(32), r.lo.y + theme.px(7)});
    drawn.close =
        icon_button(theme, "close", icon::close, glm::vec2(theme.size.icon_button), {"Close"});
    drawn.hovered = ImGui::IsWindowHovered();
    ImGui::End();
    return drawn;
}

} // namespace

void Notices::say_all(NoticeKind kind, std::string title, const std::vector<std::string>& lines,
                      std::string topic, std::vector<Action> actions)
{
    std::string body;
    for (const std::string& line : lines) body += (body.empty() ? "" : "\n") + sentence(line);
    say(kind, std::move(title), std::move(body), std::move(topic), std::move(actions));
}

void Notices::forget(std::string_view topic)
{
    std::erase_if(notices_, [&](const Notice& notice) { return notice.topic == topic; });
}

void Notices::keep(std::string_view topic)
{
    for (Notice& notice : notices_)
        if (notice.topic == topic) {
            notice.stays = true;
            notice.left_s = lifetime_s(notice);
        }
}

void Notices::say(NoticeKind kind, std::string title, std::string body, std::string topic,
                  std::vector<Action> actions)
{
    title = short_sentence(capitalised(std::move(title)));
    body = short_lines(sentence(std::move(body)));
    for (Notice& notice : notices_)
        if (notice.kind == kind && notice.title == title && notice.body == body) {
            if (topic.empty()) ++notice.count; // else it is the same still
            notice.actions = std::move(actions);
            notice.left_s = lifetime_s(notice);
            return;
        }
    if (!topic.empty()) forget(topic);
    notices_.push_back(
        {kind, std::move(title), std::move(body), std::move(topic), 1, -1, std::move(actions)});
    if (notices_.size() <= most_shown) return;
    const auto oldest = std::ranges::find(notices_, false, &Notice::stays);
    notices_.erase(oldest == notices_.end() ? notices_.begin() : oldest);
}

float Notices::left_of(const Theme& theme, const Rect& in)
{
    const float room = in.width() - theme.px(32); // most of a narrow picture stays to be seen
    const float width = std::min(std::max(theme.px(264), 0.5f * room), theme.px(384));
    return in.hi.x - theme.px(16) - std::min(width, room);
}

void Notices::draw(Frame& frame, const Rect& in)
{
    const Theme& theme = frame.theme;
    const double passed = std::clamp(frame.time_s - last_s_, 0.0, 1.0);
    last_s_ = frame.time_s;
    const float width = in.hi.x - theme.px(16) - left_of(theme, in);
    // The buttons of a dialog are at its foot: nothing lies on them.
    const Stack stack = ImGui::GetTopMostPopupModal() ? Stack::hangs : Stack::stands;
    glm::vec2 corner = in.hi - theme.px(16);
    if (stack == Stack::hangs) corner = {frame.size_px.x - theme.px(16), theme.px(16)};
    std::function<void()> act;                        // may say the next thing
    for (std::size_t i = notices_.size(); i-- > 0;) { // the newest lowest
        Notice& notice = notices_[i];
        if (notice.left_s < 0) notice.left_s = lifetime_s(notice);
        const std::string name = "notice " + std::to_string(i);
        const DrawnCard drawn =
            draw_one(theme, notice, corner, stack, width, 0.4f * in.height(), name.c_str());
        corner.y =
            stack == Stack::hangs ? drawn.rect.hi.y + theme.px(8) : drawn.rect.lo.y - theme.px(8);
        if (!drawn.hovered) notice.left_s -= passed;
        if (drawn.close || drawn.act) notice.left_s = 0;
        if (drawn.act) act = drawn.act;
        if (notice.left_s < 1e9) frame.again_in(std::clamp(notice.left_s, 0.0, 1.0));
    }
    std::erase_if(notices_, [](const Notice& notice) { return notice.left_s <= 0; });
    if (act) act();
}

Rect progress_place(const Theme& theme, const Rect& in)
{
    const glm::vec2 size{std::min(theme.px(440), in.width() - theme.px(32)), theme.px(76)};
    return rect_at({std::round(in.center().x - size.x / 2), in.hi.y - size.y - theme.px(16)}, size);
}

ProgressCard draw_progress(const Theme& theme, const Rect& in, const std::string& what,
                           const std::string& stage, double fraction)
{
    const Rect r = progress_place(theme, in);
    begin_card(theme, ("progress of " + what).c_str(), r);
    const Rect inside = r.grown(-theme.px(16));
    const Rect line{inside.lo, {inside.hi.x, inside.lo.y + theme.px(20)}};
    const float button = theme.px(80);
    const float room = inside.width() - button - theme.px(16);
    paint_text(theme.font.strong, line, theme.color.text, elided(theme.font.strong, what, room));
    const std::string done =
        fraction >= 0 ? std::to_string(static_cast<int>(fraction * 100)) + " %  " + stage : stage;
    const Rect below{{inside.lo.x, line.hi.y + theme.px(2)},
                     {inside.hi.x, line.hi.y + theme.px(18)}};
    paint_text(theme.font.small, below, theme.color.text_2, elided(theme.font.small, done, room));
    Rect bar{{inside.lo.x, inside.hi.y - theme.px(4)}, {inside.lo.x + room, inside.hi.y}};
    bar.lo.y += theme.px(4);
    bar.hi.y += theme.px(4);
    paint_box(bar, theme.color.field, theme.px(2));
    bar.hi.x = bar.lo.x + bar.width() * static_cast<float>(std::clamp(fraction, 0.0, 1.0));
    paint_box(bar, theme.color.accent, theme.px(2));
    ImGui::SetCursorScreenPos({inside.hi.x - button, inside.lo.y + theme.px(6)});
    const bool cancel = ui::button(theme, "Cancel", ButtonKind::plain, {button, theme.px(32)});
    ImGui::End();
    return {r, cancel};
}

} // namespace trivar::ui
