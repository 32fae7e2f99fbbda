// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

namespace trivar {

// How large a draft is drawn, as a share of its size, so that what is dragged keeps up with the
// hand: smaller when drafts take too long, larger again when there is time to spare. Told the times
// of drafts one after the other; a change waits for a few of them and for a second to pass.
class DraftPace {
public:
    explicit DraftPace(double target_ms, double scale = 1) : target_ms_(target_ms), scale_(scale) {}

    void drew(double took_ms, double now_s);
    double scale() const { return scale_; }

private:
    static constexpr std::size_t few = 5;
    double target_ms_, scale_;
    std::array<double, few> took_ms_{}; // the last ones, since the last change
    std::size_t count_ = 0;
    double changed_s_ = -1e9;
};

} // namespace trivar
