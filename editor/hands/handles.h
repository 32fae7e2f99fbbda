// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"
#include "editor/hands/tool.h"
#include "editor/hands/typed_amounts.h"
#include "ui/theme.h"

#include <array>
#include <functional>
#include <string_view>

namespace trivar {

// A HandleKey names a handle from one frame to the next.
struct HandleKey {
    std::string_view kind = {};      // a literal; empty: no handle
    std::array<int, 3> numbers = {}; // among those of its kind
    bool operator==(const HandleKey&) const = default;
};

// A HandMove says how far a hand has come with a handle.
struct HandMove {
    Camera camera; // through which it took the handle
    glm::dvec2 from_px{0}, to_px{0};
    double scale = 1;                 // of the interface
    bool snap = false;                // Ctrl is held: in round steps
    bool done = false;                // the hand lets go
    std::optional<double> typed = {}; // a number in place of the way, in the unit of the words
    glm::dvec2 by_px() const { return to_px - from_px; }
};

// A HandleDrag is what a handle does in the hand, with all as it was when it was taken.
struct HandleDrag {
    // The command for a hand that has come so far; nothing: it changes nothing.
    std::function<std::optional<Command>(const HandMove& move)> command = {};
    // Commits the last proposal; none: Session::commit().
    std::function<void(Session& session)> commit = {};
    // The handle was let go where it was taken; none: that does nothing.
    std::function<void(Session& session)> click = {};
};

// A Handle is a point of the picture that a hand can drag. A tool makes its handles anew in each
// frame, and their functions are called in that frame.
struct Handle {
    enum class Look { dot, bead, ring, hollow, arrow, diamond, cross };
    enum class Thread { none, lit, always };     // to its base; lit: only while the mouse has it
    enum class Number { none, length, percent }; // of metres in the world

    HandleKey key = {};
    glm::dvec3 p_world{0}; // what it is a handle of
    glm::dvec2 p_px{0};    // where it is drawn, in the picture
    glm::dvec2 base_px{0}; // what it is tied to
    glm::dvec2 way_px{0};  // arrow: where it points; cross: a bar along it while lit; 0: none
    Look look = Look::dot;
    Thread thread = Thread::none;
    ui::Color ui::Palette::*color = &ui::Palette::stroke;
    ui::Color ui::Palette::*lit = &ui::Palette::selected; // its colour while the mouse has it
    double reach_px = 9;                                  // of the mouse, at scale 1
    std::string words = {};                               // the number that it changes
    Number number = Number::none;                         // that can be typed in its place
    const char* verb = "";                                // "Drag to widen"
    const char* click_verb = nullptr;
    const char* ctrl_verb = "Round steps";
    std::function<HandleDrag()> take = {}; // without a command: it cannot be taken now
};

// Handles is the hand on the handles of a tool: the one under the mouse, a drag of one by the mouse
// or by a key, and a number that is typed meanwhile. What a drag makes is shown all the time, and
// is one step.
class Handles {
public:
    // Returns whether the mouse is on one of `all`, or drags one, so that it is nobody else's.
    bool use(Session& session, const ViewportInput& input, const std::vector<Handle>& all);
    // Takes a handle by a key: it goes with the mouse until a click or Enter.
    void take_by_key(Session& session, const ViewportInput& input, const Handle& handle);
    void take_keys(); // in a drag
    bool busy() const { return drag_.has_value(); }
    bool hovers() const { return !lit_.key.kind.empty(); }
    const HandleKey& key() const { return lit_.key; } // of the one in the hand or under the mouse
    const glm::dvec3& held_at() const { return lit_.p_world; }  // when it was taken, world
    const glm::dvec2& from_px() const { return move_.from_px; } // where it was taken
    void cancel(Session& session);
    // Paints them, the lit one above the others, and the number of that beside the mouse; not
    // beyond `end_x`, a pixel of the window at which something else begins.
    void paint(const ui::Theme& theme, const ViewportInput& input, std::vector<Handle> all,
               float end_x = 1e9f) const;
    std::vector<Hint> hints() const; // of the handle under the mouse, or of a drag

private:
    void take(Session& session, const ViewportInput& input, const Handle& handle, glm::dvec2 at_px);
    void go_on(Session& session, const ViewportInput& input);
    std::string with_typed(const std::string& said) const; // as far as a number is typed

    Handle lit_; // without its functions
    std::optional<HandleDrag> drag_;
    HandMove move_;
    bool moved_ = false, by_key_ = false, entered_ = false;
    TypedAmounts typed_;
};

} // namespace trivar
