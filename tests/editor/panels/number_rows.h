// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/editor/rig.h"

#include <algorithm>

namespace trivar::testing {

// Whether a number of that name is under the mouse.
inline bool is_over_number(const Rig& rig, const std::string& name)
{
    return std::ranges::count(rig.editor.keys_under_mouse.names, name) > 0;
}

// A place in the first field of the inspector's row whose number has that name; the mouse goes
// down the rows to find it. Adds a failure if there is none.
inline glm::vec2 number_field(Rig& rig, const std::string& name)
{
    const ui::Rect in = rig.layout().inspector;
    const ui::Theme& theme = rig.screen.theme();
    const float x = in.lo.x + theme.size.padding + theme.size.label + 12;
    for (float y = in.lo.y + 6; y < in.hi.y; y += 6) {
        rig.move({x, y});
        if (is_over_number(rig, name)) return {x, y + 6};
    }
    ADD_FAILURE() << "no row for " << name;
    return in.lo;
}

} // namespace trivar::testing
