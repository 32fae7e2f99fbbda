// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "editor/action.h"

#include <array>
#include <string>

namespace trivar {

// A MenuBeside is a menu that opens beside an entry of another one: a window may be too low for one
// menu that holds all of them.
struct MenuBeside {
    const char *menu, *name;
    const char* after; // the entry of the menu under which it stands
};
inline constexpr std::array menus_beside{MenuBeside{"View", "Viewpoint", "Frame all"},
                                         MenuBeside{"View", "Shading", "Frame all"},
                                         MenuBeside{"View", "Detail", "Frame all"},
                                         MenuBeside{"View", "Interface", "Frame all"},
                                         MenuBeside{"Edit", "Reset", "Duplicate"},
                                         MenuBeside{"Edit", "Lattice", "Remove from stroke"},
                                         MenuBeside{"Tools", "Surface", "Clear cuts"}};

// "View > Detail": how a hand gets to the action.
inline std::string menu_path(const Action& action)
{
    for (const MenuBeside& each : menus_beside)
        if (action.menu == each.name) return std::string(each.menu) + " > " + each.name;
    return action.menu;
}

} // namespace trivar
