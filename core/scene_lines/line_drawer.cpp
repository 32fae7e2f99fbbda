// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene_lines/line_drawer.h"

#include "core/base/mean_scale.h"
#include "core/drawing/line_list.h"
#include "core/level/voxel_field.h"
#include "core/lines/line_budget.h"
#include "core/mesh/extent.h"
#include "core/stages/shown_volume.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace trivar {
namespace {

constexpr std::size_t kept_meshes = 32;
constexpr float toward_eye = 3e-3f; // of the size
constexpr double quick_reach = 2;   // voxels between a line and the triangles of its level

// Moves seen lines toward the eye, so that the surface that they lie on hides no half of them.
void lift(std::vector<Stroke>& strokes, const ViewPoint& from, float distance)
{
    for (Stroke& stroke : strokes)
        for (StrokePoint& p : stroke.points)
            if (!stroke.hidden)
                p.p -= distance * glm::vec3(glm::normalize(from.sight(glm::dvec3(p.p))));
}

// Returns the part of a matrix that changes angles: nothing of a similarity, else all of it but the
// place.
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

void ink(ObjectLines& out, KindStrokes found, const LineDrawing& drawing, const DrawingView& view,
         const glm::dmat4& to_world, float size)
{
    lift(found.strokes, view.from, toward_eye * size);
    out.layers.push_back({{std::string(words_of(found.kind)),
                           inked(within_budget(std::move(found.strokes), drawing.more.amount),
                                 style_of(found.kind, drawing))},
                          to_world,
                          view.to_image});
}

} // namespace

struct LineDrawer::Work {
    const LineScene& scene;
    const LineOptions& options;
    SceneLines& out;
    std::vector<PlacedMeshes> meshes = {}; // of the objects
    std::optional<HidingSurfaces> surfaces = {};
    double done = 0; // share of the objects

    void tell(std::string_view what) const { report(options.progress, done, what); }
    bool is_full() const { return options.effort == LineEffort::full; }
    // Returns whether surfaces of others hide a place; none where there are no such surfaces.
    std::function<bool(const glm::dvec3&)> hidden_by_others(const HidingSurfaces::Owner& own) const
    {
        if (!surfaces || !surfaces->has_others(own)) return {};
        return [this, own](const glm::dvec3& p) { return surfaces->hide(p, own, scene.camera); };
    }
};

SceneLines LineDrawer::operator()(const LineScene& scene, const LineOptions& options)
{
    SceneLines out;
    Work work{scene, options, out};
    std::size_t parts = 0;
    for (const LineScene::Object& object : scene.objects) parts += object.effects->parts.size();
    shapes_.keep(kept_meshes + 2 * parts);
    rays_.keep(kept_meshes + 2 * parts);
    if (work.is_full()) {
        bodies_.keep(kept_meshes + 2 * scene.objects.size());
        intersections_.keep(kept_meshes + 2 * scene.objects.size());
        find_surfaces(work);
    }
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        const LineScene::Object& object = scene.objects[i];
        if (!object.has_lines()) continue;
        report(options.progress, static_cast<double>(i) / static_cast<double>(scene.objects.size()),
               "lines");
        const auto draw = [&] {
            ObjectLines lines{object.effects->id, object.name, {}, {}};
            if (!work.is_full()) {
                work.meshes.resize(scene.objects.size());
                work.meshes[i] = meshes_of(object, work);
            }
            if (object.drawing) draw_meshes(lines, i, work);
            if (object.drawing && work.is_full()) draw_intersections(lines, i, work);
            if (object.volume_to_world) draw_levels(lines, i, work);
            return make_ref(std::move(lines));
        };
        out.objects.push_back(work.is_full() ? draw() : quick_({object, scene.camera}, draw));
        out.gaps.open += out.objects.back()->gaps.open;
        out.gaps.loose_ends += out.objects.back()->gaps.loose_ends;
    }
    return out;
}

