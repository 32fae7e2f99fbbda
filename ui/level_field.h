// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/widgets.h"

#include <array>
#include <cstdint>
#include <span>

namespace trivar::ui {

// A LevelMark is a value that is marked on a histogram.
struct LevelMark {
    double value = 0;
    Color color = 0;
    std::string words; // beside it
    bool dim = false;  // it is hidden
};

// A LevelStyle names the quantity of the histogram.
struct LevelStyle {
    std::span<const std::uint64_t> counts; // in equal parts of [lo, hi]
    double lo = 0, hi = 1;
    std::array<std::string, 2> ends{}; // the words below both ends
    float height = 92;                 // at scale 1
    // A curve below the bars, in a strip of that height at scale 1: places (value, height) that
    // ascend, heights of any unit; empty: the strip has none yet.
    std::span<const glm::dvec2> curve = {};
    float strip = 0;
    std::span<const double> snaps = {}; // values at which a drag halts, dots on the curve
    bool fixed = false;                 // nothing is dragged
};

// The nearest of the values to snap to; the value itself if none is within the reach.
double snapped(std::span<const double> to, double value, double reach);

// A histogram, and values on it as lines with a grip below, which are dragged sideways (Shift ten
// times finer) and stay within [lo, hi]. They snap within a few pixels, unless Ctrl is held. After
// a double click the next number field takes what is typed. `chosen` is the value in the hand, or
// the last one that was; -1: none. Esc restores during a drag.
Edit level_field(const Theme& theme, const std::string& id, std::vector<LevelMark>& marks,
                 int& chosen, const LevelStyle& style, float width);

} // namespace trivar::ui
