// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/scene.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

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

// The box of a box.
Box transformed(const Box& box, const glm::dmat4& matrix)
{
    Box out;
    for (int k = 0; k < 8 && !box.empty(); ++k) {
        const glm::dvec3 p((k & 1 ? box.hi : box.lo).x, (k & 2 ? box.hi : box.lo).y,
                           (k & 4 ? box.hi : box.lo).z);
        out.add(glm::dvec3(matrix * glm::dvec4(p, 1)));
    }
    return out;
}

// Whether what it was before it was deformed is known, with the same vertices and faces.
bool has_rest(const Instance& instance)
{
    return instance.rest && instance.rest->vertex_count() == instance.mesh->vertex_count() &&
           instance.rest->face_count() == instance.mesh->face_count() &&
           instance.rest->corners.size() == instance.mesh->corners.size();
}

SceneItem item_of(const Instance& instance, const Picture& picture, const Box& box,
                  const glm::dvec3& origin_world, Mirror& mirror, const DeformedMesh* deformed)
{
    SceneItem item;
    item.mesh = deformed ? &deformed->mirrored : &mirror.mesh(instance.mesh);
    const Ref<Mesh>& faces = has_rest(instance) && !deformed ? instance.rest : instance.mesh;
    item.edges = !picture.settings.wire ? nullptr
                 : deformed             ? &deformed->edges
                                        : &mirror.edges(instance.mesh, faces);
    item.deformed_as_drawn = deformed && deformed->stage ? deformed : nullptr;
    item.materials = instance.materials;
    glm::dmat4 to_scene = instance.to_world;
    if (deformed) to_scene = glm::translate(to_scene, deformed->origin_world);
    to_scene[3] -= glm::dvec4(origin_world, 0);
    item.to_scene = to_scene;
    const glm::dmat3 linear(to_scene);
    const double volume = glm::determinant(linear);
    // Cofactors turn normals right even where the matrix is flat; a mirror flips their sign.
    const glm::dmat3 cofactors(glm::cross(linear[1], linear[2]), glm::cross(linear[2], linear[0]),
                               glm::cross(linear[0], linear[1]));
    const double size = std::cbrt(std::abs(volume)) + 1e-30;
    item.normal_to_scene = cofactors * ((volume < 0 ? -1 : 1) / (size * size));
    item.mirrored = volume < 0;
    item.id = instance.id;
    item.highlighted = instance.highlighted;
    item.opacity = glm::clamp(instance.opacity, 0.0f, 1.0f);
    item.lo = box.lo - origin_world;
    item.hi = box.hi - origin_world;
    const bool shows_values = picture.value_colors && instance.values &&
                              instance.values->size() == instance.mesh->vertex_count();
    item.values = shows_values ? &mirror.values(instance.values) : nullptr;
    item.rest = nullptr;
    item.rest_middle = glm::vec4(0);
    const auto is_solid = [](const Material& m) { return m.solid != Solid::none; };
    if (instance.materials && std::ranges::any_of(*instance.materials, is_solid)) {
        const Ref<Mesh>& rest = faces;
        const Box at_rest = mirror.box_world(rest, glm::dmat4(1));
        const double radius = glm::length(at_rest.size()) / 2;
        item.rest = &mirror.mesh(rest).buffers.front();
        item.rest_middle = glm::vec4(at_rest.center(), radius > 0 ? 1 / radius : 1);
    }
    return item;
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

bool SceneItem::is_body() const
{
    return mesh->faces->solid && opacity >= 1 &&
           std::ranges::all_of(mesh->parts(), [&](const MirroredMesh::Part& part) {
               return material(part.material).alpha == Material::Alpha::opaque;
           });
}

CasterKey casters_of(const Scene& scene)
{
    CasterKey key;
    for (const SceneItem& item : scene.items)
        if (item.opacity >= 1)
            key.casters.push_back({item.mesh->serial, item.to_scene, item.materials});
    return key;
}

Scene scene_of(const Picture& picture, Mirror& mirror, const DeformedMeshes& deformed)
{
    Scene scene;
    std::vector<Box> boxes;
    Box all, standing;
    for (std::size_t i = 0; i < picture.instances.size(); ++i) {
        const Instance& instance = picture.instances[i];
        const DeformedMesh* by_volumes = deformed.of(i);
        const bool some = instance.mesh && instance.mesh->face_count() > 0;
        const Box box = by_volumes ? transformed(by_volumes->box, instance.to_world)
                        : some     ? mirror.box_world(instance.mesh, instance.to_world)
                                   : Box{};
        boxes.push_back(drawable(box) && instance.opacity > 0 ? box : Box{});
        all.add(boxes.back());
        if (instance.opacity >= 1) standing.add(boxes.back());
    }
    if (all.empty()) return scene;
    scene.origin_world = all.center();
    scene.lo = all.lo - scene.origin_world;
    scene.hi = all.hi - scene.origin_world;
    scene.radius = std::max(static_cast<float>(glm::length(all.size())) / 2, 1e-6f);
    // A ghost that dips lower while it is moved does not pull the ground along.
    scene.ground_z =
        static_cast<float>((standing.empty() ? all : standing).lo.z - scene.origin_world.z);
    for (std::size_t i = 0; i < boxes.size(); ++i)
        if (!boxes[i].empty())
            scene.items.push_back(item_of(picture.instances[i], picture, boxes[i],
                                          scene.origin_world, mirror, deformed.of(i)));
    const ValueColors values = picture.value_colors.value_or(ValueColors{});
    scene.map_colors = map_colors(values);
    const float length = values.range.y - values.range.x;
    scene.map_range = {values.range.x, length > 0 ? 1 / length : 1, values.ratios ? 1 : 0, 0};
    return scene;
}

} // namespace trivar::gpu
