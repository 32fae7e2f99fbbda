// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/picture/volume_lines.h"

#include "core/evaluation/shown_volume.h"
#include "editor/picture/ink_curves.h"

namespace trivar {
namespace {

std::vector<gpu::Curve> lines_of(const ShownVolume& volume, int id, const glm::dmat4& to_world,
                                 const Camera& camera, float wider)
{
    std::vector<gpu::Curve> out;
    const VoxelField& field = *volume.field;
    const glm::dmat4 voxels_to_world = to_world * volume.to_model;
    const DrawingView view = drawing_view(camera, voxels_to_world, field.field().size());
    const LevelDrawing drawing =
        draw_levels(field.field(), field.hulls(), volume.drawn_levels(), view);
    for (const DrawingLayer& layer : drawing.layers)
        add_curves(out, layer.lines, {voxels_to_world, view.to_image, id, wider});
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
