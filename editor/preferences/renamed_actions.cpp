// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/preferences/renamed_actions.h"

#include <algorithm>

namespace trivar {

const std::vector<std::pair<std::string_view, std::string_view>>& renamed_actions()
{
    static const std::vector<std::pair<std::string_view, std::string_view>> all{
        {"Collect files beside the scene", "Collect files next to scene"},
        {"Detach from stroke", "Remove from stroke"},
        {"Discarded scenes...", "Recover discarded scenes..."},
        {"Keep this view", "Bookmark view"},
        {"Make room for what travels", "Extend range to fit motion"},
        {"Mend the volume", "Repair folds"},
        {"Read files anew", "Reload files"},
        {"Save compact...", "Save without undone steps..."},
        {"See through", "X-ray"},
        {"Select nothing", "Deselect all"},
        {"Select the others", "Invert selection"},
        {"Take off the stroke", "Remove from stroke"},
        {"Triangles as they are", "Original triangles"},
        {"Use this view for pictures", "Set render camera to view"},
        {"Usual size of the interface", "Reset interface size"},
        {"View of pictures", "Render camera"},
    };
    return all;
}

std::string_view present_action(std::string_view name)
{
    const auto& all = renamed_actions();
    const auto found =
        std::ranges::find(all, name, &std::pair<std::string_view, std::string_view>::first);
    return found == all.end() ? name : found->second;
}

} // namespace trivar
