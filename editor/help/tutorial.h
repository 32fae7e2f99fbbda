// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/session/session.h"

#include <optional>
#include <string>
#include <vector>

namespace trivar {

// A Tutorial is a scene whose lines carry notes, shown step by step in the viewport. What a hand
// did is done again before the person's eyes: the camera goes where it was, the stroke grows, the
// object moves. The steps are those of the session's history, so a person who does something else
// in between has a scene like any other.
class Tutorial {
public:
    // The session's scene is a copy of the tutorial, as it was opened; shows its first step.
    void begin(Session& session, std::string title);
    void close(Session& session);
    bool runs(const Session& session) const; // and its scene is still there

    const std::string& title() const { return title_; }
    std::size_t count() const { return count_; }
    std::size_t step(const Session& session) const;        // from 1; the one that is being shown
    const std::string& note(const Session& session) const; // of it; empty: somebody's own step

    // Finishes the present step at once and shows the next one.
    void next(Session& session, bool at_once = false);
    void back(Session& session);

    // Advances the step, once per frame; returns whether there is more to come. `at_once` is for
    // pictures that come too slowly to show a motion.
    bool advance(Session& session, double time_s, bool at_once);
    // The stroke that is growing, in the picture of the session's camera, in pixels.
    std::vector<glm::dvec2> stroke(const Session& session) const;

private:
    struct Motion {
        std::size_t to = 0; // the step that it leads to
        std::optional<double> began_s;
        Camera from, set; // at its beginning; as it was set last
        std::optional<Camera> goal;
        double done = 0; // of the gesture, 0..1
    };
    void show(Session& session, std::size_t step);
    void finish(Session& session);

    std::string title_;
    long scene_ = -1; // number of the session's scene
    std::size_t count_ = 0;
    std::optional<Motion> motion_;
};

// The part of a command that a hand had done when `done` of it was over, 0..1; empty for a command
// that is done at once. `before` is the document before the command.
std::optional<Command> part_of(const Command& command, const Document& before, double done);

// The tutorials of a folder; the ones with which every artist should begin come first.
std::vector<std::string> tutorials_in(const std::string& folder);

} // namespace trivar
