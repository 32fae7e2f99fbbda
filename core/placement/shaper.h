// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/ref.h"
#include "core/placement/placement.h"
#include "core/placement/pressing.h"

namespace trivar {

// A Shaping is the result of one step of shaping.
struct Shaping {
    // `asked` is how far, in metres, the ball or the points should move, `done` how far they moved.
    // For a ball that was drawn along, `done` is the longest way of any point; for a step without a
    // wished distance both are the largest movement anywhere in the volume.
    double asked = 0, done = 0;
    bool would_fold = false; // the guard is why less was done than asked
    std::string words = {};  // what was done, where there was a choice
    std::string notice = {}; // why the step gave nothing; empty: it worked
};

struct ShapedVolume {
    Ref<Placement> placement; // with the present volume and its contact surface
    Ref<LaidVolume> volume;
    std::vector<Shaping> steps; // one per edit
};

// A Shaper does the steps one after another and remembers some of the volumes between them. A step
// at the end, or one more sample of the last press, costs only itself; going back by one step costs
// nothing for the last three steps, and fewer than two steps on average. After Cancelled it
// continues where it was.
class Shaper {
public:
    Ref<ShapedVolume> operator()(const Ref<Placement>& laid,
                                 const std::vector<Ref<VolumeEdit>>& edits,
                                 const Progress& progress = {});

    // The number of remembered volumes: for n steps at most 1 + 2 log2 n. Each takes 24 bytes per
    // control point and 12 per cell.
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
    // The last press, and the volume from which it continued.
    Ref<LaidVolume> pressed_from_;
    Press press_;
    Shaping so_far_;
    std::optional<Pressing> pressing_;
};

} // namespace trivar
