// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/ref.h"
#include "core/placement/placement.h"
#include "core/placement/pressing.h"

namespace trivar {

// What came of one step of shaping.
struct Shaping {
    // Metres that the ball or the points should go, and went; of a ball that was drawn along, how
    // far it took any point; of what has no such wish both are how far the volume moved anywhere,
    // at most.
    double asked = 0, done = 0;
    bool would_fold = false; // why less was done than asked
    std::string words = {};  // what was done, where there was a choice
    std::string notice = {}; // why the step gave nothing; else empty
};

struct ShapedVolume {
    Ref<Placement> placement; // with the volume as it is, and its contact surface
    Ref<LaidVolume> volume;
    std::vector<Shaping> steps; // one for each edit
};

// Does the steps one after another, and remembers some of the volumes between them: a step at the
// end, or one more sample of the last press, costs that much, the way back by one nothing for the
// last three and less than two steps on the mean. After Cancelled it goes on where it was.
class Shaper {
public:
    Ref<ShapedVolume> operator()(const Ref<Placement>& laid,
                                 const std::vector<Ref<VolumeEdit>>& edits,
                                 const Progress& progress = {});

    // Volumes, of n steps at most 1 + 2 log2 n; each holds 24 bytes a control point and 12 a cell.
    std::size_t remembered() const;

private:
    struct Done {
        Ref<VolumeEdit> edit;
        Ref<LaidVolume> after; // null where it is not remembered
        Shaping what;
    };
    Done done(const Ref<VolumeEdit>& edit, const Ref<LaidVolume>& before, const Progress& progress);
    void forget();
    Done shifted(const Ref<VolumeEdit>& edit, const Ref<LaidVolume>& before);
    Done pressed(const Ref<VolumeEdit>& edit, const Ref<LaidVolume>& before,
                 const Progress& progress);

    Ref<Placement> laid_;
    Ref<LaidVolume> begun_;
    Ref<ShapedVolume> last_;
    std::vector<Done> done_;
    // The last press, and from where it went on.
    Ref<LaidVolume> pressed_from_;
    Press press_;
    Shaping so_far_;
    std::optional<Pressing> pressing_;
};

} // namespace trivar
