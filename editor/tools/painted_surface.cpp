// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/painted_surface.h"

#include "core/evaluation/tiling.h"

namespace trivar {
namespace {

Ref<RayScene> scene_of(const EvaluatedObject& shown)
{
    std::vector<RayScene::Entry> entries;
    for (const Part& part : shown.parts)
        entries.push_back({std::make_shared<const RayMesh>(part.mesh()), part.to_world, shown.id});
    return std::make_shared<const RayScene>(std::move(entries));
}

struct Triangle {
    glm::dvec3 a, b, c;
    glm::dvec3 area() const { return glm::cross(b - a, c - a); } // twice it, along the normal
};

Triangle triangle_of(const Mesh& mesh, const glm::uvec3& corners, const glm::dmat4& matrix)
{
    const auto at = [&](std::uint32_t v) {
        return glm::dvec3(matrix * glm::dvec4(mesh.positions[v], 1));
    };
    return {at(corners.x), at(corners.y), at(corners.z)};
}

} // namespace

std::optional<SurfaceHit> PaintedSurface::hit(const Session& session, Id object, const Ray& ray)
{
    const auto found = session.evaluated().objects.find(object);
    const auto there = session.document().objects.find(object);
    if (found == session.evaluated().objects.end() || found->second->parts.empty() ||
        there == session.document().objects.end())
        return {};
    if (shown_ != found->second) {
        shown_ = found->second;
        scene_ = scene_of(*shown_);
    }
    const std::optional<Hit> hit = scene_->hit(ray);
    if (!hit) return {};
    const auto entry = static_cast<std::size_t>(hit->entry);
    const Part& part = shown_->parts[entry];
    const glm::uvec3& corners =
        scene_->entries()[entry].mesh->triangles()[static_cast<std::size_t>(hit->triangle)];
    const Triangle seen = triangle_of(*part.mesh(), corners, part.to_world);
    const Triangle rest =
        triangle_of(*part.rest, corners, mesh_to_model(*shown_, *there->second, part));
    const double square = glm::dot(seen.area(), seen.area());
    const double rest_area = glm::length(rest.area());
    if (!(square > 0) || !(rest_area > 0)) return {};
    const glm::dvec3& p = hit->p_world;
    const double u = glm::dot(seen.area(), glm::cross(seen.b - p, seen.c - p)) / square,
                 v = glm::dot(seen.area(), glm::cross(seen.c - p, seen.a - p)) / square;
    return SurfaceHit{p,
                      hit->normal,
                      {u * rest.a + v * rest.b + (1 - u - v) * rest.c, rest.area() / rest_area},
                      std::sqrt(std::sqrt(square) / rest_area)};
}

} // namespace trivar
