// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/frame.h"
#include "ui/paint.h"

#include <optional>
#include <string>

namespace trivar::ui {

// A Tip is the text on the item under the mouse: its name with its key, and a sentence below.
struct Tip {
    std::string name, key = {}, sentence = {};
};

enum class Side { below, right, left }; // side of the thing, where there is room

// Shows the tip for the last item, once the mouse rests on it. In a panel at the right edge of the
// window it stands left of the panel, so that it covers none of the rows below.
void tooltip(Tip tip, Side side = Side::below);
// Shows the tip for a part of the current window; items inside of it may show their own.
void tooltip_in(const Rect& part, Tip tip);

// The place for a tip of that size beside a thing: inside the window, and neither on the thing nor
// under the mouse.
glm::vec2 tooltip_place(const Rect& thing, glm::vec2 mouse, glm::vec2 size, glm::vec2 window,
                        Side side, float scale);

// Tooltips shows one tip per window: that of the last drawn thing among those under the mouse.
class Tooltips {
public:
    struct Offer {
        unsigned id = 0;
        Rect thing;
        Tip tip;
        Side side = Side::below;
    };
    void offer(Offer offer);
    // Greys out all offers from here on and says why they do not apply now; empty: they do.
    void grey(std::string why_not) { why_not_ = std::move(why_not); }
    void draw(const Theme& theme, Frame& frame); // once, when all things are drawn
    const std::optional<Tip>& shown() const { return shown_; }

private:
    std::optional<Offer> offer_;
    std::string why_not_;
    std::optional<Tip> shown_;
    unsigned at_ = 0; // the thing, and since when
    double since_s_ = 0, last_shown_s_ = -1e9;
    bool quick_ = false, gone_ = false;
};
Tooltips& tooltips(); // of the current ImGui context, which a Gui made

} // namespace trivar::ui
