// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/incise/incised_skin.h"

#include "core/incise/incised.h"
#include "core/mesh/barycentric.h"
#include "core/stages/tiled_base.h"
#include "editor/tools/incise/uv_line.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

using SkinCorners = std::array<glm::dvec3, 3>;

SkinCorners skin_corners(const Mesh& mesh, const glm::uvec3& vertices, const glm::dmat4& matrix)
{
    SkinCorners out;
    for (std::size_t k = 0; k < 3; ++k)
        out[k] = glm::dvec3(matrix * glm::dvec4(mesh.positions[vertices[static_cast<int>(k)]], 1));
    return out;
}

glm::dvec3 skin_area_normal(const SkinCorners& t)
{
    return glm::cross(t[1] - t[0], t[2] - t[0]);
}

bool turns_inside_out(const glm::dmat4& matrix)
{
    return glm::determinant(glm::dmat3(matrix)) < 0;
}

Ref<RayScene> skin_scene(const std::vector<Part>& parts)
{
    std::vector<RayScene::Entry> entries;
    for (const Part& part : parts)
        entries.push_back({std::make_shared<const RayMesh>(part.mesh()), part.to_world, 1});
    return std::make_shared<const RayScene>(std::move(entries));
}

} // namespace

void IncisedSkin::look(const Session& session, Id object)
{
    const auto found = session.evaluated().objects.find(object);
    const auto there = session.document().objects.find(object);
    if (found == session.evaluated().objects.end() || there == session.document().objects.end() ||
        there->second->tiles) {
        *this = {};
        return;
    }
    if (shown_ == found->second) return;
    const std::vector<SkinPart> before = std::move(parts_);
    shown_ = found->second;
    parts_.clear();
    shut_parts_.clear();
    const std::vector<Shape::NodeMesh>& meshes = shown_->shape->meshes;
    const std::vector<Part>& all = shown_->whole();
    for (std::size_t p = 0; p < all.size(); ++p) {
        const auto hung =
            std::ranges::find(meshes, all[p].key.mesh, [](const auto& m) { return m.slot; });
        if (hung == meshes.end() || all[p].tiles) continue;
        SkinPart part;
        part.part = p;
        part.shut_to_model = hung->to_model;
        part.shut_to_part =
            glm::inverse(mesh_to_model(*shown_, *there->second, all[p])) * part.shut_to_model;
        const auto incised =
            std::ranges::find(shown_->incised_meshes, hung->slot, &IncisingEffects::OfMesh::slot);
        const Part& first = innermost(all[p]);
        const bool cut = incised != shown_->incised_meshes.end();
        part.original = cut ? incised->incised->original : hung->rest;
        const Ref<Mesh>& with_walls = cut ? incised->incised->rest : hung->rest;
        if (with_walls->vertex_count() == first.rest->vertex_count() &&
            with_walls->face_count() == first.rest->face_count()) {
            part.shut = with_walls;
            if (cut) {
                part.incised = incised->incised;
                part.first_wall_face = part.incised->first_wall_face;
            }
        }
        part.posed = part.original;
        if (first.posed && !first.posed->pose.empty())
            part.posed = *posed_later(part.original, first.posed->pose)->mesh;
        part.mirrors = turns_inside_out(part.shut_to_part);
        parts_.push_back(part);
        shut_parts_.push_back(with_innermost(
            all[p],
            part.mirrors ? make_ref(transformed(*part.posed, part.shut_to_part)) : part.posed));
    }
    auto trees = std::make_shared<Trees>();
    const auto same = [](const SkinPart& a, const SkinPart& b) {
        return a.original == b.original && a.shut_to_model == b.shut_to_model;
    };
    if (std::ranges::equal(before, parts_, same)) {
        trees->rest = trees_->rest;
        trees->inside = trees_->inside;
    }
    trees_ = std::move(trees);
}

double IncisedSkin::diagonal() const
{
    return parts_.empty() ? 0 : rest_base().diagonal();
}

