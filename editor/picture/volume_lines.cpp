// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/picture/volume_lines.h"

#include "core/evaluation/shown_volume.h"
#include "core/silhouette/fans.h"
#include "core/silhouette/level_drawing.h"
#include "core/silhouette/line_budget.h"
#include "editor/picture/ink_curves.h"

namespace trivar {
namespace {

std::vector<gpu::Curve> lines_of(const ShownVolume& volume, int id, const glm::dmat4& to_world,
                                 const Camera& camera, float wider)
{
    std::vector<gpu::Curve> out;
    const ScalarField<float>& field = volume.field->field();
    const glm::dmat4 voxels_to_world = to_world * volume.to_model;
    const DrawingView view = drawing_view(camera, voxels_to_world, field.size());
    const PlacedInk placed{voxels_to_world, view.to_image, id, wider};
    for (const ShownVolume::Level& level : volume.levels) {
        if (!level.lines) continue;
        const DrawnLevel drawn{.name = level.name,
                               .mesh = *level.mesh,
                               .side = volume.side,
                               .style = level.ink,
                               .more = level.more,
                               .further = level.further.get()};
        const LevelBody body{field, volume.field->hulls(), level.mesh->level, volume.side};
        for (const std::vector<Stroke>& kind :
             level_strokes(field, volume.field->hulls(), drawn, view))
            add_curves(out,
                       inked_with_fans(body, within_budget(kind, level.more.amount), level.ink,
                                       view.to_image),
                       level.ink, placed);
        for (const KindStrokes& each : further_strokes(field, volume.field->hulls(), drawn, view)) {
            const LineStyle style = finer(level.ink, level.more);
            add_curves(out, inked(within_budget(each.strokes, level.more.amount), style), style,
                       placed);
        }
    }
    return out;
}

} // namespace

const std::vector<gpu::Curve>& VolumeLines::operator()(const EvaluatedObject& object,
                                                       const glm::dmat4& to_world,
                                                       const Camera& camera, float wider)
{
    static const std::vector<gpu::Curve> none;
    if (!object.shape || !object.shape->volume) return none;
    return known_({object.shape->volume, to_world, camera, object.id}, [&] {
        return lines_of(*object.shape->volume, object.id, to_world, camera, wider);
    });
}

} // namespace trivar
