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

// A LevelStyle says what the histogram is of.
struct LevelStyle {
    std::span<const std::uint64_t> counts; // in equal parts of [lo, hi]
    double lo = 0, hi = 1;
    std::array<std::string, 2> ends{}; // the words below both ends
    float height = 92;                 // at scale 1
    bool fixed = false;                // nothing is dragged
};

// A histogram with heights that grow as the logarithm of the counts, and values on it as lines with
// a grip below, which are dragged sideways (Shift ten times finer) and stay within [lo, hi]. After
// a double click the next number field takes what is typed. `chosen` is the value in the hand, or
// the last one that was; -1: none. Esc restores during a drag.
Edit level_field(const Theme& theme, const std::string& id, std::vector<LevelMark>& marks,
                 int& chosen, const LevelStyle& style, float width);

} // namespace trivar::ui
