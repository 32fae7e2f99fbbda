// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/preferences/preferences_dialog.h"

#include <array>

namespace trivar {

const char* preferences_page_name(int page)
{
    constexpr std::array<const char*, PreferencesDialog::page_count> names{
        "General", "Interface",          "Viewport",    "Mouse and trackpad",
        "Key map", "Files and recovery", "Performance", "Accessibility",
        "About"};
    return names[static_cast<std::size_t>(page)];
}

} // namespace trivar