LineDrawer::PlacedMeshes LineDrawer::meshes_of(const LineScene::Object& object, Work& work)
{
    PlacedMeshes out;
    for (const Part& part : object.effects->parts) {
        PlacedMesh placed{nullptr, part.to_world, part.key.mesh};
        if (part.drawn_from_tiles()) {
            if (!work.is_full()) continue;
            const SeenTiles& tiles = tiles_({part.tiles, part.to_world, work.scene.camera}, [&] {
                return seen_tiles(*part.tiles, part.to_world, work.scene.camera);
            });
            placed.mesh = tiles.mesh;
            placed.size = tiles.tile_size;
            placed.copy_size = static_cast<float>(tiles.tile_size / mean_scale(part.to_world));
            if (object.drawing && tiles.drawn < tiles.all)
                work.out.notices.push_back(
                    fmt::format("{}: the lines of {} of its {} tiles are drawn; the others are "
                                "outside the picture, too small in it, or too many",
                                object.name, tiles.drawn, tiles.all));
        } else {
            placed.mesh = part.mesh();
            placed.size =
                mean_scale(part.to_world) * glm::length(bounding_box(*placed.mesh).size());
        }
        out.push_back(std::move(placed));
    }
    return out;
}

RayScene::Entry LineDrawer::entry_of(const PlacedMesh& placed)
{
    return {rays_(placed.mesh, [&] { return std::make_shared<const RayMesh>(placed.mesh); }),
            placed.to_world};
}

void LineDrawer::find_surfaces(Work& work)
{
    std::vector<HidingSurfaces::Surface> surfaces;
    for (const LineScene::Object& object : work.scene.objects) {
        work.tell("surfaces");
        work.meshes.push_back(meshes_of(object, work));
        if (object.drawing && !object.drawing->surface) continue;
        const bool paper = object.drawing && object.drawing->paper;
        for (const PlacedMesh& placed : work.meshes.back())
            surfaces.push_back({entry_of(placed).mesh, placed.to_world, object.effects->id,
                                placed.number, placed.size,
                                paper ? nullptr : object.effects->materials});
    }
    if (!surfaces.empty()) work.surfaces.emplace(std::move(surfaces));
}

void LineDrawer::draw_meshes(ObjectLines& out, std::size_t number, Work& work)
{
    const LineDrawing& drawing = *work.scene.objects[number].drawing;
    std::vector<RayScene::Entry> entries;
    for (const PlacedMesh& placed : work.meshes[number]) entries.push_back(entry_of(placed));
    if (entries.empty()) return;
    const RayScene scene(std::move(entries));
    for (const PlacedMesh& placed : work.meshes[number]) {
        work.tell(out.name);
        const glm::dmat3 stretch = stretch_of(placed.to_world);
        const glm::dmat4 to_world = placed.to_world * glm::dmat4(glm::inverse(stretch));
        const Ref<ShapedMesh> shaped =
            shapes_({placed.mesh, drawing.crease_deg, drawing.more, glm::mat3(stretch)}, [&] {
                return make_ref(
                    shaped_mesh(*placed.mesh, drawing, glm::mat3(stretch), placed.copy_size));
            });
        Box box;
        for (const glm::vec3& p : shaped->shape.points) box.add(glm::dvec3(p));
        if (box.empty()) continue;
        const DrawingView view = drawing_view(work.scene.camera, to_world, box);
        const HidingBodies bodies{scene, to_world,
                                  work.hidden_by_others({out.object, {}, placed.size})};
        for (KindStrokes& each : mesh_strokes(*shaped, drawing, view, bodies))
            ink(out, std::move(each), drawing, view, to_world, shaped->shape.surface.size);
    }
}

