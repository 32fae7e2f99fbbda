// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/jobs/background_evaluator.h"
#include "editor/session/session.h"

namespace trivar {

// A RefinedView is the session's effects with triangles as fine as the camera wants them. They are
// split in the background while nothing moves; until then edited objects are seen as the document
// has them.
class RefinedView {
public:
    // Takes in finished results and asks for what is wanted now; once per frame. Tolerance 0:
    // nothing is split.
    void follow(Session& session, double tolerance_px, bool moving, double time_s);

    const Evaluation& seen() const { return seen_; }
    // The objects that have other triangles here than in the document, ascending.
    std::vector<Id> split(const Evaluation& evaluated) const;
    long number() const { return number_; } // counts up with each change of it
    bool up_to_date() const { return tolerance_px_ <= 0 || (current_ && done_s_ == asked_s_); }
    // "Within 1 px: 20,000 triangles", or what prevents it; empty: no tolerance.
    std::string words(double time_s) const;

private:
    struct WantedView { // what was asked for last
        const BackgroundEvaluator* of = nullptr;
        long evaluation = -1;
        Camera camera;
        double tolerance_px = 0;
        bool operator==(const WantedView&) const = default;
    };
    void merge(const Session& session);

    WantedView wanted_;
    bool current_ = false;            // that is what is wanted now
    double asked_s_ = 0, done_s_ = 0; // when the last was asked for, and the last that is there
    std::optional<BackgroundEvaluator::SeenResult> finished_;
    Evaluation seen_;
    long number_ = 0, evaluation_ = -1;
    double tolerance_px_ = 0;
};

} // namespace trivar
