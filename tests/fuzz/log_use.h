// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/scene/history.h"

#include <string>

namespace trivar::testing {

// Uses a scene like the program: reads and replays it, undoes all of it and does it again, writes
// it whole and compact, reads that, opens it as a file to continue and, if that is cheap, evaluates
// it at two frames, and writes that. Throws Rejected if the scene is refused and Broken if a
// promise does not hold.
void use_log(const std::string& path);

// Written, whole and compact, and read back it gives the same document; so it does when all of it
// is undone and done again. Throws Broken.
void check_history(const History& history);

} // namespace trivar::testing
