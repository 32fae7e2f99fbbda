// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <deque>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace trivar::ui {

enum class Button { left, right, middle };

// An Event is one action of a hand. Positions are pixels of the framebuffer, (0, 0) top left.
struct Event {
    enum class Kind { move, button, wheel, key, text, focus, drop } kind = Kind::move;
    glm::vec2 at{0};                // move: the position; wheel: steps right and up
    int code = 0;                   // button: a Button; key: its code (keys.h); text: a code point
    bool down = false;              // button, key: pressed or let go; focus: gained or lost
    std::vector<std::string> paths; // drop: the files
    double time_s = 0;              // when, on the clock of the frames; below 0: in this frame
    double doubt_s = 0; // the event may have happened that much earlier: nobody listened then
};

Event move_to(glm::vec2 p_px, double time_s = 0);
Event press(Button button, bool down = true, double time_s = -1);
Event press_key(int code, bool down = true);
Event type_text(unsigned code_point);
Event turn_wheel(float steps_up);
Event drop_files(std::vector<std::string> paths);

// ClickManners are a person's settings of buttons.
struct ClickManners {
    double double_click_s = 0.3; // between the presses of a double click
    bool hold =
        false; // a click begins what is else dragged with a button held; a second one ends it
};

// Input holds events until a frame takes them. A frame sees at most one press or release, so that a
// click shorter than a frame is still a click, and keeps every move for tools that draw. A press
// after moves waits for the next frame, so that it meets what is under the mouse where it was made,
// and so does a release after moves with a button down, so that a drag shorter than a frame is
// still a drag.
class Input {
public:
    void push(Event event) { waiting_.push_back(std::move(event)); }
    bool pending() const { return !waiting_.empty() && (held_ == Held::nothing || cancels()); }

    // Gives the events of one frame to the current ImGui context. Two presses are a double click by
    // the times at which they were made, however long the frames between them took.
    void begin_frame(double time_s, const ClickManners& manners = {});
    // Called in every frame in which the object of the next keys is not there yet: they wait, in
    // their order, and with `buttons` presses in the picture, too. Esc and the right button, which
    // cancel, end the wait.
    void hold_back(bool buttons) { held_ = buttons ? Held::keys_and_buttons : Held::keys; }
    // A thing that is dragged calls this in every frame; a click may then hold its button on.
    void may_hold_on() { drags_ = true; }
    // A thing under the mouse calls this in every frame to have a key for itself alone.
    void keep_key(int code) { keeps_.push_back(code); }
    bool keeps(int code) const;                                 // as of the last frame
    const std::vector<Event>& events() const { return taken_; } // of this frame, in order

private:
    void tell(const Event& event, double time_s, double double_click_s);
    // Whether ImGui gets the event, which may be changed into another one: with `holds`, a click
    // holds the dragged item.
    bool hears(Event& event, double time_s, double double_click_s, bool holds);
    bool cancels() const; // Esc or the right button is among what waits

    enum class Held { nothing, keys, keys_and_buttons } held_ = Held::nothing;
    struct Hold {
        int button = -1;         // the button that is down for ImGui; -1: none
        bool on = false;         // held on by a click: in truth the button is up
        bool strayed = false;    // the hand has moved since the press
        bool twice = false;      // the button was pressed, or will be pressed, for the second time
        glm::vec2 at{0};         // where it was pressed
        double pressed_s = -1e9; // and when
    } hold_;
    std::vector<int> keeps_, kept_; // keys asked for in this frame and in the last one
    bool drags_ = false;            // something is dragged, as of the last frame
    std::deque<Event> waiting_;
    std::vector<Event> taken_;
    std::array<double, 5> pressed_s_{-1e9, -1e9, -1e9, -1e9, -1e9}; // by button, the last time
};

Input& hands(); // of the current ImGui context, which a Gui made

// Tells ImGui which of its keys our codes are. Called once per context.
void map_keys();

} // namespace trivar::ui
