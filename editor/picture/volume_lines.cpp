// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/picture/volume_lines.h"

#include "core/evaluation/shown_volume.h"
#include "editor/picture/ink_curves.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {

std::vector<gpu::Curve> VolumeLines::lines_of(const EvaluatedObject& object,
                                              const glm::dmat4& to_world, const Camera& camera,
                                              float wider)
{
    std::vector<gpu::Curve> out;
    const ShownVolume& volume = *object.shape->volume;
    const VoxelField& field = *volume.field;
    const glm::dmat4 voxels_to_world = to_world * volume.to_model;
    const DrawingView view = drawing_view(camera, voxels_to_world, field.field().size());
    std::vector<DrawnLevel> levels = volume.drawn_levels();
    LevelDrawingOptions options;
    if (std::ranges::any_of(levels, [](const DrawnLevel& each) { return each.more.amount < 1; })) {
        Memory& memory = memories_[object.id];
        // A level is known by its place, since its name may change with its value.
        for (std::size_t i = 0; i < levels.size(); ++i) levels[i].name = fmt::format("{}", i);
        options.ids = [&](const std::string& layer) -> LineIds& { return memory.ids[layer]; };
        options.kept = [&](const std::string& layer) -> std::vector<std::uint64_t>& {
            return memory.kept[layer];
        };
    } else
        memories_.erase(object.id);
    const LevelDrawing drawing = draw_levels(field.field(), field.hulls(), levels, view, options);
    for (const DrawingLayer& layer : drawing.layers)
        add_curves(out, layer.lines, {voxels_to_world, view.to_image, object.id, wider});
    return out;
}

const std::vector<gpu::Curve>& VolumeLines::operator()(const EvaluatedObject& object,
                                                       const glm::dmat4& to_world,
                                                       const Camera& camera, float wider)
{
    static const std::vector<gpu::Curve> none;
    if (!object.shape || !object.shape->volume) return none;
    return known_({object.shape->volume, to_world, camera, object.id},
                  [&] { return lines_of(object, to_world, camera, wider); });
}

} // namespace trivar
