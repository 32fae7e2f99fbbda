// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/frame.h"
#include "ui/paint.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace trivar::ui {

enum class NoticeKind { good, warning, error };

// Notices are sentences for the user that appear at the lower right and leave again: success after
// 4 s, warnings after 10 s, errors after 30 s; errors with a remedy and kept ones when they are
// closed. A repeated sentence is counted; a sentence on a topic replaces the earlier one on that
// topic.
class Notices {
public:
    // An Action is a remedy on a button; the notice leaves when the button is pressed.
    struct Action {
        std::string words;
        std::function<void()> act;
    };
    void say(NoticeKind kind, std::string title, std::string body = {}, std::string topic = {},
             std::vector<Action> actions = {});
    // Says several things in one notice: a title, and one line per thing. A single line that is
    // complete needs no title.
    void say_all(NoticeKind kind, std::string title, const std::vector<std::string>& lines,
                 std::string topic = {}, std::vector<Action> actions = {});
    void forget(std::string_view topic); // what was said on the topic is no longer true
    void keep(std::string_view topic);   // it stays until it is closed or answered
    // Draws at most three notices over the lower right of the rectangle; while a dialog is open, at
    // the upper right of the window, away from its buttons.
    void draw(Frame& frame, const Rect& in);

    struct Notice {
        NoticeKind kind = NoticeKind::good;
        std::string title, body; // the body's lines end with \n
        std::string topic = {};
        int count = 1;
        double left_s = 0; // before it leaves; negative: not yet shown
        std::vector<Action> actions = {};
        bool stays = false; // until it is closed
    };
    const std::vector<Notice>& all() const { return notices_; }
    void clear() { notices_.clear(); }
    // The left edge of the notices: what lies left of it is free.
    static float left_of(const Theme& theme, const Rect& in);

private:
    std::vector<Notice> notices_;
    double last_s_ = 0;
};

// A ProgressCard is a card at the lower middle of the rectangle that says how far long work is.
// `fraction` below 0: unknown.
struct ProgressCard {
    Rect rect;
    bool cancelled = false;
};
Rect progress_place(const Theme& theme, const Rect& in); // the place where it will lie
ProgressCard draw_progress(const Theme& theme, const Rect& in, const std::string& what,
                           const std::string& stage, double fraction);

} // namespace trivar::ui
