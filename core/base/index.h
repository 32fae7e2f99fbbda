// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace trivar {

// Numbers that are counted with are int; the standard's containers want size_t. i >= 0.
constexpr std::size_t at(int i)
{
    return static_cast<std::size_t>(i);
}

} // namespace trivar
