// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/timing.h"
#include "ui/paint.h"

namespace trivar::ui {

// Stages with the words that stand above them; what nobody waits for does not count in the pill.
struct TimingGroup {
    std::string title;
    const Timings* timings = nullptr;
    Color color = 0;
    bool waited_for = true;
};

// A pill with the total; pressed, it opens a card with every stage, its time and its share.
// Whether it is open is the caller's to keep.
void draw_timing(const Theme& theme, glm::vec2 at, float max_height,
                 const std::vector<TimingGroup>& groups, bool& open);

double total_ms(const Timings& timings);

} // namespace trivar::ui