const RayScene& IncisedSkin::seen_scene() const
{
    if (!trees_->seen) {
        std::vector<Part> parts;
        for (const SkinPart& each : parts_) parts.push_back(shown_->whole()[each.part]);
        trees_->seen = skin_scene(parts);
    }
    return *trees_->seen;
}

const RayScene& IncisedSkin::shut_scene() const
{
    if (!trees_->shut) trees_->shut = skin_scene(shut_parts_);
    return *trees_->shut;
}

const TileBase& IncisedSkin::rest_base() const
{
    if (!trees_->rest) {
        std::vector<TileBase::Piece> pieces;
        std::vector<RayScene::Entry> entries;
        for (const SkinPart& part : parts_) {
            const auto rays = std::make_shared<const RayMesh>(part.original);
            pieces.push_back({rays, part.shut_to_model});
            entries.push_back({rays, part.shut_to_model, 1});
        }
        trees_->rest = std::make_shared<const TileBase>(std::move(pieces));
        trees_->inside = std::make_shared<const RayScene>(std::move(entries));
    }
    return *trees_->rest;
}

std::optional<SurfaceHit> IncisedSkin::hit_of(const SkinPart& part, const Part& seen,
                                              const Mesh& rest, const RayScene& scene,
                                              const Hit& hit) const
{
    const glm::uvec3& vertices = scene.entries()[static_cast<std::size_t>(hit.entry)]
                                     .mesh->triangles()[static_cast<std::size_t>(hit.triangle)];
    const SkinCorners now = skin_corners(*seen.mesh(), vertices, seen.to_world);
    const SkinCorners then = skin_corners(rest, vertices, part.shut_to_model);
    const double now_area = glm::length(skin_area_normal(now)),
                 then_area = glm::length(skin_area_normal(then));
    if (!(now_area > 0) || !(then_area > 0)) return {};
    const glm::dvec3 at = barycentric(hit.p_world, now);
    // Faces of a part that is a mirror image run the other way round
    const bool other = part.mirrors != turns_inside_out(part.shut_to_model);
    return SurfaceHit{hit.p_world,
                      hit.normal,
                      {at.x * then[0] + at.y * then[1] + at.z * then[2],
                       (other ? -1.0 : 1.0) * skin_area_normal(then) / then_area},
                      std::sqrt(now_area / then_area)};
}

std::optional<SurfaceHit> IncisedSkin::hit(const Ray& ray) const
{
    if (parts_.empty()) return {};
    const RayScene& scene = seen_scene();
    const std::optional<Hit> hit = scene.hit(ray);
    if (!hit) return {};
    const SkinPart& part = parts_[static_cast<std::size_t>(hit->entry)];
    if (!part.shut) return shut_hit(ray); // its vertices are not known
    if (static_cast<std::uint32_t>(hit->face) >= part.first_wall_face) return {};
    return hit_of(part, shown_->whole()[part.part], *part.shut, scene, *hit);
}

std::optional<SurfaceHit> IncisedSkin::shut_hit(const Ray& ray) const
{
    if (parts_.empty()) return {};
    const RayScene& scene = shut_scene();
    const std::optional<Hit> hit = scene.hit(ray);
    if (!hit) return {};
    const auto entry = static_cast<std::size_t>(hit->entry);
    return hit_of(parts_[entry], shut_parts_[entry], *parts_[entry].original, scene, *hit);
}

std::optional<SurfaceHit> IncisedSkin::wall_hit(const Ray& ray) const
{
    if (parts_.empty()) return {};
    const RayScene& scene = seen_scene();
    const std::optional<Hit> hit = scene.hit(ray);
    if (!hit) return {};
    const auto entry = static_cast<std::size_t>(hit->entry);
    const SkinPart& part = parts_[entry];
    if (static_cast<std::uint32_t>(hit->face) < part.first_wall_face || !part.incised) return {};
    std::optional<SurfaceHit> out = shut_hit(ray); // the normal there is about that above the wall
    if (!out) return {};
    const glm::uvec3& vertices =
        scene.entries()[entry].mesh->triangles()[static_cast<std::size_t>(hit->triangle)];
    const Part& seen = shown_->whole()[part.part];
    const glm::dvec3 weights =
        barycentric(hit->p_world, skin_corners(*seen.mesh(), vertices, seen.to_world));
    glm::dvec3 top(0);
    for (int k = 0; k < 3; ++k)
        top +=
            weights[k] *
            glm::dvec3(part.incised->wall_tops.at(vertices[k] - part.incised->first_wall_vertex));
    const SurfacePoint above{glm::dvec3(part.shut_to_model * glm::dvec4(top, 1)),
                             out->at_rest.normal};
    const auto place = rest_base().locate(std::span(&above, 1), 0.01 * diagonal()).front();
    if (!place) return {};
    out->p_world = hit->p_world;
    out->at_rest = seen_place(*place).at_rest;
    return out;
}

