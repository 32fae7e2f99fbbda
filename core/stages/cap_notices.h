// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace trivar {

// CapCounts tells how the cuts through the parts of an object were closed, as Caps counts it.
struct CapCounts {
    std::size_t fans = 0, open = 0, gaps = 0;
};

// Returns sentences for the user, one per kind of hole that could not be closed as it should;
// empty: all were.
std::vector<std::string> notices_of(const CapCounts& counts);

} // namespace trivar
