// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/level_under.h"

#include "core/document/bases.h"
#include "core/lines/level_drawing.h"

namespace trivar {
namespace {

double distance_to(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b)
{
    const glm::dvec2 along = b - a;
    const double length2 = glm::dot(along, along);
    const double t = length2 > 0 ? std::clamp(glm::dot(p - a, along) / length2, 0.0, 1.0) : 0;
    return glm::distance(p, a + t * along);
}

} // namespace

const ShownVolume* shown_volume_of(const Session& session, Id id)
{
    const auto found = session.evaluated().objects.find(id);
    if (found == session.evaluated().objects.end() || !found->second->shape) return nullptr;
    return found->second->shape->volume.get();
}

std::optional<int> level_under(const Session& session, Id id, glm::dvec2 at_px, double reach_px)
{
    const ShownVolume* volume = shown_volume_of(session, id);
    if (!volume) return {};
    const ScalarField<float>& field = volume->field->field();
    const DrawingView view = drawing_view(
        session.view.camera, to_world(session.document(), id) * volume->to_model, field.size());
    std::optional<int> best;
    for (const ShownVolume::Level& level : volume->levels) {
        if (!level.lines) continue;
        const DrawnLevel drawn{level.name, *level.mesh, volume->side, level.ink};
        for (const auto& strokes : level_strokes(field, volume->field->hulls(), drawn, view))
            for (const Stroke& stroke : strokes) {
                if (stroke.hidden && level.ink.hidden == HiddenLines::none) continue;
                for (std::size_t i = 1; i < stroke.points.size(); ++i) {
                    const double d = distance_to(at_px, glm::dvec2(stroke.points[i - 1].at),
                                                 glm::dvec2(stroke.points[i].at));
                    if (d > reach_px) continue;
                    reach_px = d;
                    best = static_cast<int>(level.number);
                }
            }
    }
    return best;
}

} // namespace trivar
