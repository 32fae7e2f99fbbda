// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/picture/picture.h"

#include "core/document/drawn_lines.h"
#include "core/stages/shown_volume.h"
#include "editor/picture/curves_picture.h"
#include "editor/picture/volume_casts.h"
#include "editor/picture/volume_picture.h"
#include "gpu/look.h"
#include "ui/camera_control.h"

#include <algorithm>
#include <iterator>

namespace trivar {

namespace {

constexpr float curve_width_px = 1.6f; // in a picture of the usual height

std::optional<gpu::ValueColors> colors_of(ColorBy by)
{
    if (by == ColorBy::material || by == ColorBy::uv_checker) return std::nullopt;
    if (by == ColorBy::stretch || by == ColorBy::uv_areas) return gpu::ValueColors{};
    return gpu::ValueColors{.diverging = false,
                            .range = by == ColorBy::error ? shown_errors : shown_uv_angles};
}

Ref<std::vector<float>> values_of(const EvaluatedObject& object, std::size_t part,
                                  const Document& document, ShownValues& values)
{
    const ColorBy by = document.render->color_by;
    if (by == ColorBy::material || by == ColorBy::uv_checker) return nullptr;
    if (by == ColorBy::uv_angles) return values.uvs_of(object, part, UvMeasure::angles);
    if (by == ColorBy::uv_areas) return values.uvs_of(object, part, UvMeasure::areas);
    if (by == ColorBy::stretch) return values.stretch_of(object.parts[part]);
    const auto cause = document.objects.find(object.id);
    if (cause == document.objects.end()) return nullptr; // deleted since it was evaluated
    return values.error_of(object, part, cause->second->refining.value_or(Refining{}));
}

// Returns the line drawing of an object; no value: it has none, or was deleted since it was
// evaluated.
std::optional<LineDrawing> line_drawing(const Document& document, Id id)
{
    const auto own = document.objects.find(id);
    return own != document.objects.end() ? drawn_lines(*own->second) : std::nullopt;
}

} // namespace

float wider_lines(const Camera& camera)
{
    constexpr double usual_height_px = 720;
    return static_cast<float>(std::max(1.0, camera.size_px.y / usual_height_px));
}

gpu::Picture picture_of(const Evaluation& evaluated, const Document& document, const Camera& camera,
                        ShownValues& values, gpu::DeformBy by)
{
    gpu::Picture picture;
    picture.camera = camera;
    picture.settings = *document.render;
    picture.deform_by = by;
    picture.value_colors = colors_of(document.render->color_by);
    const float wider = wider_lines(camera);
    for (const auto& [id, ref] : evaluated.objects) {
        std::vector<gpu::Instance> instances;
        for (std::size_t p = 0; p < ref->parts.size(); ++p) {
            const Part& part = ref->parts[p];
            gpu::Instance instance;
            instance.to_world = part.to_world;
            instance.materials = ref->materials;
            instance.id = id;
            instance.part = part.key;
            if (part.drawn_from_tiles()) {
                instance.mesh = part.tiles->model->mesh;
                instance.tiles = part.tiles;
            } else if (by != gpu::DeformBy::processor) {
                instance.mesh = part.rest;
                instance.posed = part.posed;
                instance.rest = part.before_split;
                if (part.bent) {
                    instance.stages = {{part.bent->volume, part.bent->embedding}};
                    instance.to_world = glm::dmat4(1);
                }
            } else {
                instance.mesh = part.mesh();
                instance.rest = part.before_split;
                if (part.bent || part.posed) instance.rest = part.rest;
            }
            instance.values = values_of(*ref, p, document, values);
            if (document.render->color_by == ColorBy::uv_checker && instance.mesh &&
                !instance.mesh->uvs.empty() && ref->materials)
                instance.materials = values.checkered(ref->materials->size());
            instances.push_back(std::move(instance));
        }
        if (const std::optional<LineDrawing> drawing = line_drawing(document, id))
            draw_on(instances, *drawing);
        std::ranges::move(instances, std::back_inserter(picture.instances));
    }
    picture.curves = values.lines(evaluated, document, camera, wider);
    for (const auto& [id, ref] : evaluated.objects)
        for (gpu::Curve& curve : curves_of(*ref, curve_width_px * wider))
            picture.curves.push_back(std::move(curve));
    for (const auto& [id, ref] : evaluated.objects) {
        const auto own = document.objects.find(id);
        if (own == document.objects.end() || own->second->stroke) continue; // deleted, or bent
        if (std::optional<gpu::CastVolume> cast = cast_volume_of(*ref))
            picture.volumes.push_back(std::move(*cast));
    }
    if (document.render->volumes) {
        const ui::Palette color = ui::palette_of({.light = !gpu::is_dark(document.render->look)});
        add_volumes(picture, evaluated, document, values.tetrahedra_lines, color, wider);
    }
    return picture;
}

void add_points(std::vector<glm::dvec3>& points, const EvaluatedObject& object)
{
    for (const Part& part : with_points(object.parts, object.curves)) {
        if (part.drawn_from_tiles()) {
            for (const glm::dvec3& p : outer_points(*part.tiles->model, *part.tiles->tiles))
                points.emplace_back(part.to_world * glm::dvec4(p, 1));
            continue;
        }
        for (const glm::vec3& p : part.mesh()->positions)
            points.emplace_back(part.to_world * glm::dvec4(p, 1));
    }
    if (!object.shape || !object.shape->volume) return;
    // Corners of a box stand out before the nearest points; surfaces say where these are.
    if (!object.has_no_geometry() && !object.shape->volume->casting) return;
    for (const glm::dvec3& p : object.shape->volume->seen_corners(object.own_to_world))
        points.push_back(p);
}

void add_seen_points(std::vector<glm::dvec3>& points, const EvaluatedObject& object)
{
    add_points(points, object);
    if (!object.has_no_geometry() || !object.placement) return;
    const Ref<Lattice> cage = object.seen_cage();
    const Lattice& volume = *cage;
    const std::array<Knots, 3>& axes = volume.displacement.axes;
    for (int i = 0; i < axes[0].count(); ++i)
        for (int j = 0; j < axes[1].count(); ++j)
            for (int k = 0; k < axes[2].count(); ++k)
                points.push_back(control_point(volume, i, j, k));
}

std::vector<glm::dvec3> points_of(const Evaluation& evaluated, const std::vector<Id>& hidden_here)
{
    std::vector<glm::dvec3> points;
    for (const auto& [id, object] : evaluated.objects)
        if (!std::ranges::binary_search(hidden_here, id)) add_seen_points(points, *object);
    return points;
}

Camera picture_camera(const Evaluation& evaluated, const Document& document, glm::ivec2 size_px)
{
    const auto kept = document.kept_views.find("picture");
    if (kept != document.kept_views.end()) return ui::reshaped(kept->second, size_px);
    Camera camera;
    camera.size_px = size_px;
    std::vector<glm::dvec3> all;
    for (const auto& [id, ref] : evaluated.objects) add_points(all, *ref);
    return ui::framed(ui::seen_from(camera, glm::normalize(glm::dvec3(0.45, -1, 0.55))), all);
}

} // namespace trivar
