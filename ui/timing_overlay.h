// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/paint.h"
#include "ui/timing_history.h"

#include <optional>

namespace trivar::ui {

// One way to do a work, beside others that do the same.
struct TimedWay {
    std::string name, sentence;
    bool used = false;
    std::optional<double> time_ms = {}; // none: not measured
    std::size_t vertices = 0;
    std::string off = {}; // from the exact result; empty: not compared
};

struct TimingSources {
    const TimingHistory& history;
    const Timings& evaluation; // the last that had something to compute
    const Timings& at_rest;    // the passes of the last full picture, which nobody waits for
    std::size_t program_bytes = 0, uploaded_bytes = 0;
    std::vector<TimedWay> ways = {}; // to deform
};

// What the overlay keeps between frames.
struct TimingView {
    bool open = false;
    long held = 0; // number of the picture that is shown instead of the newest, from 1; 0: none
    // Asked for in this frame: another way, by its place, and that all are measured.
    std::optional<std::size_t> other_way = {};
    bool measure_ways = false;
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
