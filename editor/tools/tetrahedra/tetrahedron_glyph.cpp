// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/tetrahedra/tetrahedron_glyph.h"

#include <algorithm>
#include <cmath>
#include <imgui.h>

namespace trivar {
namespace {

// Darker below 1, nearer to white above it.
ui::Color shaded(ui::Color color, float light)
{
    ui::Color out = color & 0xFF000000u;
    for (unsigned shift = 0; shift < 24; shift += 8) {
        const auto value = static_cast<float>((color >> shift) & 255u);
        const float lit = light < 1 ? value * light : value + (255 - value) * (light - 1);
        out |= static_cast<ui::Color>(lit) << shift;
    }
    return out;
}

} // namespace

TetrahedronGlyph::TetrahedronGlyph()
{
    // in the view: right, up, toward the eye
    constexpr double turned = 0.35, tilted = 0.3; // radians, so that two unlike faces are seen
    std::array<glm::dvec3, 4> corners{glm::dvec3(0, 1, 0)};
    for (std::size_t k = 1; k < 4; ++k) {
        const double a = turned + glm::radians(120.0 * static_cast<double>(k) - 30);
        corners[k] = {std::sqrt(8) / 3 * std::cos(a), -1.0 / 3, std::sqrt(8) / 3 * std::sin(a)};
    }
    for (glm::dvec3& c : corners)
        c = {c.x, std::cos(tilted) * c.y - std::sin(tilted) * c.z,
             std::sin(tilted) * c.y + std::cos(tilted) * c.z};
    const glm::dvec3 lamp = glm::normalize(glm::dvec3(-0.8, 0.4, 0.45));
    for (std::size_t k = 0; k < 4; ++k) {
        const glm::dvec3 outward = -corners[k]; // of the face opposite to a corner
        if (outward.z <= 0) continue;
        Face face{{}, static_cast<float>(0.75 + 0.6 * std::max(0.0, glm::dot(outward, lamp)))};
        for (std::size_t i = 0; i < 3; ++i) {
            const glm::dvec3& c = corners[(k + 1 + i) % 4];
            face.corners[i] = {c.x, -c.y};
        }
        faces_.push_back(face);
    }
}

void TetrahedronGlyph::paint(const ui::Theme& theme, glm::vec2 at, float radius_px,
                             ui::Color color) const
{
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const auto fill = [&](const Face& face, float radius, ui::Color with) {
        std::array<ImVec2, 3> p;
        for (std::size_t i = 0; i < 3; ++i)
            p[i] = {at.x + face.corners[i].x * radius, at.y + face.corners[i].y * radius};
        draw.AddTriangleFilled(p[0], p[1], p[2], with);
    };
    const float alpha = static_cast<float>(color >> 24) / 255;
    const float rim = 2.2f * theme.scale; // so that it stands out on any ground
    for (const Face& face : faces_) fill(face, radius_px + rim, ui::faded(theme.color.halo, alpha));
    for (const Face& face : faces_) fill(face, radius_px, shaded(color, face.light));
}

} // namespace trivar
