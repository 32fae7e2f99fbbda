// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/lazy.h"
#include "core/document/document.h"
#include "core/walking/foot_lock.h"

namespace trivar {

// A Walk keeps a clip in step with a travel: the clip advances as far as the model moves along its
// volume. A planted foot then keeps its place in the volume's parameters, and therefore in the
// world, at any speed.
struct Walk {
    Ref<Gait> gait;
    double stride_u = 0;      // along the volume, per period; negative: the model walks backwards
    double natural_speed = 0; // metres per second at which the clip plays at its own speed
    double correction = 0;    // largest correction of a foot, as a share of the stride
    // The largest distance in the world, as a share of the stride, that a vertex of a leg slides
    // while it touches the ground (within two thousandths of the model's height). It is measured
    // over the first ten seconds of the travel, or all of it if it is shorter, without looking at
    // the gait's stances. Where more than 256 vertices touch, 256 of them, evenly chosen, are
    // measured.
    Lazy<double> slide;
    std::string trouble; // a sentence that says why the feet are not locked; empty: they are
    // a sentence on effects that may not be intended although the feet are locked; empty: none
    std::string remark;

    double clip_time_s(const Playing& playing, double gone_u) const;
};

} // namespace trivar
