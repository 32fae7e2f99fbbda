// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/stat.h>

namespace trivar {

// Whether a program that holds a lock (flock) on the file is about to end: killed or crashed, and
// freeing its memory before its lock, which then follows in a moment. False where the system does
// not say who holds the lock (Linux does, in /proc).
bool held_by_the_dying(const struct stat& file);

} // namespace trivar
