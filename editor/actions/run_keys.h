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
// Remembers the open popups after a frame: the Esc of the next frame closes these, and nothing
// more.
void remember_popups(Editor& editor);

} // namespace trivar
