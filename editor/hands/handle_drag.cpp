// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/handle_drag.h"

#include <imgui.h>

namespace trivar {

bool wants_round_steps()
{
    return ImGui::GetIO().KeyCtrl;
}

std::vector<Hint> handle_hints(bool dragging, const char* verb)
{
    if (dragging)
        return {{{"left"}, "Let go when done"},
                {{"Ctrl"}, "Round steps"},
                {{"Esc", "/", "right"}, "Cancel"}};
    return {{{"left"}, verb}, {{"Ctrl"}, "Round steps"}};
}

} // namespace trivar
