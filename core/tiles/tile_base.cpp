// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/tile_base.h"

#include "core/base/box.h"
#include "core/base/mistake.h"
#include "core/base/unit.h"
#include "core/mesh/adjacency.h"
#include "core/mesh/barycentric.h"

#include <algorithm>

namespace trivar {
namespace {

// Its triangles are turned the other way round.
bool is_mirrored(const TileBase::Piece& piece)
{
    return glm::determinant(glm::dmat3(piece.to_model)) < 0;
}

RayScene scene_of(const std::vector<TileBase::Piece>& pieces)
{
    std::vector<RayScene::Entry> entries;
    for (const TileBase::Piece& piece : pieces) entries.push_back({piece.mesh, piece.to_model, 0});
    return RayScene(std::move(entries));
}

} // namespace

SurfacePlace inside(SurfacePlace at)
{
    at.weights = glm::max(at.weights, glm::dvec3(0));
    at.weights /= at.weights.x + at.weights.y + at.weights.z;
    return at;
}

std::vector<glm::dvec3> angle_normals(std::span<const glm::dvec3> points,
                                      std::span<const glm::uvec3> triangles)
{
    std::vector<glm::dvec3> normals(points.size(), glm::dvec3(0));
    for (const glm::uvec3& t : triangles) {
        const glm::dvec3 n =
            unit_or_zero(glm::cross(points[t.y] - points[t.x], points[t.z] - points[t.x]));
        for (int e = 0; e < 3; ++e) {
            const glm::dvec3 a = points[t[(e + 1) % 3]] - points[t[e]],
                             b = points[t[(e + 2) % 3]] - points[t[e]];
            normals[t[e]] += std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * n;
        }
    }
    for (glm::dvec3& n : normals) n = unit_or(n, {0, 0, 1});
    return normals;
}

void TileBase::add_faces(const Piece& piece)
{
    const Mesh& mesh = piece.mesh->mesh();
    const std::uint32_t first = faces_.empty() ? 0 : 1 + *std::ranges::max_element(faces_);
    for (std::uint32_t f = 0; f < mesh.face_count(); ++f) {
        const std::uint32_t triangles = mesh.face_begin[f + 1] - mesh.face_begin[f] - 2;
        for (std::uint32_t k = 0; k < triangles; ++k) {
            const std::size_t t = mesh.face_begin[f] - 2 * f + k;
            faces_.push_back(first + (piece.faces ? (*piece.faces)[t] : f));
            materials_.push_back(mesh.face_material.empty() ? 0 : mesh.face_material[f]);
        }
    }
}

TileBase::TileBase(std::vector<Piece> pieces)
    : pieces_(std::move(pieces)),
      scene_(scene_of(pieces_))
{
    std::vector<std::uint32_t> corners;
    Box box;
    for (const Piece& piece : pieces_) {
        first_.push_back(static_cast<std::uint32_t>(triangles_.size()));
        const Mesh& mesh = piece.mesh->mesh();
        const auto before = static_cast<std::uint32_t>(points_.size());
        points_.resize(before + point_count(mesh));
        for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v)
            points_[before + mesh.point(v)] =
                glm::dvec3(piece.to_model * glm::dvec4(mesh.positions[v], 1));
        // A mirrored mesh shows its other side.
        const bool mirrored = is_mirrored(piece);
        for (glm::uvec3 t : piece.mesh->triangles()) {
            if (mirrored) std::swap(t.y, t.z);
            triangles_.emplace_back(before + mesh.point(t.x), before + mesh.point(t.y),
                                    before + mesh.point(t.z));
        }
        add_faces(piece);
    }
    ensure(faces_.size() == triangles_.size(), "a triangle is of no face");
    first_.push_back(static_cast<std::uint32_t>(triangles_.size()));
    for (const glm::dvec3& p : points_) box.add(p);
    diagonal_ = glm::length(box.size());
    for (const glm::uvec3& t : triangles_) {
        corners.insert(corners.end(), {t.x, t.y, t.z});
        const glm::dvec3 n = glm::cross(points_[t.y] - points_[t.x], points_[t.z] - points_[t.x]);
        area_ += glm::length(n) / 2;
        face_normals_.push_back(unit_or_zero(n));
    }
    point_normals_ = angle_normals(points_, triangles_);
    across_.assign(corners.size(), none);
    const Adjacency adjacency(std::move(corners), points_.size());
    for (std::size_t e = 0; e < adjacency.edge_count(); ++e)
        if (adjacency.is_manifold(e)) {
            const auto sides = adjacency.sides(e);
            across_[sides[0]] = sides[1];
            across_[sides[1]] = sides[0];
        }
}

std::uint32_t TileBase::piece_of(std::uint32_t t) const
{
    return static_cast<std::uint32_t>(std::ranges::upper_bound(first_, t) - first_.begin() - 1);
}

glm::uvec3 TileBase::vertices(std::uint32_t t) const
{
    const std::uint32_t piece = piece_of(t);
    glm::uvec3 out = pieces_[piece].mesh->triangles()[t - first_[piece]];
    if (is_mirrored(pieces_[piece])) std::swap(out.y, out.z); // as its points are
    return out;
}

std::array<glm::dvec3, 3> TileBase::corners(std::uint32_t t) const
{
    const glm::uvec3& c = triangles_[t];
    return {points_[c.x], points_[c.y], points_[c.z]};
}

SurfacePlace TileBase::place(std::uint32_t t, const glm::dvec3& p) const
{
    return {t, barycentric(p, corners(t))};
}

glm::dvec3 TileBase::position(const SurfacePlace& at) const
{
    const glm::uvec3& t = triangles_[at.triangle];
    return at.weights.x * points_[t.x] + at.weights.y * points_[t.y] + at.weights.z * points_[t.z];
}

glm::dvec3 TileBase::normal(const SurfacePlace& at) const
{
    const glm::uvec3& t = triangles_[at.triangle];
    return unit_or(at.weights.x * point_normals_[t.x] + at.weights.y * point_normals_[t.y] +
                       at.weights.z * point_normals_[t.z],
                   face_normals_[at.triangle]);
}

double TileBase::area(std::uint32_t t) const
{
    const glm::uvec3& c = triangles_[t];
    return glm::length(glm::cross(points_[c.y] - points_[c.x], points_[c.z] - points_[c.x])) / 2;
}

std::vector<std::optional<SurfacePlace>> TileBase::locate(std::span<const SurfacePoint> points,
                                                          double reach) const
{
    std::vector<Ray> rays;
    for (const SurfacePoint& each : points) // from both sides toward the point, so that it is hit
        for (const double side : {1.0, -1.0})
            rays.push_back({each.p + side * reach * each.normal, -side * each.normal});
    const std::vector<double> to(rays.size(), 2 * reach);
    const std::vector<std::optional<Hit>> hits = scene_.hits(rays, false, to);
    std::vector<std::optional<SurfacePlace>> out(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        double nearest = 2 * reach;
        for (const std::size_t k : {2 * i, 2 * i + 1}) {
            if (!hits[k]) continue;
            const double away = glm::distance(hits[k]->p_world, points[i].p);
            if (!(away < nearest)) continue;
            nearest = away;
            const std::uint32_t t = first_[static_cast<std::size_t>(hits[k]->entry)] +
                                    static_cast<std::uint32_t>(hits[k]->triangle);
            out[i] = inside(place(t, hits[k]->p_world));
        }
    }
    return out;
}

} // namespace trivar
