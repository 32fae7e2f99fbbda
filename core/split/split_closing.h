// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace trivar {

// The way in which the halves of a split are closed. The first two are the values of a former
// switch.
enum class SplitClosing : std::uint8_t {
    open,     // not at all
    capped,   // by caps: solid halves
    stitched, // by drawing in the skin beside the opening until its lips meet: a skin, with nothing
              // inside
};

} // namespace trivar
