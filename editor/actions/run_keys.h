// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace trivar {

struct Editor;

// Runs the actions whose keys were struck in this frame.
void run_keys(Editor& editor);

} // namespace trivar
