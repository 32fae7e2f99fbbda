// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/level.h"

#include <array>
#include <cstddef>

namespace trivar {

// A DraftPace says how much is spent on pictures of moving things, so that they keep up with the
// hand. It follows the median of the last eight drawing times: above 1.25 times the target it steps
// down, the level first and then the size; after sixty pictures below half of the target it steps
// up again. Changes are at least a second apart. A level that was too slow is not tried again.
class DraftPace {
public:
    DraftPace(double target_ms, gpu::Level highest, double scale = 1)
        : target_ms_(target_ms),
          highest_(highest),
          level_(highest),
          scale_(scale)
    {
    }

    void drew(double took_ms, double now_s); // 0 ms: not measured
    gpu::Level level() const { return level_; }
    double scale() const { return scale_; } // of a draft's size; 1 at other levels

private:
    void step_down(double usual_ms);
    void step_up();
    static constexpr std::size_t few = 8, many = 60;
    double target_ms_;
    gpu::Level highest_, level_;
    double scale_;
    std::array<double, few> took_ms_{}; // the last ones, since the last change
    std::size_t count_ = 0, quick_ = 0; // since then; of these the last in a row with time to spare
    double changed_s_ = -1e9;
};

} // namespace trivar
