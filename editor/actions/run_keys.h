// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace trivar {

struct Editor;

struct HeldSpace {
    bool down = false;
    bool used = false; // for something else than its own action
};

// Runs the actions whose keys were struck in this frame.
void run_keys(Editor& editor);

} // namespace trivar
