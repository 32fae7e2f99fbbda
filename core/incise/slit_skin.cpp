// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/slit_skin.h"

#include "core/base/finite.h"
#include "core/base/unit.h"
#include "core/mesh/adjacency.h"

#include <algorithm>
#include <numeric>

namespace trivar {
namespace {

constexpr double least_thickness = 0.05; // usual edges: nearer hits are the skin that is cut
// Lines along which points are looked for, beside their normals: one that only grazes an edge or a
// corner of the body misses it.
constexpr std::array<glm::dvec3, 5> leans{
    {{0, 0, 0}, {0.3, 0.1, 0.2}, {-0.3, 0.2, -0.1}, {0.1, -0.3, -0.2}, {-0.1, -0.1, 0.3}}};
constexpr std::uint32_t most_valence = 100000;

SkinPlace place_in(const std::array<glm::dvec3, 3>& p, std::uint32_t t, const glm::dvec3& x)
{
    const glm::dvec3 u = p[1] - p[0], v = p[2] - p[0], w = x - p[0];
    const double uu = glm::dot(u, u), uv = glm::dot(u, v), vv = glm::dot(v, v);
    const double det = uu * vv - uv * uv;
    if (!(det > 0)) return {t, {1, 0, 0}};
    const double wu = glm::dot(w, u), wv = glm::dot(w, v);
    const double b = std::clamp((vv * wu - uv * wv) / det, 0.0, 1.0);
    const double c = std::clamp((uu * wv - uv * wu) / det, 0.0, 1 - b);
    return {t, {1 - b - c, b, c}};
}

} // namespace

SlitSkin::SlitSkin(const Ref<RayMesh>& rays) : mesh_(rays, &rays->mesh()), scene_({{rays}})
{
    const Mesh& mesh = *mesh_;
    const std::size_t points =
        mesh.points.empty() ? mesh.vertex_count() : trivar::point_count(mesh);
    positions_.resize(points);
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v)
        positions_[mesh.point(v)] = glm::dvec3(mesh.positions[v]);

    const std::vector<glm::uvec3>& all = rays->triangles();
    std::size_t f = 0;
    for (std::uint32_t t = 0; t < all.size(); ++t) {
        while (t >= mesh.face_begin[f + 1] - 2 * (f + 1)) ++f;
        const glm::uvec3 v = all[t], p(mesh.point(v.x), mesh.point(v.y), mesh.point(v.z));
        if (p.x == p.y || p.y == p.z || p.z == p.x) {
            if (own_number_.empty())
                for (std::uint32_t i = 0; i < t; ++i) own_number_.push_back(i);
            own_number_.push_back(none);
            continue;
        }
        if (!own_number_.empty())
            own_number_.push_back(static_cast<std::uint32_t>(triangles_.size()));
        triangles_.push_back(p);
        vertices_.push_back(v);
        faces_.push_back(static_cast<std::uint32_t>(f));
    }

    std::vector<std::uint32_t> corners;
    corners.reserve(3 * triangles_.size());
    for (const glm::uvec3& t : triangles_) corners.insert(corners.end(), {t.x, t.y, t.z});
    const Adjacency adjacency(std::move(corners), points);
    across_.assign(3 * triangles_.size(), none);
    first_side_.assign(points, none);
    soundness_.assign(points, Soundness::sound);
    for (std::size_t e = 0; e < adjacency.edge_count(); ++e) {
        const auto sides = adjacency.sides(e);
        if (adjacency.is_manifold(e)) {
            across_[sides[0]] = sides[1];
            across_[sides[1]] = sides[0];
            continue;
        }
        for (const std::uint32_t p : {adjacency.edges()[e].x, adjacency.edges()[e].y})
            soundness_[p] =
                std::max(soundness_[p], sides.size() == 1 ? Soundness::border : Soundness::tangled);
    }
    judge_points();
}

