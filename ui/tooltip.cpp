// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tooltip.h"

#include "ui/sentence.h"

#include <imgui.h>
#include <imgui_internal.h>

namespace trivar::ui {
namespace {

constexpr double patience_after_another_s = 0.15, just_s = 0.5;

// Whether there is a press, a turn of the wheel or a key: the person needs no tooltip then.
bool hand_acts()
{
    const ImGuiIO& io = ImGui::GetIO();
    return ImGui::IsAnyMouseDown() || io.MouseWheel != 0 || io.MouseWheelH != 0 ||
           std::any_of(std::begin(io.KeysDown), std::end(io.KeysDown), [](bool d) { return d; });
}

bool may_offer()
{
    return !ImGui::IsAnyMouseDown() && !ImGui::IsAnyItemActive();
}

glm::vec2 mouse()
{
    return {ImGui::GetIO().MousePos.x, ImGui::GetIO().MousePos.y};
}

// Words are its lines with their sizes.
struct Words {
    std::vector<std::string> name, sentence;
    glm::vec2 size{0};
};
constexpr float widest = 260, line_height = 18, pad_x = 10, pad_y = 8, before_key = 16;
Words words_of(const Theme& theme, const Tip& tip)
{
    const Fonts& font = theme.font;
    const float key = tip.key.empty() ? 0 : text_width(font.body, tip.key) + theme.px(before_key);
    Words words{wrapped(font.strong, tip.name, theme.px(widest) - key),
                wrapped(font.body, sentence(tip.sentence), theme.px(widest))};
    float width = 0;
    for (std::size_t i = 0; i < words.name.size(); ++i)
        width = std::max(width, text_width(font.strong, words.name[i]) + (i == 0 ? key : 0));
    for (const std::string& line : words.sentence)
        width = std::max(width, text_width(font.body, line));
    const auto lines = static_cast<float>(words.name.size() + words.sentence.size());
    words.size = {width + 2 * theme.px(pad_x), lines * theme.px(line_height) + 2 * theme.px(pad_y)};
    return words;
}

void paint(const Theme& theme, const Tooltips::Offer& offer, glm::vec2 window_px)
{
    const Words words = words_of(theme, offer.tip);
    const glm::vec2 at =
        tooltip_place(offer.thing, mouse(), words.size, window_px, offer.side, theme.scale);
    ImGui::SetNextWindowPos({at.x, at.y});
    ImGui::SetNextWindowSize({words.size.x, words.size.y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::Begin("tooltip", nullptr,
                 ImGuiWindowFlags_Tooltip | ImGuiWindowFlags_NoInputs |
                     ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings);
    ImGui::PopStyleVar(2);
    const float line = theme.px(line_height), right = at.x + words.size.x - theme.px(pad_x);
    Rect row = {{at.x + theme.px(pad_x), at.y + theme.px(pad_y)},
                {right, at.y + theme.px(pad_y) + line}};
    const auto next = [&] { row = {row.lo + glm::vec2(0, line), row.hi + glm::vec2(0, line)}; };
    paint_text(theme.font.body, row, theme.color.text_2, offer.tip.key, Align::right);
    for (const std::string& each : words.name) {
        paint_text(theme.font.strong, row, theme.color.text, each);
        next();
    }
    for (const std::string& each : words.sentence) {
        paint_text(theme.font.body, row, theme.color.text_2, each);
        next();
    }
    ImGui::End();
}

// A thing in a panel of rows at the right edge takes the whole width of the panel.
Tooltips::Offer offer_of(unsigned id, Rect thing, Tip tip, Side side)
{
    const ImGuiWindow* panel = ImGui::GetCurrentWindow()->RootWindow;
    const float window = ImGui::GetIO().DisplaySize.x, left = panel->Pos.x,
                right = panel->Pos.x + panel->Size.x;
    const bool beside = side == Side::below && right >= window - 1 && left >= 0.4f * window &&
                        panel->Size.y > 2 * thing.height();
    if (!beside) return {id, thing, std::move(tip), side};
    return {id, {{left, thing.lo.y}, {right, thing.hi.y}}, std::move(tip), Side::left};
}

} // namespace

void tooltip(Tip tip, Side side)
{
    if (!may_offer() || !ImGui::IsItemHovered()) return;
    const ImVec2 lo = ImGui::GetItemRectMin(), hi = ImGui::GetItemRectMax();
    const ImGuiID item = ImGui::GetItemID();
    const ImGuiID id = item ? item : ImGui::GetID(tip.name.c_str());
    tooltips().offer(offer_of(id, {{lo.x, lo.y}, {hi.x, hi.y}}, std::move(tip), side));
}

void tooltip_in(const Rect& part, Tip tip)
{
    if (!may_offer() || !ImGui::IsWindowHovered()) return;
    if (!ImGui::IsMouseHoveringRect({part.lo.x, part.lo.y}, {part.hi.x, part.hi.y})) return;
    const ImGuiID id = ImGui::GetID(tip.name.c_str());
    tooltips().offer(offer_of(id, part, std::move(tip), Side::below));
}

glm::vec2 tooltip_place(const Rect& thing, glm::vec2 mouse, glm::vec2 size, glm::vec2 window,
                        Side side, float scale)
{
    const float gap = std::round(4 * scale), arrow = std::round(18 * scale); // the mouse's own
    const glm::vec2 last = glm::max(window - size - gap, glm::vec2(0));
    const auto inside = [&](glm::vec2 at) {
        return glm::round(glm::clamp(at, glm::min(glm::vec2(gap), last), last));
    };
    const float right = thing.hi.x + 2 * gap, left = thing.lo.x - 2 * gap - size.x;
    if (side == Side::right && right <= last.x) return inside({right, thing.lo.y});
    if (side == Side::left && left >= 0) return inside({left, thing.lo.y});
    const float x = thing.width() > size.x ? mouse.x : thing.lo.x;
    const float below = std::max(thing.hi.y + gap, mouse.y + arrow);
    const float above = thing.lo.y - gap - size.y;
    if (below <= last.y) return inside({x, below});
    if (above >= 0) return inside({x, above});
    return inside({right <= last.x ? right : left, thing.lo.y});
}

void Tooltips::offer(Offer offer)
{
    offer_ = std::move(offer);
    std::string& words = offer_->tip.sentence;
    if (!why_not_.empty()) words = why_not_ + (words.empty() ? "" : " " + sentence(words));
}

void Tooltips::draw(const Theme& theme, Frame& frame)
{
    const double now_s = ImGui::GetTime();
    const unsigned id = offer_ ? offer_->id : 0;
    const bool held = !may_offer(); // by a hand that is at work on the thing
    if (id != at_ && !held) {
        at_ = id;
        since_s_ = now_s;
        quick_ = now_s - last_shown_s_ < just_s;
        gone_ = false;
    }
    gone_ = gone_ || held || hand_acts();
    shown_.reset();
    if (offer_ && !gone_) {
        const double usual_s = theme.look.tooltip_s;
        const double patience_s = quick_ ? std::min(usual_s, patience_after_another_s) : usual_s;
        const double wait_s = patience_s - (now_s - since_s_);
        if (wait_s > 0) {
            frame.again_in(wait_s + 0.01);
        } else {
            paint(theme, *offer_, frame.size_px);
            last_shown_s_ = now_s;
            shown_ = std::move(offer_->tip);
        }
    }
    offer_.reset();
    why_not_.clear(); // also where what was greyed ended by an exception
}

} // namespace trivar::ui
