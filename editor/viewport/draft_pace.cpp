// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/viewport/draft_pace.h"

#include <algorithm>

namespace trivar {
namespace {

constexpr std::array scales{1.0, 0.85, 0.75, 0.67, 0.5};
constexpr double too_long = 1.25, to_spare = 0.5; // shares of the target
constexpr double pause_s = 1;                     // between changes

} // namespace

void DraftPace::step_down(double usual_ms)
{
    if (level_ != gpu::Level::draft) {
        level_ = highest_ = static_cast<gpu::Level>(static_cast<int>(level_) - 1);
        return;
    }
    // Drawing time grows with the area; no scale changes the rest of the time.
    const double before = scale_;
    for (const double s : scales)
        if (s < before) {
            scale_ = s;
            if (usual_ms * (s * s) / (before * before) <= target_ms_) break;
        }
}

void DraftPace::step_up()
{
    const double before = scale_;
    for (const double s : scales)
        if (s > before) scale_ = s; // the smallest of the larger ones: they descend
    if (scale_ == before && level_ < highest_)
        level_ = static_cast<gpu::Level>(static_cast<int>(level_) + 1);
}

void DraftPace::drew(double took_ms, double now_s)
{
    if (!(took_ms > 0)) return;
    took_ms_[count_++ % few] = took_ms;
    quick_ = took_ms < to_spare * target_ms_ ? quick_ + 1 : 0;
    if (count_ < few || now_s - changed_s_ < pause_s) return;
    std::array<double, few> sorted = took_ms_;
    std::nth_element(sorted.begin(), sorted.begin() + few / 2, sorted.end());
    const double usual = sorted[few / 2], scale = scale_;
    const gpu::Level level = level_;
    if (usual > too_long * target_ms_)
        step_down(usual);
    else if (quick_ >= many)
        step_up();
    if (scale_ == scale && level_ == level) return;
    changed_s_ = now_s;
    count_ = quick_ = 0;
}

} // namespace trivar
