// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string_view>

namespace trivar {

// Long work calls its Progress now and then with the fraction done, in [0, 1], and the name of the
// stage. The callee may throw Cancelled, which the work passes on. An empty function hears nothing.
using Progress = std::function<void(double fraction, std::string_view stage)>;

inline void report(const Progress& progress, double fraction, std::string_view stage)
{
    if (progress) progress(fraction, stage);
}

// The progress for one part of some work, which runs from fraction `from` to fraction `to` of the
// whole.
inline Progress part_of(const Progress& progress, double from, double to)
{
    if (!progress) return {};
    return [=, &progress](double fraction, std::string_view stage) {
        progress(from + fraction * (to - from), stage);
    };
}

} // namespace trivar
