// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/scene.h"

#include "core/base/finite.h"
#include "core/base/mean_scale.h"
#include "core/mesh/filling_colors.h"
#include "gpu/to_scene.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

namespace trivar::gpu {
namespace {

bool drawable(const Box& box)
{
    // Beyond this single precision has no squares left to compute with.
    constexpr double limit = 1e15;
    for (int i = 0; i < 3; ++i)
        if (!(box.lo[i] > -limit && box.hi[i] < limit)) return false;
    return !box.empty();
}

// Whether its undeformed mesh is known, with the same vertices and faces.
bool has_rest(const Instance& instance)
{
    return instance.rest && instance.rest->vertex_count() == instance.mesh->vertex_count() &&
           instance.rest->face_count() == instance.mesh->face_count() &&
           instance.rest->corners.size() == instance.mesh->corners.size();
}

Box box_of(const Instance& instance, Mirror& mirror, const DeformedMesh* deformed)
{
    const bool some = instance.mesh && instance.mesh->face_count() > 0;
    if (!some || instance.opacity <= 0) return {};
    const Box box =
        instance.tiles    ? instance.to_world == glm::dmat4(1)
                                ? instance.tiles->box
                                : transformed(instance.tiles->box, instance.to_world)
           : !deformed ? mirror.box_world(instance.mesh, instance.to_world, instance.copies)
        : instance.copies ? transformed(deformed->box, instance.to_world, *instance.copies)
                          : transformed(deformed->box, instance.to_world);
    return drawable(box) ? box : Box{};
}

Box box_of(const Curve& curve)
{
    Box box;
    for (std::size_t i = 0; curve.line && i < curve.line->points.size(); ++i) {
        const glm::dvec3 p(curve.to_world * glm::dvec4(curve.line->points[i], 1));
        if (finite(p)) box.add(p);
    }
    return drawable(box) ? box : Box{};
}

Box box_of(const CastVolume& volume)
{
    Box box;
    if (!volume.data || !glm::all(glm::lessThan(volume.low, volume.high))) return box;
    if (!(std::abs(glm::determinant(glm::dmat3(volume.to_world))) > 0)) return box;
    for (const glm::dvec3& corner : Box{volume.low, volume.high}.corners()) {
        const glm::dvec3 p(volume.to_world * glm::dvec4(corner, 1));
        if (!finite(p)) return {};
        box.add(p);
    }
    return drawable(box) ? box : Box{};
}

CastItem item_of(const CastVolume& volume, const glm::dvec3& origin_world,
                 const MirroredVolume* mirrored)
{
    glm::dmat4 to_scene = volume.to_world;
    to_scene[3] -= glm::dvec4(origin_world, 0);
    const double edge = mean_scale(to_scene);
    const glm::dmat4 to_voxels = glm::inverse(to_scene);
    CastItem item{volume.data, mirrored, volume.id, to_voxels, {}, {}};
    item.view.low = glm::vec4(volume.low, 0);
    item.view.high = glm::vec4(volume.high, 0);
    item.view.look = {volume.density / edge, volume.shading, 0, 0};
    item.view.to_normals = glm::transpose(glm::dmat3(to_voxels)) * edge;
    const auto corners = Box{volume.low, volume.high}.corners();
    for (std::size_t i = 0; i < corners.size(); ++i)
        item.corners[i] = to_scene * glm::dvec4(corners[i], 1);
    return item;
}

// An instance, or what all that is drawn of it has in common.
SceneItem item_of(const Instance& instance, const Picture& picture, const Box& box,
                  const glm::dvec3& origin_world, Mirror& mirror, const DeformedMesh* deformed)
{
    SceneItem item{};
    item.mesh = deformed ? &deformed->mirrored : &mirror.mesh(instance.mesh);
    const Ref<Mesh>& faces = has_rest(instance) && !deformed ? instance.rest : instance.mesh;
    item.edges = !picture.settings.wire ? nullptr
                 : deformed             ? &deformed->edges
                                        : &mirror.edges(instance.mesh, faces);
    item.deformed_as_drawn = deformed && deformed->stage ? deformed : nullptr;
    item.materials = instance.materials;
    const glm::dvec3 mesh_origin = deformed ? deformed->origin_world : glm::dvec3(0);
    const ToScene there = to_scene(instance.to_world, mesh_origin, origin_world);
    item.to_scene = there.points;
    item.normal_to_scene = there.normals;
    item.mirrored = there.mirrors;
    item.id = instance.id;
    item.opacity = glm::clamp(instance.opacity, 0.0f, 1.0f);
    item.flat_color = instance.flat_color;
    item.casts = !item.flat_color;
    item.lo = box.lo - origin_world;
    item.hi = box.hi - origin_world;
    item.extent = glm::length(item.hi - item.lo);
    const bool shows_values = picture.value_colors && instance.values &&
                              instance.values->size() == instance.mesh->vertex_count();
    item.values = shows_values ? &mirror.values(instance.values) : nullptr;
    const auto is_filled = [](const Material& m) { return m.filling != Filling::none; };
    if (instance.materials && std::ranges::any_of(*instance.materials, is_filled)) {
        const Ref<Mesh>& rest = faces;
        const Box at_rest = mirror.box_world(rest, glm::dmat4(1));
        const double radius = glm::length(at_rest.size()) / 2;
        item.rest = &mirror.mesh(rest).buffers.front();
        item.rest_middle = glm::vec4(at_rest.center(), radius > 0 ? 1 / radius : 1);
        item.turned_about = turning_axis(at_rest);
    }
    return item;
}

// An item of copies for those that leave faces as they are, and one for those that mirror.
void add_copies(std::vector<SceneItem>& items, SceneItem item, const MirroredCopies& copies,
                bool picture_shows_values)
{
    item.copies = &copies;
    item.values_by_copy = picture_shows_values && !item.values && copies.valued;
    item.mirrored = false;
    item.copy_count = copies.upright;
    if (copies.upright > 0) items.push_back(item);
    item.mirrored = true;
    item.first_copy = copies.upright;
    item.copy_count = copies.mirrored;
    if (copies.mirrored > 0) items.push_back(item);
}

std::vector<Copy> outlined_copies(const Instance& instance)
{
    std::vector<Copy> out;
    for (const std::uint32_t i : instance.outlined_copies)
        if (i < instance.copies->size()) out.push_back((*instance.copies)[i]);
    return out;
}

// An item for the tiles of each level that are seen, and one for those that cast shadows.
void add_tiles(Scene& scene, const Instance& instance, const Picture& picture, const Box& box,
               Mirror& mirror, const DrawnTiles& tiles)
{
    const auto item_with = [&](const Ref<Mesh>& mesh, const MirroredCopies& copies) {
        Instance level = instance;
        level.mesh = mesh;
        level.rest = nullptr;
        level.values = nullptr;
        SceneItem item = item_of(level, picture, box, scene.origin_world, mirror, nullptr);
        const glm::dvec3& origin = tiles.patches->origin();
        const ToScene there = to_scene(instance.to_world, origin, scene.origin_world);
        item.to_scene = there.points;
        item.normal_to_scene = there.normals;
        if (item.rest) {
            const double radius = glm::length(instance.tiles->box.size()) / 2;
            item.rest_middle =
                glm::vec4(instance.tiles->box.center() - origin, radius > 0 ? 1 / radius : 1);
            item.turned_about = turning_axis(instance.tiles->box);
        }
        item.extent = static_cast<float>(tiles.size);
        item.copies = &copies;
        item.copy_count = copies.upright;
        return item;
    };
    const auto first = static_cast<std::ptrdiff_t>(scene.items.size());
    for (const DrawnTiles::Level& level : tiles.levels)
        if (level.chosen > 0) {
            scene.items.push_back(item_with(level.mesh, level.seen));
            scene.items.back().casts = false;
        }
    if (instance.highlighted) {
        scene.outlined.insert(scene.outlined.end(), scene.items.begin() + first, scene.items.end());
        if (tiles.footprints.upright > 0)
            scene.outlined.push_back(item_with(tiles.footprint, tiles.footprints));
    }
    for (const DrawnTiles::Level& level : tiles.levels)
        if (level.casting.upright > 0 && !instance.flat_color) {
            scene.items.push_back(item_with(level.mesh, level.casting));
            scene.items.back().seen = false;
        }
}

// Adds the drawn items of an instance, and those of its outline.
void add_instance(Scene& scene, const Instance& instance, const Picture& picture, const Box& box,
                  Mirror& mirror, const DeformedMesh* deformed)
{
    SceneItem item = item_of(instance, picture, box, scene.origin_world, mirror, deformed);
    const auto first = static_cast<std::ptrdiff_t>(scene.items.size());
    const bool values = picture.value_colors.has_value();
    const CopiesAt at{instance.to_world, deformed ? deformed->origin_world : glm::dvec3(0),
                      scene.origin_world};
    const Box own = !instance.copies ? Box{}
                    : deformed       ? deformed->box
                                     : mirror.box_world(instance.mesh, glm::dmat4(1));
    if (instance.copies) {
        const MirroredCopies& copies = mirror.copies(instance.copies, at);
        const double size = mean_scale(instance.to_world);
        item.extent = static_cast<float>(glm::length(own.size()) * size * copies.scale);
        add_copies(scene.items, item, copies, values);
    } else {
        scene.items.push_back(item);
    }
    if (instance.highlighted) {
        scene.outlined.insert(scene.outlined.end(), scene.items.begin() + first, scene.items.end());
    } else if (instance.copies && !instance.outlined_copies.empty()) {
        const std::vector<Copy> some = outlined_copies(instance);
        const Box there = transformed(own, instance.to_world, some);
        if (!drawable(there)) return;
        item.lo = there.lo - scene.origin_world;
        item.hi = there.hi - scene.origin_world;
        scene.own_copies.push_back(std::make_shared<const MirroredCopies>(uploaded(some, at)));
        add_copies(scene.outlined, item, *scene.own_copies.back(), values);
    }
}

} // namespace

const Material& SceneItem::material(std::uint32_t index) const
{
    static const Material plain;
    return materials && index < materials->size() ? (*materials)[index] : plain;
}

bool SceneItem::see_through(const MirroredMesh::Part& part) const
{
    return opacity < 1 || material(part.material).alpha == Material::Alpha::blend;
}

int SceneItem::drawn_count() const
{
    return !copies ? 1 : copies->patches ? copies->upright : copy_count;
}

bool SceneItem::is_body() const
{
    return mesh->faces->closed && opacity >= 1 &&
           std::ranges::all_of(mesh->parts(), [&](const MirroredMesh::Part& part) {
               return material(part.material).alpha == Material::Alpha::opaque;
           });
}

CasterKey casters_of(const Scene& scene)
{
    CasterKey key;
    key.ground_z = scene.ground_z;
    for (const SceneItem& item : scene.items)
        if (item.opacity >= 1 && item.casts)
            key.casters.push_back({item.mesh->serial, item.to_scene, item.materials,
                                   item.copies ? item.copies->serial : 0, item.first_copy});
    return key;
}

Scene scene_of(const Picture& picture, Mirror& mirror, const DeformedMeshes& deformed,
               const TileMirror& tiles, VolumeMirror* volumes)
{
    Scene scene;
    std::vector<Box> boxes;
    Box all, standing;
    for (std::size_t i = 0; i < picture.instances.size(); ++i) {
        const Instance& instance = picture.instances[i];
        boxes.push_back(box_of(instance, mirror, deformed.of(i)));
        all.add(boxes.back());
        if (instance.opacity >= 1) standing.add(boxes.back());
    }
    for (const Curve& curve : picture.curves)
        if (const Box box = box_of(curve); !box.empty()) {
            scene.curve_boxes.push_back(box);
            all.add(box);
            standing.add(box);
        }
    for (const CastVolume& volume : picture.volumes)
        if (const Box box = box_of(volume); !box.empty()) {
            all.add(box);
            standing.add(box);
        }
    if (all.empty()) return scene;
    scene.origin_world = all.center();
    scene.lo = all.lo - scene.origin_world;
    scene.hi = all.hi - scene.origin_world;
    scene.radius = std::max(static_cast<float>(glm::length(all.size())) / 2, 1e-6f);
    // A ghost that dips lower while it is moved does not pull the ground along.
    scene.ground_z =
        static_cast<float>((standing.empty() ? all : standing).lo.z - scene.origin_world.z);
    // Where the grid shows Z 0, what hovers has its shadow there.
    if (picture.grid)
        scene.ground_z = std::min(scene.ground_z, static_cast<float>(-scene.origin_world.z));
    for (std::size_t i = 0; i < boxes.size(); ++i)
        if (boxes[i].empty())
            continue;
        else if (const DrawnTiles* drawn = tiles.of(i))
            add_tiles(scene, picture.instances[i], picture, boxes[i], mirror, *drawn);
        else if (picture.instances[i].tiles) {
            Instance whole = picture.instances[i];
            whole.mesh = *std::exchange(whole.tiles, nullptr)->mesh;
            add_instance(scene, whole, picture, boxes[i], mirror, nullptr);
        } else
            add_instance(scene, picture.instances[i], picture, boxes[i], mirror, deformed.of(i));
    for (const CastVolume& volume : picture.volumes) {
        if (box_of(volume).empty()) continue;
        const MirroredVolume* mirrored =
            volumes ? volumes->volume(volume.data, !picture.draft) : nullptr;
        if (!volumes || mirrored)
            scene.volumes.push_back(item_of(volume, scene.origin_world, mirrored));
    }
    const glm::dmat4 view = view_matrix(picture.camera);
    std::ranges::stable_sort(scene.volumes, {}, [&](const CastItem& item) {
        const glm::dvec3 middle(item.corners[0] + item.corners[6]);
        return (view * glm::dvec4(scene.origin_world + middle / 2.0, 1)).z;
    });
    const ValueColors values = picture.value_colors.value_or(ValueColors{});
    scene.map_colors = map_colors(values);
    const float length = values.range.y - values.range.x;
    scene.map_range = {values.range.x, length > 0 ? 1 / length : 1, values.ratios ? 1 : 0, 0};
    return scene;
}

} // namespace trivar::gpu
