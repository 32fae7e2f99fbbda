// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/parallel.h"
#include "ui/frame.h"

#include <memory>

namespace trivar {

struct Editor;

// PreferencesInForce are preferences that must be applied, such as the thread limit.
struct PreferencesInForce {
    int threads = 0;
    std::unique_ptr<ThreadLimit> limit;
};

// Draws the whole window: takes input, runs keys, shows every panel.
void draw_editor(Editor& editor, ui::Frame& frame);

} // namespace trivar
