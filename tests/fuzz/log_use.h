// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/history.h"

#include <string>

namespace trivar::testing {

// What a program does with a scene: reads and replays it, takes all of it back and does it again,
// writes it whole and compact, reads that, opens it as a file that it goes on with and, where that
// is cheap, works out what it shows, at two frames, and writes that. Throws Rejected where the
// scene is refused and Broken where a promise does not hold.
void use_log(const std::string& path);

// Written, whole and compact, and read back it gives the same document; so it does when all of it
// is undone and done again. Throws Broken.
void check_history(const History& history);

} // namespace trivar::testing