void SlitSkin::judge_points()
{
    std::vector<std::uint32_t> valence(positions_.size(), 0);
    normals_.assign(positions_.size(), glm::dvec3(0));
    double lengths = 0;
    for (std::uint32_t t = 0; t < triangles_.size(); ++t)
        for (std::uint32_t i = 0; i < 3; ++i) {
            const std::uint32_t p = triangles_[t][i];
            first_side_[p] = 3 * t + i;
            ++valence[p];
            normals_[p] += area_normal(t);
            lengths += glm::distance(positions_[p], positions_[to(3 * t + i)]);
        }
    usual_edge_ = lengths / static_cast<double>(std::max<std::size_t>(1, 3 * triangles_.size()));
    Box box;
    for (std::uint32_t p = 0; p < positions_.size(); ++p) {
        normals_[p] = unit_or_zero(normals_[p]);
        if (valence[p] == 0) continue;
        box.add(positions_[p]);
        if (soundness_[p] != Soundness::sound) continue;
        std::uint32_t round = 0, side = first_side_[p]; // several fans at one point do not close
        do {
            ++round;
            side = across_[previous(side)];
        } while (side != none && side != first_side_[p] && round < most_valence);
        if (round != valence[p]) soundness_[p] = Soundness::tangled;
    }
    diagonal_ = glm::length(box.size());
}

glm::dvec3 SlitSkin::area_normal(std::uint32_t t) const
{
    const glm::uvec3& p = triangles_[t];
    return glm::cross(positions_[p.y] - positions_[p.x], positions_[p.z] - positions_[p.x]);
}

std::vector<std::optional<SkinPlace>> SlitSkin::locate(std::span<const SurfacePoint> points,
                                                       double reach) const
{
    std::vector<std::optional<SkinPlace>> out(points.size());
    std::vector<std::size_t> lost(points.size());
    std::iota(lost.begin(), lost.end(), std::size_t{0});
    for (const glm::dvec3& lean : leans) {
        std::vector<Ray> rays;
        for (const std::size_t i : lost) // from both sides toward the point, so that it is hit
            for (const double side : {1.0, -1.0}) {
                const glm::dvec3 n = glm::normalize(points[i].normal + lean);
                rays.push_back({points[i].p + side * reach * n, -side * n});
            }
        const std::vector<double> to(rays.size(), 2 * reach);
        const std::vector<std::optional<Hit>> hits = scene_.hits(rays, false, to);
        for (std::size_t k = 0; k < lost.size(); ++k) {
            double nearest = 2 * reach;
            for (const std::optional<Hit>& hit : {hits[2 * k], hits[2 * k + 1]}) {
                if (!hit) continue;
                const double away = glm::distance(hit->p_world, points[lost[k]].p);
                const std::uint32_t t = own_triangle(*hit);
                if (!(away < nearest) || t == none) continue;
                nearest = away;
                const glm::uvec3& p = triangles_[t];
                out[lost[k]] =
                    place_in({positions_[p.x], positions_[p.y], positions_[p.z]}, t, hit->p_world);
            }
        }
        std::erase_if(lost, [&](std::size_t i) { return out[i].has_value(); });
        if (lost.empty()) break;
    }
    return out;
}

std::vector<std::optional<Hit>> SlitSkin::hits_below(std::span<const Ray> rays) const
{
    std::vector<Ray> below(rays.begin(), rays.end());
    const double skipped = least_thickness * usual_edge_;
    for (Ray& ray : below) ray.origin += skipped * ray.direction;
    std::vector<std::optional<Hit>> hits = scene_.hits(below);
    for (std::optional<Hit>& hit : hits)
        if (hit) hit->distance += skipped;
    return hits;
}

std::vector<double> SlitSkin::thickness(std::span<const Ray> rays) const
{
    std::vector<double> out;
    for (const std::optional<Hit>& hit : hits_below(rays))
        out.push_back(hit ? hit->distance : infinite);
    return out;
}

std::uint32_t SlitSkin::own_triangle(const Hit& hit) const
{
    const auto number = static_cast<std::uint32_t>(hit.triangle);
    return own_number_.empty() ? number : own_number_[number];
}

std::vector<std::optional<SlitSkin::Opposite>> SlitSkin::opposite(std::span<const Ray> rays) const
{
    std::vector<std::optional<Opposite>> out;
    for (const std::optional<Hit>& hit : hits_below(rays)) {
        const std::uint32_t t = hit && hit->back_face ? own_triangle(*hit) : none;
        out.emplace_back();
        if (t == none) continue;
        const glm::uvec3& p = triangles_[t];
        const std::array corners{positions_[p.x], positions_[p.y], positions_[p.z]};
        out.back() = {place_in(corners, t, hit->p_world), hit->distance};
    }
    return out;
}

} // namespace trivar
