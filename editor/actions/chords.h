// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/keys.h"

namespace trivar {

// Short ways to write keys in tables.
constexpr ui::Chord ctrl(int key, bool shift = false)
{
    return {.key = key, .ctrl = true, .shift = shift};
}
constexpr ui::Chord alt(int key)
{
    return {.key = key, .alt = true};
}

} // namespace trivar
