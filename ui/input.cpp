// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/input.h"

#include "ui/keys.h"

#include <algorithm>
#include <imgui.h>
#include <utility>

namespace trivar::ui {
namespace {

// Limits that make ImGui take a press for a second one: always, if it is in the same place, or
// never.
constexpr float always_s = 1e9f, never_s = -1;
// A mouse so far to the left has left the window.
constexpr float outside_px = 1e5f;

bool is_modifier(const Event& event)
{
    return event.kind == Event::Kind::key && event.code >= key_left_shift &&
           event.code <= key_right_super;
}

// The key of a letter that goes into a text field: what counts is the text event beside it, and
// several letters may come in one frame.
bool is_typing(const Event& event)
{
    const ImGuiIO& io = ImGui::GetIO();
    return io.WantTextInput && !io.KeyCtrl && !io.KeyAlt && event.code < key_escape;
}

} // namespace

Event move_to(glm::vec2 p_px, double time_s)
{
    return {.kind = Event::Kind::move, .at = p_px, .paths = {}, .time_s = time_s};
}

Event press(Button button, bool down, double time_s)
{
    return {.kind = Event::Kind::button,
            .code = static_cast<int>(button),
            .down = down,
            .paths = {},
            .time_s = time_s};
}

Event press_key(int code, bool down)
{
    return {.kind = Event::Kind::key, .code = code, .down = down, .paths = {}};
}

Event type_text(unsigned code_point)
{
    return {.kind = Event::Kind::text, .code = static_cast<int>(code_point), .paths = {}};
}

Event turn_wheel(float steps_up)
{
    return {.kind = Event::Kind::wheel, .at = {0, steps_up}, .paths = {}};
}

Event drop_files(std::vector<std::string> paths)
{
    return {.kind = Event::Kind::drop, .paths = std::move(paths)};
}

bool Input::hears(Event& event, double time_s, double double_click_s, bool holds)
{
    switch (event.kind) {
    case Event::Kind::focus:
        if (!event.down) hold_ = {};
        return true;
    case Event::Kind::move:
        // A hand that holds nothing down in truth may leave the window.
        if (hold_.on && event.at.x < -outside_px) return false;
        if (glm::distance(event.at, hold_.at) > ImGui::GetIO().MouseDragThreshold)
            hold_.strayed = true;
        return true;
    case Event::Kind::button: break;
    default: return true;
    }
    if (!event.down) {
        if (event.code != hold_.button) return true;
        hold_.on = hold_.on || (holds && !hold_.strayed && !hold_.twice);
        if (!hold_.on) hold_ = {};
        return !hold_.on;
    }
    const double at_s = event.time_s < 0 ? time_s : event.time_s;
    if (hold_.on && event.code != static_cast<int>(Button::right)) { // which may cancel
        const bool twice = event.code == hold_.button && !hold_.strayed &&
                           at_s - event.doubt_s - hold_.pressed_s < double_click_s;
        if (twice) waiting_.push_front(event); // once what it follows was a click
        event = press(static_cast<Button>(hold_.button), false, event.time_s);
        hold_ = {.twice = twice};
        return true;
    }
    const ImVec2 p = ImGui::GetIO().MousePos;
    if (!hold_.on)
        hold_ = {.button = event.code, .twice = hold_.twice, .at = {p.x, p.y}, .pressed_s = at_s};
    return true;
}

bool Input::keeps(int code) const
{
    return std::ranges::find(kept_, code) != kept_.end();
}

bool Input::cancels() const
{
    return std::ranges::any_of(waiting_, [](const Event& event) {
        return event.down && ((event.kind == Event::Kind::key && event.code == key_escape) ||
                              (event.kind == Event::Kind::button &&
                               event.code == static_cast<int>(Button::right)));
    });
}

void Input::begin_frame(double time_s, const ClickManners& manners)
{
    const Held held = cancels() ? Held::nothing : held_;
    held_ = Held::nothing;
    ImGui::GetIO().MouseDoubleClickTime = never_s;
    taken_.clear();
    kept_ = std::exchange(keeps_, {});
    const bool dragged = std::exchange(drags_, false);
    if (hold_.on && !dragged) { // it was cancelled
        ImGui::GetIO().MouseDown[hold_.button] = false;
        hold_ = {};
    }
    bool strayed = false; // the mouse is elsewhere than in the last frame
    bool moved = false;   // with a button down
    bool pressed = false; // a press or release was taken: what follows it must wait a frame
    while (!waiting_.empty()) {
        const Event& next = waiting_.front();
        const bool button = next.kind == Event::Kind::button;
        const bool press = button || (next.kind == Event::Kind::key && !is_typing(next));
        if (pressed && (press || next.kind == Event::Kind::move)) break;
        // The view is turned meanwhile, and modifiers alone begin nothing.
        const bool looks = is_modifier(next) || (button && next.code == int(Button::middle));
        const bool begins = next.down ? press && !looks : next.kind == Event::Kind::text;
        if (begins && (button ? held == Held::keys_and_buttons : held != Held::nothing)) break;
        if (button && next.down && strayed) break; // what is there must be known first
        const bool let_go = button && (!next.down || hold_.on);
        if (moved && let_go) break; // what is dragged is seen where it is let go
        // Modifiers going down belong to the press that follows them.
        if (press && !(is_modifier(next) && next.down)) pressed = true;
        Event event = std::move(waiting_.front());
        waiting_.pop_front();
        if (!hears(event, time_s, manners.double_click_s, manners.hold && dragged)) continue;
        const ImVec2 at = ImGui::GetIO().MousePos;
        strayed |= event.kind == Event::Kind::move && event.at != glm::vec2(at.x, at.y);
        moved |= strayed && ImGui::IsAnyMouseDown();
        tell(event, time_s, manners.double_click_s);
        taken_.push_back(std::move(event));
    }
}

void Input::tell(const Event& event, double time_s, double double_click_s)
{
    ImGuiIO& io = ImGui::GetIO();
    switch (event.kind) {
    case Event::Kind::move: io.MousePos = {event.at.x, event.at.y}; break;
    case Event::Kind::button:
        if (event.code < 0 || event.code >= 5) break;
        io.MouseDown[event.code] = event.down;
        if (event.down) {
            double& before_s = pressed_s_[static_cast<std::size_t>(event.code)];
            const double at_s = event.time_s < 0 ? time_s : event.time_s;
            // ImGui counts by its frames, of which a slow machine has few.
            if (at_s - event.doubt_s - before_s < double_click_s)
                io.MouseDoubleClickTime = always_s;
            before_s = at_s;
        }
        break;
    case Event::Kind::wheel:
        io.MouseWheelH += event.at.x;
        io.MouseWheel += event.at.y;
        break;
    case Event::Kind::key:
        if (event.code >= 0 && event.code < key_count) io.KeysDown[event.code] = event.down;
        io.KeyShift = io.KeysDown[key_left_shift] || io.KeysDown[key_left_shift + 4];
        io.KeyCtrl = io.KeysDown[key_left_control] || io.KeysDown[key_left_control + 4];
        io.KeyAlt = io.KeysDown[key_left_alt] || io.KeysDown[key_left_alt + 4];
        io.KeySuper = io.KeysDown[key_left_super] || io.KeysDown[key_right_super];
        break;
    case Event::Kind::text: io.AddInputCharacter(static_cast<unsigned>(event.code)); break;
    case Event::Kind::focus:
        io.AddFocusEvent(event.down);
        if (event.down) break;
        // Whatever was held is let go elsewhere, where we do not hear it.
        for (bool& held : io.MouseDown) held = false;
        for (bool& held : io.KeysDown) held = false;
        io.KeyShift = io.KeyCtrl = io.KeyAlt = io.KeySuper = false;
        break;
    case Event::Kind::drop: break;
    }
}

void map_keys()
{
    ImGuiIO& io = ImGui::GetIO();
    const auto map = [&io](ImGuiKey name, int code) { io.KeyMap[name] = code; };
    map(ImGuiKey_Tab, key_tab);
    map(ImGuiKey_LeftArrow, key_left);
    map(ImGuiKey_RightArrow, key_right);
    map(ImGuiKey_UpArrow, key_up);
    map(ImGuiKey_DownArrow, key_down);
    map(ImGuiKey_PageUp, key_page_up);
    map(ImGuiKey_PageDown, key_page_down);
    map(ImGuiKey_Home, key_home);
    map(ImGuiKey_End, key_end);
    map(ImGuiKey_Insert, key_insert);
    map(ImGuiKey_Delete, key_delete);
    map(ImGuiKey_Backspace, key_backspace);
    map(ImGuiKey_Space, key_space);
    map(ImGuiKey_Enter, key_enter);
    map(ImGuiKey_Escape, key_escape);
    map(ImGuiKey_KeyPadEnter, key_keypad_enter);
    map(ImGuiKey_A, 'A');
    map(ImGuiKey_C, 'C');
    map(ImGuiKey_V, 'V');
    map(ImGuiKey_X, 'X');
    map(ImGuiKey_Y, 'Y');
    map(ImGuiKey_Z, 'Z');
}

} // namespace trivar::ui
