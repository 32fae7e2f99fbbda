// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/stat.h>

namespace trivar {

// Whether a program that holds a lock (flock) on the file is on its way out: killed or crashed, and
// giving back its memory before its lock, which goes in a moment. False where the system does not
// say who holds it (Linux does, in /proc).
bool held_by_the_dying(const struct stat& file);

} // namespace trivar
