// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/picture/ink_curves.h"

#include "core/drawing/line_pieces.h"

#include <algorithm>
#include <glm/gtc/color_space.hpp>

namespace trivar {
namespace {

gpu::Curve curve_of(const InkedLine& line, const PlacedInk& placed, const glm::dmat4& to_space)
{
    Polyline points;
    float width = 0;
    for (const InkedLine::Point& p : line.points) width = std::max(width, p.width);
    if (line.dashed) width = width_of(line); // as in files
    for (const InkedLine::Point& p : line.points) {
        glm::vec3 at = p.p;
        if (line.strays) {
            const glm::dvec4 seen = placed.to_image * glm::dvec4(p.p, 1);
            const glm::dvec4 there = to_space * glm::dvec4(glm::dvec2(p.at), seen.z / seen.w, 1);
            at = glm::vec3(glm::dvec3(there) / there.w);
        }
        points.points.push_back(at);
        points.colors.emplace_back(glm::convertSRGBToLinear(p.color), line.opacity);
        points.widths.push_back(width > 0 && !line.dashed ? p.width / width : 1);
    }
    return {
        .line = make_ref(std::move(points)),
        .to_world = placed.to_world,
        .style = {.width_px = width * placed.wider,
                  .hidden = line.hidden ? gpu::HiddenParts::as_seen : gpu::HiddenParts::left_out,
                  .dash_px = static_cast<float>(dash_of(line)) * placed.wider,
                  .own_reach_world = line.hidden ? 0 : placed.own_reach,
                  .as_ink = true},
        .id = placed.id};
}

} // namespace

void add_curves(std::vector<gpu::Curve>& out, const std::vector<InkedLine>& lines,
                const PlacedInk& placed)
{
    const glm::dmat4 to_space = glm::inverse(placed.to_image);
    for (const InkedLine& line : lines)
        if (line.points.size() > 1) out.push_back(curve_of(line, placed, to_space));
}

} // namespace trivar
