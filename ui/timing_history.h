// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/timing.h"

#include <deque>

namespace trivar::ui {

// A TimedPicture holds the times of one picture: of the evaluation that it is the first to show, if
// there is one, and of its passes.
struct TimedPicture {
    Timings evaluation, passes;
};

double total_ms(const Timings& timings);
double total_ms(const TimedPicture& picture);

// A TimingHistory holds the last pictures for which somebody waited, the newest last.
class TimingHistory {
public:
    static constexpr std::size_t length = 80;
    void add(TimedPicture picture);
    const std::deque<TimedPicture>& pictures() const { return pictures_; }
    const TimedPicture* find(long number) const; // counted from 1; null where it is forgotten
    long count() const { return count_; }        // of all pictures so far
    double median_ms() const;                    // of the last fifteen; 0 if there are none

private:
    std::deque<TimedPicture> pictures_;
    long count_ = 0;
};

} // namespace trivar::ui
