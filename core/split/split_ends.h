// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace trivar {

// The begin and the end of an opening on the way: its walls leave 0 with a bend close to the
// obstacle, or earlier, with slope and curvature 0. [Schein, thesis, figure 6.3: with and without
// end interpolation]
enum class SplitEnds : std::uint8_t { sharp, smooth };

} // namespace trivar
