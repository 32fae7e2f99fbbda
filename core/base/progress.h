// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string_view>

namespace trivar {

// Called now and then by long work: the fraction done, in [0, 1], and the name of the stage.
// The callee may throw Cancelled, which the work lets pass. An empty function is silence.
using Progress = std::function<void(double fraction, std::string_view stage)>;

inline void report(const Progress& progress, double fraction, std::string_view stage)
{
    if (progress) progress(fraction, stage);
}

// Of a piece of that work, which is all of it from one fraction to another.
inline Progress part_of(const Progress& progress, double from, double to)
{
    if (!progress) return {};
    return [=, &progress](double fraction, std::string_view stage) {
        progress(from + fraction * (to - from), stage);
    };
}

} // namespace trivar
