// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/draft_pace.h"

#include <algorithm>

namespace trivar {
namespace {

constexpr std::array scales{1.0, 0.85, 0.75, 0.67, 0.5};
constexpr double too_long = 1.25, to_spare = 0.5; // shares of the target
constexpr double pause_s = 1;                     // between changes

} // namespace

void DraftPace::drew(double took_ms, double now_s)
{
    took_ms_[count_++ % few] = took_ms;
    if (count_ < few || now_s - changed_s_ < pause_s) return;
    std::array<double, few> sorted = took_ms_;
    std::nth_element(sorted.begin(), sorted.begin() + few / 2, sorted.end());
    const double usual = sorted[few / 2];
    const double before = scale_;
    if (usual > too_long * target_ms_) {
        // What is drawn grows with the area; the rest of the time no scale takes away.
        for (const double s : scales)
            if (s < before) {
                scale_ = s;
                if (usual * (s * s) / (before * before) <= target_ms_) break;
            }
    } else if (usual < to_spare * target_ms_) {
        for (const double s : scales)
            if (s > before) scale_ = s; // the smallest of the larger ones: they descend
    }
    if (scale_ == before) return;
    changed_s_ = now_s;
    count_ = 0;
}

} // namespace trivar
