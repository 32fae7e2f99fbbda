// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/paint.h"
#include "ui/timing_history.h"

namespace trivar::ui {

// The colour of a time: good within a frame of 60 Hz, tolerable within one of 30.
Color timing_color(const Theme& theme, double ms);

// Draws a bar per picture, the newest at the right: its passes stand on its evaluation. Lines show
// the frames of 60 and of 30 Hz. `marked` is the number of the marked picture; 0: none.
void draw_timing_graph(const Theme& theme, const TimingHistory& history, const Rect& in,
                       long marked);

// The number of the picture whose bar is at x; 0: none.
long picture_at(const TimingHistory& history, const Rect& graph, float x);

} // namespace trivar::ui
