// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/falloff_option.h"

#include "ui/widgets.h"

namespace trivar {

ui::Option falloff_option(const ui::Theme& theme, Decay& falloff, const char* help)
{
    return {"Falloff", 104,
            [&](float field) {
                int kind = static_cast<int>(falloff);
                ui::choice(theme, "decay", kind, {"Gaussian", "Hat", "Box", "Smooth"}, field);
                falloff = static_cast<Decay>(kind);
            },
            help};
}

} // namespace trivar
