// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/picture/volume_lines.h"

#include "core/stages/shown_volume.h"
#include "editor/picture/ink_curves.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {

SeenLines lines_of(const VolumeView& view, float wider, LineProof proof, const Progress& progress,
                   LineMemory* memory)
{
    SeenLines out;
    const ShownVolume& volume = *view.volume;
    const VoxelField& field = *volume.field;
    const glm::dmat4 voxels_to_world = view.to_world * volume.to_model;
    const DrawingView drawn = drawing_view(view.camera, voxels_to_world, field.field().size());
    std::vector<DrawnLevel> levels = volume.drawn_levels();
    if (proof == LineProof::none)
        for (DrawnLevel& level : levels) level.certified_depth = -1;
    LevelDrawingOptions options{.progress = progress};
    if (memory) {
        // A level is known by its place, since its name may change with its value.
        for (std::size_t i = 0; i < levels.size(); ++i) levels[i].name = fmt::format("{}", i);
        options.ids = [&](const std::string& layer) -> LineIds& { return memory->ids[layer]; };
        options.kept = [&](const std::string& layer) -> std::vector<std::uint64_t>& {
            return memory->kept[layer];
        };
    }
    const LevelDrawing drawing = draw_levels(field.field(), field.hulls(), levels, drawn, options);
    for (const DrawingLayer& layer : drawing.layers)
        add_curves(out.curves, layer.lines, {voxels_to_world, drawn.to_image, view.id, wider});
    out.gaps = drawing.gaps;
    return out;
}

const std::vector<gpu::Curve>& VolumeLines::operator()(const EvaluatedObject& object,
                                                       const glm::dmat4& to_world,
                                                       const Camera& camera, float wider)
{
    static const std::vector<gpu::Curve> none;
    if (!object.shape || !object.shape->volume) return none;
    const VolumeView view{object.shape->volume, to_world, camera, object.id};
    for (const auto& [of, lines] : given_)
        if (of == view) return lines.curves;
    return known_(view, [&] {
        const std::vector<DrawnLevel> levels = view.volume->drawn_levels();
        const bool share = std::ranges::any_of(
            levels, [](const DrawnLevel& each) { return each.more.amount < 1; });
        if (!share) memories_.erase(object.id);
        return lines_of(view, wider, proof, {}, share ? &memories_[object.id] : nullptr).curves;
    });
}

} // namespace trivar
