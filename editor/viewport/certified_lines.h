// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/jobs/worker.h"
#include "editor/picture/volume_lines.h"

#include <optional>
#include <string>
#include <vector>

namespace trivar {

// A CertifiedLines draws the lines of volume data with their proof while the view rests, on a
// thread of its own. Until they are there, and while anything moves, quick lines are seen.
class CertifiedLines {
public:
    // Seen is the state that the window shows.
    struct Seen {
        const Evaluation& evaluated;
        const Document& document;
        const Camera& camera;
        const std::vector<Id>& hidden_here; // ascending
    };
    // Takes in finished results, drops those that nobody sees any more, and begins new ones once
    // the view has rested a moment; once per frame. `into` draws the lines.
    void follow(const Seen& seen, bool moving, double time_s, VolumeLines& into);

    long number() const { return number_; } // counts up with each change of the lines
    bool busy() const { return work_.busy(); }
    bool up_to_date() const { return wanted_.empty() || (asked_ && !busy()); }
    std::optional<double> again_in_s() const; // when it wants to be asked again
    // "Lines certified to 1/8 voxel, 12 boxes open", with loose ends if there are any, and "before
    // their share is taken" where only that is seen; empty: none are wanted.
    std::string words() const;

private:
    std::vector<VolumeView> wanted_;
    bool asked_ = false, done_ = false; // for them; they are there
    double moved_s_ = 0, now_s_ = 0;
    ProofGaps gaps_;
    long number_ = 0;
    Worker work_;
};

} // namespace trivar
