// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/select.h"

#include "ui/icons.h"
#include "ui/widgets.h"

#include <imgui.h>

namespace trivar {

const char* SelectTool::icon() const
{
    return ui::icon::select;
}

void SelectTool::use(Session& session, const ViewportInput& input)
{
    if (input.pressed) session.selected = input.under;
}

void SelectTool::options(Session& session, const ui::Theme& theme, float width)
{
    const std::string name = name_of(session.document(), session.selected);
    const std::string words = name.empty() ? "Click an object to see what can be changed" : name;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ui::paint_text(theme.font.body, ui::rect_at({at.x, at.y}, {width, theme.size.row}),
                   theme.color.text_2, ui::elided(theme.font.body, words, width));
}

std::vector<Hint> SelectTool::hints(const Session& session) const
{
    std::vector<Hint> hints{{{"left"}, "Select"},
                            {{"middle"}, "Orbit"},
                            {{"Shift", "middle"}, "Pan"},
                            {{"wheel"}, "Zoom"}};
    if (session.selected != 0) {
        hints.push_back({{"."}, "Frame"});
        hints.push_back({{"Del"}, "Delete"});
    } else {
        hints.push_back({{"Home"}, "Frame all"});
    }
    hints.push_back({{"D"}, "Place"});
    return hints;
}

} // namespace trivar
