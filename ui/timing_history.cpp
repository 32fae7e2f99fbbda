// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/timing_history.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace trivar::ui {

double total_ms(const Timings& timings)
{
    double total = 0;
    for (const Timings::Stage& stage : timings.stages) total += stage.time_ms;
    return total;
}

double total_ms(const TimedPicture& picture)
{
    return total_ms(picture.evaluation) + total_ms(picture.passes);
}

void TimingHistory::add(TimedPicture picture)
{
    ++count_;
    pictures_.push_back(std::move(picture));
    if (pictures_.size() > length) pictures_.pop_front();
}

const TimedPicture* TimingHistory::find(long number) const
{
    const long first = count_ - static_cast<long>(pictures_.size()) + 1;
    if (number < first || number > count_) return nullptr;
    return &pictures_[static_cast<std::size_t>(number - first)];
}

double TimingHistory::median_ms() const
{
    constexpr std::ptrdiff_t recent = 15;
    std::vector<double> totals;
    const auto count = std::min(recent, std::ssize(pictures_));
    for (auto picture = pictures_.end() - count; picture != pictures_.end(); ++picture)
        totals.push_back(total_ms(*picture));
    if (totals.empty()) return 0;
    const auto middle = totals.begin() + std::ssize(totals) / 2;
    std::nth_element(totals.begin(), middle, totals.end());
    return *middle;
}

} // namespace trivar::ui
