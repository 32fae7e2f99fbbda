// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <deque>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace trivar::ui {

enum class Button { left, right, middle };

// What hands do, one thing at a time. Positions are pixels of the framebuffer, (0, 0) top left.
struct Event {
    enum class Kind { move, button, wheel, key, text, focus, drop } kind = Kind::move;
    glm::vec2 at{0};                // move: where to; wheel: steps right and up
    int code = 0;                   // button: a Button; key: its code (keys.h); text: a code point
    bool down = false;              // button, key: pressed or let go; focus: gained or lost
    std::vector<std::string> paths; // drop: the files
    double time_s = 0;              // when, on the clock of the frames; below 0: in this frame
    double doubt_s = 0;             // it may have been that much earlier: nobody listened then
};

Event move_to(glm::vec2 p_px, double time_s = 0);
Event press(Button button, bool down = true, double time_s = -1);
Event press_key(int code, bool down = true);
Event type_text(unsigned code_point);
Event turn_wheel(float steps_up);
Event drop_files(std::vector<std::string> paths);

// Events wait here until a frame takes them. A frame sees at most one press or release, so that a
// click shorter than a frame is still a click, and every move is kept for tools that draw.
class Input {
public:
    void push(Event event) { waiting_.push_back(std::move(event)); }
    bool pending() const { return !waiting_.empty(); }

    // Takes the events of one frame and tells the current ImGui context. Two presses are a double
    // click by when they were made, however long the frames between them took.
    void begin_frame(double time_s, double double_click_s = 0.3);
    const std::vector<Event>& events() const { return taken_; } // of this frame, in order

private:
    void tell(const Event& event, double time_s, double double_click_s);

    std::deque<Event> waiting_;
    std::vector<Event> taken_;
    std::array<double, 5> pressed_s_{-1e9, -1e9, -1e9, -1e9, -1e9}; // by button, the last time
};

// Gives ImGui's names of the keys our codes. Called once a context.
void map_keys();

} // namespace trivar::ui
