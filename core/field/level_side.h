// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace trivar {

// The side of its level on which a body is.
enum class LevelSide : std::uint8_t { above, below };

} // namespace trivar
