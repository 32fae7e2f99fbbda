// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/arrow_head.h"

#include <imgui.h>

namespace trivar {

void paint_arrow_head(const ui::Theme& theme, glm::vec2 at, glm::vec2 direction, float radius,
                      ui::Color color)
{
    const float length = glm::length(direction);
    const glm::vec2 d = length > 0 ? direction / length : glm::vec2(1, 0), n(-d.y, d.x);
    const glm::vec2 tip = at + d * radius * 1.3f;
    const glm::vec2 a = at - d * radius * 0.8f + n * radius,
                    b = at - d * radius * 0.8f - n * radius;
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddTriangleFilled({tip.x, tip.y}, {a.x, a.y}, {b.x, b.y}, color);
    draw.AddTriangle({tip.x, tip.y}, {a.x, a.y}, {b.x, b.y}, theme.color.halo, 1.5f * theme.scale);
}

} // namespace trivar
