// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/timing.h"

#include <deque>

namespace trivar::ui {

// What one picture took: the evaluation it is the first to show, where there is one, and its
// passes.
struct TimedPicture {
    Timings evaluation, passes;
};

double total_ms(const Timings& timings);
double total_ms(const TimedPicture& picture);

// The last pictures somebody waited for, the newest last.
class TimingHistory {
public:
    static constexpr std::size_t length = 80;
    void add(TimedPicture picture);
    const std::deque<TimedPicture>& pictures() const { return pictures_; }
    const TimedPicture* find(long number) const; // counted from 1; nothing where it is forgotten
    long count() const { return count_; }        // of all there ever were
    double median_ms() const;                    // of the last fifteen; 0 of none

private:
    std::deque<TimedPicture> pictures_;
    long count_ = 0;
};

} // namespace trivar::ui
