// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/picture/volume_lines.h"

#include "core/evaluation/shown_volume.h"
#include "core/silhouette/level_drawing.h"

#include <glm/gtc/color_space.hpp>

namespace trivar {
namespace {

gpu::Curve curve_of(const InkedLine& line, const Stroke& stroke, const glm::dmat4& to_world,
                    const LineStyle& ink, int id, float wider)
{
    Polyline points;
    float width = 0;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        points.points.push_back(stroke.points[i].p);
        points.colors.emplace_back(glm::convertSRGBToLinear(line.points[i].color), line.opacity);
        width = std::max(width, line.points[i].width);
    }
    const auto length = static_cast<float>(stroke.length());
    const float taper = length > 0 ? std::min(0.35f, ink.taper / length) : 0;
    return {.line = make_ref(std::move(points)),
            .to_world = to_world,
            .style = {.width_px = width * wider,
                      .taper = {stroke.tapers_first ? taper : 0, stroke.tapers_last ? taper : 0},
                      .hidden = !line.hidden  ? gpu::HiddenParts::left_out
                                : line.dashed ? gpu::HiddenParts::dashed
                                              : gpu::HiddenParts::faint},
            .id = id};
}

std::vector<gpu::Curve> lines_of(const ShownVolume& volume, int id, const glm::dmat4& to_world,
                                 const Camera& camera, float wider)
{
    std::vector<gpu::Curve> out;
    const ScalarField<float>& field = volume.field->field();
    const glm::dmat4 voxels_to_world = to_world * volume.to_model;
    const DrawingView view = drawing_view(camera, voxels_to_world, field.size());
    for (const ShownVolume::Level& level : volume.levels) {
        if (!level.lines) continue;
        const DrawnLevel drawn{level.name, *level.mesh, volume.side, level.ink};
        for (const std::vector<Stroke>& strokes :
             level_strokes(field, volume.field->hulls(), drawn, view)) {
            for (const InkedLine& line : inked(strokes, level.ink))
                out.push_back(
                    curve_of(line, strokes[line.stroke], voxels_to_world, level.ink, id, wider));
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
