// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace trivar::testing {

// What a program does with a scene: reads and replays it, takes all of it back and does it again,
// writes it whole and compact, reads that, opens it as a file that it goes on with and, where that
// is cheap, works out what it shows, at two frames, and writes that. Throws Rejected where the
// scene is refused and Broken where a promise does not hold.
void use_log(const std::string& path);

} // namespace trivar::testing
