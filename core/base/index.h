// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace trivar {

// Converts an int, which counts here, to the size_t of the standard's containers. i >= 0.
constexpr std::size_t at(int i)
{
    return static_cast<std::size_t>(i);
}

} // namespace trivar