SurfaceHit IncisedSkin::seen_place(const SurfacePlace& place) const
{
    const TileBase& base = rest_base();
    const SkinPart& skin = parts_[base.piece_of(place.triangle)];
    const Part& part = shown_->whole()[skin.part];
    const SkinCorners posed =
        skin_corners(*skin.posed, base.vertices(place.triangle), skin.shut_to_part);
    const glm::dvec3& w = place.weights;
    const glm::dvec3 p = w.x * posed[0] + w.y * posed[1] + w.z * posed[2];
    const glm::dvec3 n = skin_area_normal(posed) * (skin.mirrors ? -1.0 : 1.0);
    DeformedPoint there{glm::dvec3(part.to_world * glm::dvec4(p, 1)), glm::dmat3(part.to_world)};
    if (part.bent) there = point_in_world(part, p);
    const glm::dmat3 cofactors =
        glm::determinant(there.jacobian) * glm::transpose(glm::inverse(there.jacobian));
    const bool inside_out = glm::determinant(there.jacobian) < 0;
    const glm::dvec3 now = cofactors * n * (inside_out ? -1.0 : 1.0);
    const double area = glm::length(now), rest_area = 2 * base.area(place.triangle);
    SurfaceHit out{there.position_world,
                   area > 0 ? now / area : glm::dvec3(0, 0, 1),
                   {base.position(place), base.normal(place)},
                   area > 0 && rest_area > 0 ? std::sqrt(area / rest_area) : 1.0};
    if (turns_inside_out(skin.shut_to_model)) out.at_rest.normal *= -1;
    return out;
}

std::vector<std::optional<SurfaceHit>> IncisedSkin::seen(std::span<const SurfacePoint> at_rest,
                                                         double reach) const
{
    std::vector<std::optional<SurfaceHit>> out(at_rest.size());
    if (parts_.empty()) return out;
    const auto places = rest_base().locate(at_rest, reach);
    for (std::size_t i = 0; i < places.size(); ++i)
        if (places[i]) out[i] = seen_place(*places[i]);
    return out;
}

std::array<IncisedSkin::SeenUvLine, 2> IncisedSkin::uv_lines(const SurfacePoint& at_rest) const
{
    std::array<SeenUvLine, 2> out;
    if (parts_.empty()) return out;
    const TileBase& base = rest_base();
    const double reach = 1e-3 * base.diagonal();
    const auto place = base.locate(std::span(&at_rest, 1), reach).front();
    if (!place) return out;
    for (int coordinate = 0; coordinate < 2; ++coordinate) {
        const UvLine line = uv_line(base, *place, coordinate);
        SeenUvLine& seen = out[static_cast<std::size_t>(coordinate)];
        seen.start = line.start;
        for (const SurfacePlace& each : line.places) seen.places.push_back(seen_place(each));
    }
    return out;
}

std::vector<double> IncisedSkin::thickness(std::span<const SurfacePoint> at_rest) const
{
    std::vector<double> out(at_rest.size(), 0);
    if (parts_.empty()) return out;
    const double skip = 1e-4 * rest_base().diagonal();
    for (std::size_t i = 0; i < at_rest.size(); ++i)
        if (const auto hit = trees_->inside->hit({at_rest[i].p, -at_rest[i].normal}, skip))
            out[i] = hit->distance;
    return out;
}

} // namespace trivar
