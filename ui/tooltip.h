// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/frame.h"
#include "ui/paint.h"

#include <optional>
#include <string>

namespace trivar::ui {

// What is said of the thing under the mouse: its name with its key, and a sentence under them.
struct Tip {
    std::string name, key = {}, sentence = {};
};

enum class Side { below, right }; // of the thing, where there is room

// Over the last item, once the mouse rests there.
void tooltip(Tip tip, Side side = Side::below);
// Over a part of the current window, whatever is in it; what is in it may say more.
void tooltip_in(const Rect& part, Tip tip);

// Where words of a size stand beside a thing: inside the window, and neither on the thing nor
// under the mouse.
glm::vec2 tooltip_place(const Rect& thing, glm::vec2 mouse, glm::vec2 size, glm::vec2 window,
                        Side side, float scale);

// One for all the things of a window: of those that the mouse is over, the last that was drawn.
class Tooltips {
public:
    struct Offer {
        unsigned id = 0;
        Rect thing;
        Tip tip;
        Side side = Side::below;
    };
    void offer(Offer offer) { offer_ = std::move(offer); }
    void draw(const Theme& theme, Frame& frame); // once, when all things are drawn
    const std::optional<Tip>& shown() const { return shown_; }

private:
    std::optional<Offer> offer_;
    std::optional<Tip> shown_;
    unsigned at_ = 0; // the thing, and since when
    double since_s_ = 0, last_shown_s_ = -1e9;
    bool quick_ = false, gone_ = false;
};
Tooltips& tooltips(); // of the current ImGui context, which a Gui made

} // namespace trivar::ui
