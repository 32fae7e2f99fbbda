// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/picture/object_lines.h"

#include "core/lines/line_budget.h"
#include "editor/picture/ink_curves.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/color_space.hpp>

namespace trivar {
namespace {

constexpr std::size_t kept_meshes = 32;
constexpr float toward_eye = 3e-3f; // of the size

// Moves seen lines toward the eye, so that the surface that they lie on hides no half of them.
void lift(std::vector<Stroke>& strokes, const ViewPoint& from, float distance)
{
    for (Stroke& stroke : strokes)
        for (StrokePoint& p : stroke.points)
            if (!stroke.hidden)
                p.p -= distance * glm::vec3(glm::normalize(from.sight(glm::dvec3(p.p))));
}

// What of a matrix changes angles: nothing of a similarity, else all of it but the place.
glm::dmat3 stretch_of(const glm::dmat4& to_world)
{
    constexpr double alike = 1e-6;
    const glm::dmat3 own(to_world);
    const glm::dmat3 square = glm::transpose(own) * own;
    const double scale = square[0][0];
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (std::abs(square[i][j] - (i == j ? scale : 0)) > alike * scale) return own;
    return glm::determinant(own) > 0 ? glm::dmat3(1) : own;
}

} // namespace

const std::vector<gpu::Curve>& ObjectLines::operator()(const EvaluatedObject& object,
                                                       const LineDrawing& drawing,
                                                       const Camera& camera, float wider)
{
    PartPlaces places;
    for (const Part& part : object.parts)
        if (!part.drawn_from_tiles()) places.push_back({part.mesh(), part.to_world});
    return known_({places, drawing, camera, object.id},
                  [&] { return lines_of(object, drawing, camera, wider); });
}

void ObjectLines::each_kind(const EvaluatedObject& object, const LineDrawing& drawing,
                            const Camera& camera, float wider, auto&& use)
{
    shapes_.keep(kept_meshes + 2 * object.parts.size());
    rays_.keep(kept_meshes + 2 * object.parts.size());
    std::vector<RayScene::Entry> entries;
    for (const Part& part : object.parts) {
        if (part.drawn_from_tiles()) continue;
        const Ref<Mesh>& mesh = part.mesh();
        entries.push_back(
            {rays_(mesh, [&] { return std::make_shared<const RayMesh>(mesh); }), part.to_world});
    }
    if (entries.empty()) return;
    const RayScene scene(std::move(entries));
    for (const Part& part : object.parts) {
        if (part.drawn_from_tiles()) continue;
        const Ref<Mesh>& mesh = part.mesh();
        const glm::dmat3 stretch = stretch_of(part.to_world);
        const glm::dmat4 to_world = part.to_world * glm::dmat4(glm::inverse(stretch));
        const Ref<ShapedMesh> shaped =
            shapes_({mesh, drawing.crease_deg, drawing.more, glm::mat3(stretch)},
                    [&] { return make_ref(shaped_mesh(*mesh, drawing, glm::mat3(stretch))); });
        Box box;
        for (const glm::vec3& p : shaped->shape.points) box.add(glm::dvec3(p));
        if (shaped->shape.points.empty()) continue;
        const DrawingView view = drawing_view(camera, to_world, box);
        std::vector<KindStrokes> found = mesh_strokes(*shaped, drawing, view, {scene, to_world});
        for (KindStrokes& each : found) {
            lift(each.strokes, view.from, toward_eye * shaped->shape.surface.size);
            const LineStyle style = style_of(each.kind, drawing);
            use(each.kind, inked(within_budget(each.strokes, drawing.more.amount), style),
                PlacedInk{to_world, view.to_image, object.id, wider});
        }
    }
}

std::vector<gpu::Curve> ObjectLines::lines_of(const EvaluatedObject& object,
                                              const LineDrawing& drawing, const Camera& camera,
                                              float wider)
{
    std::vector<gpu::Curve> out;
    each_kind(object, drawing, camera, wider,
              [&](LineKind, const std::vector<InkedLine>& lines, const PlacedInk& placed) {
                  add_curves(out, lines, placed);
              });
    return out;
}

std::vector<DrawingLayer> ObjectLines::layers(const EvaluatedObject& object,
                                              const LineDrawing& drawing, const Camera& camera)
{
    std::vector<DrawingLayer> out;
    each_kind(object, drawing, camera, 1,
              [&](LineKind kind, std::vector<InkedLine> lines, const PlacedInk&) {
                  out.push_back({std::string(words_of(kind)), std::move(lines)});
              });
    return out;
}

void ObjectLines::draw_on(std::vector<gpu::Instance>& instances, const LineDrawing& drawing)
{
    if (!drawing.surface) return instances.clear();
    if (!drawing.paper) return;
    for (gpu::Instance& instance : instances) {
        const std::size_t count =
            instance.materials ? std::max<std::size_t>(1, instance.materials->size()) : 1;
        instance.materials = papers_({count, drawing.paper_color}, [&] {
            Material paper;
            paper.base_color = {0, 0, 0, 1};
            paper.roughness = 1;
            paper.emissive = glm::convertSRGBToLinear(drawing.paper_color);
            return make_ref(std::vector<Material>(count, paper));
        });
    }
}

} // namespace trivar
