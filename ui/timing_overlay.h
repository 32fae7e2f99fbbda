// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/paint.h"
#include "ui/timing_history.h"

namespace trivar::ui {

struct TimingSources {
    const TimingHistory& history;
    const Timings& evaluation; // the last that had something to compute
    const Timings& at_rest;    // the passes of the last full picture, which nobody waits for
    std::size_t program_bytes = 0, uploaded_bytes = 0;
};

// What the overlay keeps between frames.
struct TimingView {
    bool open = false;
    long held = 0; // number of the picture that is shown instead of the newest, from 1; 0: none
};

// A pill with the median; pressed, it opens a card with a bar for each of the last pictures and
// the stages of one with their times and shares: the newest, the one under the mouse, or the one
// that was clicked.
// `key` opens and closes it as well.
void draw_timing(const Theme& theme, glm::vec2 at, float max_height, const TimingSources& sources,
                 TimingView& view, const std::string& key);

// All of the card as text, with the names that `--timings` writes.
std::string timing_text(const TimingSources& sources);

} // namespace trivar::ui
