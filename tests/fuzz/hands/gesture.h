// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace trivar::testing {

// A Gesture is one thing that a hand does in the window, without what the window then shows: where
// an object stands on the screen is found when the gesture is made.
struct Gesture {
    enum class Kind {
        stroke,  // a button goes down at the first point, along all of them, and up
        click,   // at the first point
        choose,  // a click, then one in the list or menu that it opens, at the second point of that
        wheel,   // turned at the first point by `number` notches
        chord,   // the key in `text`, struck `number` times
        type,    // the letters in `text`, then the key in `end`
        field,   // a click at the first point, then as `type`
        palette, // opened, `text` typed into it, then the key in `end`
        command, // `text` typed into the field of the log
        drop,    // the file in `text`, of the case's folder
        save,    // under the name in `text`
        resize,  // the window, to the first point in pixels
        focus,   // lost, and gained again
        card,    // the graphics card is reset
    } kind = Kind::stroke;
    std::string tool = {};               // key of a tool that is struck before; empty: none
    std::string area = "view";           // of the window; "object": round that of this number
    std::vector<glm::dvec2> points = {}; // as shares of the area; may lie outside of it
    std::string text = {}, end = {};
    int number = 1;
    int frames = 4;                     // from one point to the next
    std::string button = "left";        // or "middle", "right"
    bool twice = false;                 // a click, at once again
    bool keeps = false;                 // the button is not let go
    bool hasty = false;                 // nothing is waited for, neither within it nor after it
    bool blind = false;                 // a dialog or menu that is open is not closed before
    std::vector<std::string> held = {}; // "Ctrl", "Shift", "Alt"
    // An interruption when `at` of the way is done: the name of a key, "right", "focus", "turn",
    // "wheel", "resize", or "type" and letters; empty: none.
    std::string between = {};
    double at = 0.5;
    bool operator==(const Gesture&) const = default;
};

// One line of JSON, without what is as usual, without a line break.
std::string text_of(const Gesture& gesture);
Gesture gesture_from(const std::string& line); // throws Rejected

} // namespace trivar::testing