void LineDrawer::draw_levels(ObjectLines& out, std::size_t number, Work& work)
{
    const LineScene::Object& object = work.scene.objects[number];
    const ShownVolume& volume = *object.effects->shape->volume;
    const VoxelField& field = *volume.field;
    const glm::dmat4 to_world = *object.volume_to_world * volume.to_model;
    const DrawingView view = drawing_view(work.scene.camera, to_world, field.field().size());
    LevelDrawingOptions options{.hide_each_other = work.options.levels_hide_each_other,
                                .certified_depth = work.options.certified_depth,
                                .dash_rows = work.options.dash_rows,
                                .progress = part_of(work.options.progress, work.done, 1)};
    std::vector<DrawnLevel> levels = volume.drawn_levels();
    std::vector<std::string> names;
    for (const DrawnLevel& level : levels) names.push_back(level.name);
    if (work.options.ids) {
        names = names_apart(std::move(names));
        options.ids = [&](const std::string& layer) -> LineIds& {
            return work.options.ids(object.name, layer);
        };
    } else if (std::ranges::any_of(levels,
                                   [](const DrawnLevel& each) { return each.more.amount < 1; })) {
        // A level is known by its place, since its name may change with its value.
        for (std::size_t i = 0; i < names.size(); ++i) names[i] = fmt::format("{}", i);
        LineMemory& memory = memories_[out.object];
        options.ids = [&](const std::string& layer) -> LineIds& { return memory.ids[layer]; };
        options.kept = [&](const std::string& layer) -> std::vector<std::uint64_t>& {
            return memory.kept[layer];
        };
    } else {
        memories_.erase(out.object);
    }
    const double size = mean_scale(to_world) * glm::length(glm::dvec3(field.field().size() - 1));
    std::size_t next = 0;
    bool quick_beside_others = false; // which alone the depth of a picture hides from them
    for (const ShownVolume::Level& level : volume.levels) {
        if (!level.lines) continue;
        quick_beside_others |= !work.is_full() && shows_others(volume, level.surface);
        DrawnLevel& drawn = levels[next];
        drawn.name = names[next++];
        if (!work.is_full()) drawn.certified_depth = -1;
        if (const auto hidden = work.hidden_by_others({out.object, level.surface, size}))
            drawn.hidden_by_others = [hidden, to_world](const glm::vec3& p) {
                return hidden(glm::dvec3(to_world * glm::dvec4(glm::dvec3(p), 1)));
            };
    }
    LevelDrawing drawing = trivar::draw_levels(field.field(), field.hulls(), levels, view, options);
    for (DrawingLayer& layer : drawing.layers) {
        out.layers.push_back({std::move(layer), to_world, view.to_image});
        if (quick_beside_others) out.layers.back().own_reach = quick_reach * mean_scale(to_world);
    }
    out.gaps = drawing.gaps;
}

Ref<TriangleBody> LineDrawer::body_of(const PlacedMeshes& meshes)
{
    return bodies_(meshes, [&] {
        std::vector<std::pair<Ref<Mesh>, glm::dmat4>> all;
        for (const PlacedMesh& each : meshes) all.emplace_back(each.mesh, each.to_world);
        return make_ref(triangle_body(all));
    });
}

Ref<IntersectionLines> LineDrawer::intersections(const PlacedMeshes& a, const PlacedMeshes& b)
{
    return intersections_({a, b}, [&] {
        const Ref<TriangleBody> first = body_of(a), second = body_of(b);
        return make_ref(a == b ? intersection_lines(*first) : intersection_lines(*first, *second));
    });
}

void LineDrawer::draw_intersections(ObjectLines& out, std::size_t number, Work& work)
{
    const auto& objects = work.scene.objects;
    const LineDrawing& drawing = *objects[number].drawing;
    const PlacedMeshes& own = work.meshes[number];
    if (!drawing.intersections || own.empty()) return;
    std::vector<RayScene::Entry> entries;
    double size = 0;
    for (const PlacedMesh& placed : own) {
        entries.push_back(entry_of(placed));
        size = std::max(size, placed.size);
    }
    const RayScene scene(std::move(entries));
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const std::optional<LineDrawing>& other = objects[i].drawing;
        // Two objects that both want them have them once.
        if (work.meshes[i].empty() || (other && i < number && other->intersections) ||
            (other && i != number && !other->surface))
            continue;
        work.tell("intersections");
        const Ref<IntersectionLines> found = intersections(own, work.meshes[i]);
        if (found->lines.count() == 0) continue;
        Box box;
        for (const SilhouettePoint& p : found->lines.points) box.add(glm::dvec3(p.p));
        glm::dmat4 to_world(1);
        to_world[3] = glm::dvec4(found->origin, 1);
        const DrawingView view = drawing_view(work.scene.camera, to_world, box);
        const HidingBodies bodies{scene, to_world, work.hidden_by_others({out.object, {}, size})};
        const auto length = static_cast<float>(size);
        ink(out, {LineKind::intersections, intersection_strokes(*found, length, view, bodies)},
            drawing, view, to_world, length);
    }
}

} // namespace trivar
