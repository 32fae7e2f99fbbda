// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stages/curve_part.h"

#include <utility>

namespace trivar {

Curves in_world(const CurvePart& part)
{
    Curves out = *part.curves;
    const Ref<Mesh>& points = part.points.mesh();
    const bool there = part.points.to_world == glm::dmat4(1);
    out.points = there ? points : make_ref(transformed(*points, part.points.to_world));
    return out;
}

std::vector<Part> with_points(std::vector<Part> parts, const std::vector<CurvePart>& curves)
{
    for (const CurvePart& each : curves) parts.push_back(each.points);
    return parts;
}

void put_back(std::vector<Part> all, std::vector<Part>& parts, std::vector<CurvePart>& curves)
{
    const std::size_t first = all.size() - curves.size();
    for (std::size_t i = 0; i < curves.size(); ++i) curves[i].points = std::move(all[first + i]);
    all.resize(first);
    parts = std::move(all);
}

} // namespace trivar
