// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/selected_placement.h"

#include <algorithm>

namespace trivar {

const EvaluatedObject* selected_volume(const Session& session)
{
    if (session.selected.size() != 1) return nullptr;
    if (locked(session.document(), session.selected)) return nullptr;
    const auto found = session.evaluated().objects.find(session.selected);
    if (found == session.evaluated().objects.end() || !found->second->placement) return nullptr;
    const auto there = session.document().objects.find(session.selected);
    if (there == session.document().objects.end()) return nullptr;
    const bool has_volume = kind_of(*there->second).has_cage || there->second->stroke;
    return has_volume ? &*found->second : nullptr;
}

const EvaluatedObject* selected_placement(const Session& session)
{
    const EvaluatedObject* found = selected_volume(session);
    return found && object(session.document(), found->id).stroke ? found : nullptr;
}

NearestLine nearest_on_line(const Placement& placement, const Camera& camera, glm::dvec2 p_px)
{
    NearestLine nearest;
    if (placement.strip.empty() || placement.strip.front().size() < 2) return nearest;
    const std::vector<glm::dvec3>& line = placement.strip.front();
    const double steps = static_cast<double>(line.size() - 1);
    PicturePoint before = project(camera, line.front());
    for (std::size_t i = 1; i < line.size(); ++i) {
        const PicturePoint here = project(camera, line[i]);
        if (before.depth_world > 0 && here.depth_world > 0) {
            const glm::dvec2 way = here.p_px - before.p_px;
            const double square = glm::dot(way, way);
            const double f =
                square > 0 ? std::clamp(glm::dot(p_px - before.p_px, way) / square, 0.0, 1.0) : 0;
            const double distance = glm::distance(before.p_px + f * way, p_px);
            if (distance < nearest.distance_px)
                nearest = {(static_cast<double>(i - 1) + f) / steps, distance};
        }
        before = here;
    }
    return nearest;
}

} // namespace trivar
