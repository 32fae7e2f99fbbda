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

// What a person has arranged about buttons.
struct ClickManners {
    double double_click_s = 0.3; // between the presses of a double click
    bool hold =
        false; // a click begins what is else dragged with a button held; a second one ends it
};

// Events wait here until a frame takes them. A frame sees at most one press or release, so that a
// click shorter than a frame is still a click, and every move is kept for tools that draw. A button
// that is let go after moves waits a frame, so that a drag shorter than a frame is still a drag.
class Input {
public:
    void push(Event event) { waiting_.push_back(std::move(event)); }
    bool pending() const { return !waiting_.empty(); }

    // Takes the events of one frame and tells the current ImGui context. Two presses are a double
    // click by when they were made, however long the frames between them took.
    void begin_frame(double time_s, const ClickManners& manners = {});
    // What is being dragged asks in every frame that its button may be held on by a click.
    void may_hold_on() { drags_ = true; }
    // What is under the mouse asks in every frame for a key of its own, which is then its alone.
    void keep_key(int code) { keeps_.push_back(code); }
    bool keeps(int code) const;                                 // as of the last frame
    const std::vector<Event>& events() const { return taken_; } // of this frame, in order

private:
    void tell(const Event& event, double time_s, double double_click_s);
    // Whether ImGui hears of the event, which may become another one: with `holds` a click holds
    // what is dragged.
    bool hears(Event& event, double time_s, double double_click_s, bool holds);

    struct Hold {
        int button = -1;         // that is down for ImGui; -1: none
        bool on = false;         // by a click: in truth it is up
        bool strayed = false;    // the hand moved since it was pressed
        bool twice = false;      // pressed, or to be pressed, for the second time
        glm::vec2 at{0};         // where it was pressed
        double pressed_s = -1e9; // and when
    } hold_;
    std::vector<int> keeps_, kept_; // asked for in this frame and in the last one
    bool drags_ = false;            // something is being dragged, as of the last frame
    std::deque<Event> waiting_;
    std::vector<Event> taken_;
    std::array<double, 5> pressed_s_{-1e9, -1e9, -1e9, -1e9, -1e9}; // by button, the last time
};

Input& hands(); // of the current ImGui context, which a Gui made

// Gives ImGui's names of the keys our codes. Called once a context.
void map_keys();

} // namespace trivar::ui
