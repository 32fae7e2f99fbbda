// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/paint.h"

#include <cstdint>
#include <span>

namespace trivar::ui {

// A ValueScale puts values of [lo, hi] on places across a rectangle.
struct ValueScale {
    Rect rect;
    double lo = 0, hi = 1;
    float x(double value) const; // within the rectangle
    double value(float x) const; // within [lo, hi]
    double per_px() const;       // difference of values per pixel
};

// The bars of a histogram: heights grow as the logarithm of the counts, which are of equal parts of
// the scale. Bars are of whole pixels, each of several parts where the rectangle is narrow.
void paint_histogram(const Theme& theme, const ValueScale& scale,
                     std::span<const std::uint64_t> counts);

} // namespace trivar::ui
