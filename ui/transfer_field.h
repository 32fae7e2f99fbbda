// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/casting/transfer.h"
#include "ui/widgets.h"

#include <array>
#include <cstdint>
#include <span>

namespace trivar::ui {

// A TransferStyle names the quantity of the histogram behind a transfer function.
struct TransferStyle {
    std::span<const std::uint64_t> counts; // in equal parts of [lo, hi]
    double lo = 0, hi = 1;
    std::array<std::string, 2> ends{}; // the words below both ends
    std::string unit = {};             // of the values
    std::size_t most_points = 64;
    float height = 116; // at scale 1
};

// A transfer function over a histogram: values to the right, opacities upward by their roots, so
// that thin ones have room, and its colours below the line. Its points, which ascend, are dragged
// (Shift ten times finer), each between its neighbours. A double click adds a point where there is
// none, and on one lets the next number field take what is typed. A right click removes the point
// under the mouse, Del the chosen one while the mouse is over the picture; two points stay.
// `chosen` is the point in the hand, or the last one that was; -1: none. Esc restores during a
// drag.
Edit transfer_field(const Theme& theme, const std::string& id, std::vector<TransferPoint>& points,
                    int& chosen, const TransferStyle& style, float width);

} // namespace trivar::ui
