// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/object.h"
#include "ui/paint.h"

#include <functional>
#include <vector>

namespace trivar {

// A hand that clicks moves the mouse as far as this.
inline constexpr double click_slip_px = 3;

// A notch of the wheel makes a ball or a brush so much larger.
inline constexpr double radius_step = 1.1;

// A ViewportInput is what a tool sees of the viewport in one frame.
struct ViewportInput {
    ui::Rect rect;         // of the picture in the window
    double scale = 1;      // of the interface
    glm::dvec2 mouse{0};   // in the picture, pixels
    bool hovered = false;  // the mouse is over the picture and nothing lies above it
    bool pressed = false;  // the left button went down over the picture in this frame
    bool down = false;     // it went down over the picture and still is
    bool released = false; // it was let go in this frame
    bool double_clicked = false;
    double wheel = 0; // notches since the last frame, away from the hand, for a tool that takes it
    std::vector<StrokeSample> moves; // since the last frame, while down
    Id under = 0;                    // the object under the mouse, where `pressed`
    // Returns the object at a place, pixels of the picture, locked or not; 0: none.
    std::function<Id(glm::dvec2)> seen_at;
    // Returns the objects in a rectangle of the picture, pixels, that are not locked.
    std::function<std::vector<Id>(glm::dvec2 lo, glm::dvec2 hi)> seen_in;
};

} // namespace trivar
