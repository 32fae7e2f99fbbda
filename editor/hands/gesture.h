// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/commands/command.h"

#include <functional>
#include <optional>
#include <utility>

namespace trivar {

class Session;
struct ViewportInput;

// A Gesture is the course of what a hand does, from the press of a button or a key to its end. Its
// result is shown as a proposal all the time, one at a time: the next waits until the last one can
// be seen. At its end the result becomes one step, or there is no trace.
//
//   begin ---> go_on ... go_on ---> done      what the hand asks for is a step
//                    \        \---> dropped   it asks for nothing, or was refused
//                     \-- cancel ---> no trace
class Gesture {
public:
    enum class State { goes_on, done, dropped };
    // The command that the hand asks for by now; nothing: what was committed stays as it is.
    using Wanted = std::function<std::optional<Command>()>;
    // Makes the last proposal a step; by itself that is Session::commit().
    using Commit = std::function<void()>;

    // Begins a gesture; one that a key began goes on until a click, others until the button is let
    // go.
    void begin(const ViewportInput& input, bool by_key = false);
    bool going() const { return going_; }
    explicit operator bool() const { return going_; }
    bool by_key() const { return by_key_; }
    bool moved() const { return moved_; } // further than a hand that clicks
    glm::dvec2 from_px() const { return from_px_; }

    // Notes where the hand is, once a frame or more often; whether it ends the gesture there.
    bool follow(const ViewportInput& input);
    // Follows the hand, and shows what is wanted or finishes. `dropped` where it does not go on.
    State go_on(Session& session, const ViewportInput& input, const Wanted& wanted,
                const Commit& commit = {});
    State finish(Session& session, const Wanted& wanted, const Commit& commit = {});
    // Takes the keys of a frame: whether Enter ends it, or, where a key began it, a click outside
    // of the viewport, which ends it before the panel there sees the click.
    bool take_keys() const;
    void cancel(Session& session);
    // Shows what is wanted, once the last proposal can be seen. go_on() does so too.
    void show(Session& session, const Wanted& wanted);

private:
    bool going_ = false, by_key_ = false, moved_ = false, shown_ = false, outside_ = false;
    glm::dvec2 from_px_{0};
};

// A GestureWith has something in the hand: from its beginning to that of the next one.
template <class Held> class GestureWith : public Gesture {
public:
    void begin(Held held, const ViewportInput& input, bool by_key = false)
    {
        held_.emplace(std::move(held));
        Gesture::begin(input, by_key);
    }
    Held& operator*() { return *held_; }
    const Held& operator*() const { return *held_; }
    Held* operator->() { return &*held_; }
    const Held* operator->() const { return &*held_; }

private:
    std::optional<Held> held_;
};

} // namespace trivar
