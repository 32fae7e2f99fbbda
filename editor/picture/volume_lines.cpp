// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/picture/volume_lines.h"

#include "core/evaluation/shown_volume.h"
#include "core/silhouette/fans.h"
#include "core/silhouette/level_drawing.h"

#include <glm/gtc/color_space.hpp>

namespace trivar {
namespace {

gpu::Curve curve_of(const InkedLine& line, const glm::dmat4& to_world, int id, float wider)
{
    Polyline points;
    float width = 0;
    for (const InkedLine::Point& p : line.points) width = std::max(width, p.width);
    for (const InkedLine::Point& p : line.points) {
        points.points.push_back(p.p);
        points.colors.emplace_back(glm::convertSRGBToLinear(p.color), line.opacity);
        points.widths.push_back(p.width / width);
    }
    return {.line = make_ref(std::move(points)),
            .to_world = to_world,
            .style = {.width_px = width * wider,
                      .hidden = !line.hidden  ? gpu::HiddenParts::left_out
                                : line.dashed ? gpu::HiddenParts::dashed
                                              : gpu::HiddenParts::faint},
            .id = id};
}

// Puts the points of lines in space where the ink of a hand is that left the line in the picture.
void follow_the_ink(std::vector<InkedLine>& lines, const glm::dmat4& to_image)
{
    const glm::dmat4 to_voxels = glm::inverse(to_image);
    for (InkedLine& line : lines)
        for (InkedLine::Point& p : line.points) {
            const glm::dvec4 seen = to_image * glm::dvec4(p.p, 1);
            const glm::dvec4 there = to_voxels * glm::dvec4(glm::dvec2(p.at), seen.z / seen.w, 1);
            p.p = glm::vec3(glm::dvec3(there) / there.w);
        }
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
        const std::array<std::vector<Stroke>, 2> strokes =
            level_strokes(field, volume.field->hulls(), drawn, view);
        const LevelBody body{field, volume.field->hulls(), level.mesh->level, volume.side};
        for (const std::vector<Stroke>& kind : strokes) {
            std::vector<InkedLine> lines = inked_with_fans(body, kind, level.ink, view.to_image);
            if (level.ink.wobble > 0 || level.ink.pencil > 0) follow_the_ink(lines, view.to_image);
            for (const InkedLine& line : lines)
                if (line.points.size() > 1)
                    out.push_back(curve_of(line, voxels_to_world, id, wider));
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
