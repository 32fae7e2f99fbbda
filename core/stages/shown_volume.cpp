// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stages/shown_volume.h"

#include "core/lines/level_drawing.h"

#include <glm/gtc/matrix_transform.hpp>

namespace trivar {

std::vector<DrawnLevel> ShownVolume::drawn_levels() const
{
    std::vector<DrawnLevel> out;
    for (const Level& level : levels)
        if (level.lines)
            out.push_back({.name = level.name,
                           .mesh = *level.mesh,
                           .side = side,
                           .style = level.ink,
                           .more = level.more,
                           .further = level.further.get(),
                           .nearby = level.nearby ? std::span<const LevelMesh>(*level.nearby)
                                                  : std::span<const LevelMesh>(),
                           .certified_depth = level.certified ? certified_halvings : -1});
    return out;
}

bool ShownVolume::certifies() const
{
    return std::ranges::any_of(levels,
                               [](const Level& level) { return level.lines && level.certified; });
}

glm::dmat4 ShownVolume::all_to_model() const
{
    return glm::translate(to_model, -glm::dvec3(part.first));
}

Box ShownVolume::cast_box() const
{
    if (!casting) return {};
    const glm::dvec3 end(casting->field->field().end());
    const Box out{glm::max(end * glm::dvec3(seen_as.crop_low), glm::dvec3(part.first)),
                  glm::min(end * glm::dvec3(seen_as.crop_high), glm::dvec3(part.last))};
    return glm::all(glm::lessThan(out.lo, out.hi)) ? out : Box{};
}

std::vector<glm::dvec3> ShownVolume::seen_corners(const glm::dmat4& to_world) const
{
    Box box = cast_box();
    for (const Level& level : levels)
        if (level.lines)
            for (const glm::vec3& p : level.mesh->positions)
                box.add(glm::dvec3(part.first) + glm::dvec3(p));
    std::vector<glm::dvec3> out;
    if (!box.empty())
        for (const glm::dvec3& p : box.corners())
            out.emplace_back(to_world * all_to_model() * glm::dvec4(p, 1));
    return out;
}

} // namespace trivar
