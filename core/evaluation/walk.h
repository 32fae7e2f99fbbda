// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/lazy.h"
#include "core/document/document.h"
#include "core/mesh/foot_lock.h"

namespace trivar {

// A clip in step with a travel: it goes on as far as the model goes along its volume, so that in
// its parameters a planted foot stays where it is, and therefore in the world, whatever the speed.
struct Walk {
    Ref<Gait> gait;
    double stride_u = 0;      // along the volume, a period; negative: it walks backwards
    double natural_speed = 0; // metres a second at which the clip plays at its own speed
    double correction = 0;    // the largest a foot is moved by, as a share of the stride
    // How far a vertex of a leg that touches the ground, within two thousandths of the model's
    // height, goes over it in the world before it leaves it, at most, as a share of the stride:
    // over the first ten seconds of the travel, or all of it. Nothing is asked of the gait's
    // stances. Where more than 256 vertices touch, evenly some of them.
    Lazy<double> slide;
    std::string trouble; // why its feet are not locked, a sentence; empty: they are
    std::string remark;  // what may not be meant, though they are; empty: nothing

    double clip_time_s(const Playing& playing, double gone_u) const;
};

} // namespace trivar
