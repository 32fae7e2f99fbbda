// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/shaping.h"
#include "ui/option_bar.h"

namespace trivar {

// The choice of a falloff in a tool's bar. The theme and the falloff outlive it.
inline ui::Option falloff_option(const ui::Theme& theme, Decay& falloff, const char* help)
{
    return ui::enum_option(ui::choice, theme, "Falloff", 104, "decay", falloff,
                           {"Gaussian", "Hat", "Box", "Smooth"}, help);
}

} // namespace trivar
