// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/picture/curves_picture.h"

#include <limits>

namespace trivar {
namespace {

glm::vec4 color_of(const std::vector<Material>& materials, std::uint32_t which)
{
    const Material plain;
    const Material& m = which < materials.size() ? materials[which] : plain;
    // A line gets no light: what shines adds to its colour.
    return {glm::vec3(m.base_color) + m.emissive,
            m.alpha == Material::Alpha::blend ? m.base_color.a : 1.0f};
}

// The lines of one material behind one another, with gaps between them.
Polyline lines_of(const CurvePart& part, std::uint32_t material, const glm::vec4& color)
{
    constexpr float nowhere = std::numeric_limits<float>::quiet_NaN();
    const Curves& curves = *part.curves;
    const Mesh& points = *part.points.mesh();
    Polyline out;
    const bool colored = !points.colors.empty();
    if (!colored) out.colors = {color};
    for (std::size_t l = 0; l < curves.line_count(); ++l) {
        if (curves.material_of(l) != material) continue;
        if (!out.points.empty()) {
            out.points.emplace_back(nowhere);
            if (colored) out.colors.push_back(color);
        }
        for (std::uint32_t p = curves.begin[l]; p < curves.begin[l + 1]; ++p) {
            out.points.push_back(points.positions[p]);
            if (colored) out.colors.push_back(color * points.colors[p]);
        }
    }
    return out;
}

} // namespace

std::vector<gpu::Curve> curves_of(const EvaluatedObject& object, float width_px)
{
    std::vector<gpu::Curve> out;
    for (const CurvePart& part : object.curves) {
        std::vector<bool> used;
        for (std::size_t l = 0; l < part.curves->line_count(); ++l) {
            const std::uint32_t material = part.curves->material_of(l);
            if (used.size() <= material) used.resize(material + 1);
            used[material] = true;
        }
        for (std::uint32_t m = 0; m < used.size(); ++m)
            if (used[m])
                out.push_back(
                    {.line = make_ref(lines_of(part, m, color_of(*object.materials, m))),
                     .to_world = part.points.to_world,
                     .style = {.width_px = width_px, .hidden = gpu::HiddenParts::left_out},
                     .id = object.id});
    }
    return out;
}

} // namespace trivar
