// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/painted_surface.h"

#include "core/mesh/barycentric.h"
#include "core/stages/tiled_base.h"

namespace trivar {
namespace {

Ref<RayScene> scene_of(const EvaluatedObject& shown)
{
    std::vector<RayScene::Entry> entries;
    for (const Part& part : shown.whole())
        entries.push_back({std::make_shared<const RayMesh>(part.mesh()), part.to_world, shown.id});
    return std::make_shared<const RayScene>(std::move(entries));
}

using Corners = std::array<glm::dvec3, 3>;

Corners corners_of(const Mesh& mesh, const glm::uvec3& vertices, const glm::dmat4& matrix)
{
    Corners out;
    for (std::size_t k = 0; k < 3; ++k)
        out[k] = glm::dvec3(matrix * glm::dvec4(mesh.positions[vertices[static_cast<int>(k)]], 1));
    return out;
}

// Twice the area of a triangle times its unit normal.
glm::dvec3 area_normal(const Corners& t)
{
    return glm::cross(t[1] - t[0], t[2] - t[0]);
}

} // namespace

std::optional<SurfaceHit> PaintedSurface::hit(const Session& session, Id object, const Ray& ray)
{
    const auto found = session.evaluated().objects.find(object);
    const auto there = session.document().objects.find(object);
    if (found == session.evaluated().objects.end() || found->second->whole().empty() ||
        there == session.document().objects.end())
        return {};
    if (shown_ != found->second) {
        shown_ = found->second;
        scene_ = scene_of(*shown_);
    }
    const std::optional<Hit> hit = scene_->hit(ray);
    if (!hit) return {};
    const auto entry = static_cast<std::size_t>(hit->entry);
    const Part& part = shown_->whole()[entry];
    const glm::uvec3& vertices =
        scene_->entries()[entry].mesh->triangles()[static_cast<std::size_t>(hit->triangle)];
    const Corners seen = corners_of(*part.mesh(), vertices, part.to_world);
    const Corners rest =
        corners_of(*part.rest, vertices, mesh_to_model(*shown_, *there->second, part));
    const double seen_area = glm::length(area_normal(seen)),
                 rest_area = glm::length(area_normal(rest));
    if (!(seen_area > 0) || !(rest_area > 0)) return {};
    const glm::dvec3 at = barycentric(hit->p_world, seen);
    return SurfaceHit{
        hit->p_world,
        hit->normal,
        {at.x * rest[0] + at.y * rest[1] + at.z * rest[2], area_normal(rest) / rest_area},
        std::sqrt(seen_area / rest_area)};
}

std::vector<std::optional<SurfaceHit>> PaintedSurface::seen(const Session& session, Id object,
                                                            std::span<const SurfacePoint> at_rest,
                                                            double reach)
{
    std::vector<std::optional<SurfaceHit>> out(at_rest.size());
    const auto found = session.evaluated().objects.find(object);
    const auto there = session.document().objects.find(object);
    if (found == session.evaluated().objects.end() || found->second->whole().empty() ||
        there == session.document().objects.end())
        return out;
    const std::vector<Part>& parts = found->second->whole();
    RestMeshes rest;
    for (const Part& part : parts)
        rest.emplace_back(part.rest, mesh_to_model(*found->second, *there->second, part));
    if (!at_rest_ || rest != rest_) {
        std::vector<TileBase::Piece> pieces;
        for (const auto& [mesh, to_model] : rest)
            pieces.push_back({std::make_shared<const RayMesh>(mesh), to_model});
        at_rest_ = std::make_shared<const TileBase>(std::move(pieces));
        rest_ = std::move(rest);
    }
    const auto places = at_rest_->locate(at_rest, reach);
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!places[i]) continue;
        const std::uint32_t piece = at_rest_->piece_of(places[i]->triangle);
        const glm::uvec3 vertices = at_rest_->vertices(places[i]->triangle);
        const Corners now = corners_of(*parts[piece].mesh(), vertices, parts[piece].to_world);
        const glm::dvec3 &w = places[i]->weights, n = area_normal(now);
        const double area = glm::length(n);
        out[i] = SurfaceHit{w.x * now[0] + w.y * now[1] + w.z * now[2],
                            area > 0 ? n / area : glm::dvec3(0, 0, 1),
                            {at_rest_->position(*places[i]), at_rest_->normal(*places[i])}};
    }
    return out;
}

} // namespace trivar
