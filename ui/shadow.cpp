// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/paint.h"

#include <array>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <imgui.h>

namespace trivar::ui {

// Rings of quads round a filled middle: their darkness falls with the square of the distance, and
// evenly between their corners, so that no edge shows.
void paint_shadow(const Rect& rect, float rounding, float reach, float strength)
{
    constexpr int steps = 8, arc = 8, around = 4 * (arc + 1);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.PushClipRectFullScreen();
    const auto shade = [&](float t) { return rgb(0, strength * (1 - t) * (1 - t)); };
    const Rect corners = rect.grown(-rounding); // where the arcs have their middles
    const std::array<glm::vec2, 4> middles{
        corners.hi, {corners.lo.x, corners.hi.y}, corners.lo, {corners.hi.x, corners.lo.y}};
    const ImVec2 plain = ImGui::GetFontTexUvWhitePixel();
    list.PrimReserve(6 * around * steps + 3 * (around - 2), around * (steps + 1));
    const unsigned first = list._VtxCurrentIdx;
    for (int s = 0; s <= steps; ++s) {
        const float t = static_cast<float>(s) / steps;
        for (int k = 0; k < around; ++k) {
            const float angle = glm::half_pi<float>() * (static_cast<float>(k / (arc + 1)) +
                                                         static_cast<float>(k % (arc + 1)) / arc);
            const glm::vec2 p =
                middles[static_cast<std::size_t>(k / (arc + 1))] +
                (rounding + t * reach) * glm::vec2(std::cos(angle), std::sin(angle));
            list.PrimWriteVtx({p.x, p.y}, plain, shade(t));
        }
    }
    const auto index = [&](int s, int k) {
        return static_cast<ImDrawIdx>(first + static_cast<unsigned>(s * around + k % around));
    };
    for (int s = 0; s < steps; ++s)
        for (int k = 0; k < around; ++k)
            for (const ImDrawIdx i : {index(s, k), index(s, k + 1), index(s + 1, k + 1),
                                      index(s, k), index(s + 1, k + 1), index(s + 1, k)})
                list.PrimWriteIdx(i);
    for (int k = 1; k + 1 < around; ++k)
        for (const ImDrawIdx i : {index(0, 0), index(0, k), index(0, k + 1)}) list.PrimWriteIdx(i);
    list.PopClipRect();
}

} // namespace trivar::ui
