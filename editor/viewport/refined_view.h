// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/session/session.h"

namespace trivar {

// The session's effects with triangles as fine as the camera wants them. They are split in the
// background while nothing moves; what was edited since is seen as the document has it till then.
class RefinedView {
public:
    // Takes in what was finished and asks for what is wanted now; once a frame. Tolerance 0: none.
    void follow(Session& session, double tolerance_px, bool moving, double time_s);

    const Evaluation& seen() const { return seen_; }
    // What has other triangles there than in the document, ascending.
    std::vector<Id> split(const Evaluation& evaluated) const;
    long number() const { return number_; } // counts up with each change of it
    bool up_to_date() const { return tolerance_px_ <= 0 || (current_ && done_s_ == asked_s_); }
    // "Within 1 px: 20,000 triangles", or what stands in the way; empty: no tolerance.
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
