// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/limit/cages.h"

#include "core/mesh/adjacency.h"
#include "core/mesh/primitives.h"

#include <map>

namespace trivar::testing {
namespace {

// Returns the mesh by its points alone: without normals and seams.
Mesh bare(const Mesh& mesh)
{
    Mesh out;
    out.positions.resize(point_count(mesh));
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v)
        out.positions[mesh.point(v)] = mesh.positions[v];
    for (const std::uint32_t v : mesh.corners) out.corners.push_back(mesh.point(v));
    out.face_begin = mesh.face_begin;
    return out;
}

template <class Kept> Mesh with_faces(const Mesh& mesh, Kept&& kept)
{
    Mesh out;
    out.positions = mesh.positions;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        if (kept(area_normal(mesh, f)))
            add_face(out,
                     std::span(mesh.corners)
                         .subspan(mesh.face_begin[f], mesh.face_begin[f + 1] - mesh.face_begin[f]));
    return without_loose_vertices(std::move(out));
}

// Number of coordinates that are as large as they get.
int extremes(const glm::vec3& p)
{
    int out = 0;
    for (int a = 0; a < 3; ++a) out += std::abs(std::abs(p[a]) - 1) < 1e-5f;
    return out;
}

template <class Sharpness> void add_creases(Mesh& mesh, Sharpness&& sharpness_of)
{
    const Adjacency adjacency(mesh);
    for (const glm::uvec2& edge : adjacency.edges()) {
        const glm::vec3 &a = mesh.positions[edge.x], &b = mesh.positions[edge.y];
        if (extremes((a + b) / 2.0f) < 2) continue;
        mesh.creases.push_back({edge.x, edge.y, sharpness_of(a, b)});
    }
}

} // namespace

Mesh torus_cage()
{
    return bare(torus_mesh(1, 0.4, {12, 6}));
}

Mesh cube_cage()
{
    return bare(box_mesh({2, 2, 2}, {2, 2, 2}));
}

Mesh tower_cage()
{
    Mesh mesh;
    const auto add_ring = [&](float z, float radius) {
        for (int k = 0; k < 5; ++k) {
            const float angle = 6.2831853f * static_cast<float>(k) / 5;
            mesh.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
        }
    };
    add_ring(-1, 1);
    add_ring(0.2f, 0.8f);
    add_ring(1, 1.1f);
    mesh.positions.emplace_back(0, 0, 1.7f);
    const std::array<std::uint32_t, 5> bottom{4, 3, 2, 1, 0};
    add_face(mesh, bottom);
    for (std::uint32_t ring = 0; ring < 2; ++ring)
        for (std::uint32_t k = 0; k < 5; ++k) {
            const std::uint32_t a = 5 * ring + k, b = 5 * ring + (k + 1) % 5;
            add_face(mesh, std::array{a, b, b + 5, a + 5});
        }
    for (std::uint32_t k = 0; k < 5; ++k)
        add_face(mesh, std::array<std::uint32_t, 3>{10 + k, 10 + (k + 1) % 5, 15});
    return mesh;
}

Mesh open_box_cage()
{
    Mesh mesh = with_faces(bare(box_mesh({2, 2, 2}, {3, 2, 2})),
                           [](const glm::dvec3& n) { return n.z > -1e-6; });
    // None without end beside a smooth one: subdivide() takes the limit there as if all were
    // smooth.
    add_creases(mesh, [](const glm::vec3& a, const glm::vec3& b) {
        if (std::abs(a.x - b.x) > 0.1f) return 4.0f;
        return std::abs(a.y - b.y) > 0.1f ? 2.5f : 0.7f;
    });
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v)
        if (extremes(mesh.positions[v]) == 3 && mesh.positions[v].x > 0 && mesh.positions[v].y > 0)
            mesh.creases.push_back({v, v, 10});
    return mesh;
}

Mesh sharp_box_cage()
{
    Mesh mesh = bare(box_mesh({2, 2, 2}, {3, 3, 3}));
    add_creases(mesh, [](const glm::vec3&, const glm::vec3&) { return 10.0f; });
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v)
        if (extremes(mesh.positions[v]) == 3) mesh.creases.push_back({v, v, 10});
    return mesh;
}

Mesh plane_cage()
{
    return bare(plane_mesh({2, 2}, {4, 3}));
}

std::vector<NamedCage> all_cages()
{
    return {{"torus", torus_cage()},         {"cube", cube_cage()},
            {"tower", tower_cage()},         {"open box", open_box_cage()},
            {"sharp box", sharp_box_cage()}, {"plane", plane_cage()}};
}

LimitSurface limit_of(const Mesh& mesh)
{
    return LimitSurface(cage_of(ready_to_subdivide(mesh)));
}

const LimitSurface& limit_sphere()
{
    static const LimitSurface sphere = [] {
        Cage cage = cage_of(ready_to_subdivide(bare(box_mesh({2, 2, 2}, {8, 8, 8}))));
        for (glm::dvec3& p : cage.points) p = glm::normalize(glm::tan(p * 0.785398163397448));
        LimitSurface surface(cage);
        // The points are moved until the limit of each is on the sphere.
        for (int i = 0; i < 60; ++i) {
            std::vector<glm::dvec3> off(cage.points.size());
            for (std::uint32_t c = 0; c < surface.net().size(); ++c)
                for (int k = 0; k < 4; ++k) {
                    const glm::dvec3 p = surface.position({c, chart_corner(k)});
                    off[surface.net().point(c, k)] = glm::normalize(p) - p;
                }
            for (std::size_t v = 0; v < off.size(); ++v) cage.points[v] += off[v];
            surface = surface.moved(cage.points);
        }
        return surface;
    }();
    return sphere;
}

ChartPlace random_chart_place(const LimitSurface& surface, std::mt19937& random)
{
    std::uniform_real_distribution<double> share(0, 1);
    const auto chart = static_cast<std::uint32_t>(random() % surface.net().size());
    const double u = share(random), v = share(random);
    return {chart, {u, v}};
}

glm::dvec3 random_tangent_at(const LimitSurface& surface, const ChartPlace& at,
                             std::mt19937& random)
{
    std::normal_distribution<double> number;
    const glm::dvec3 n = surface.normal(at), v(number(random), number(random), number(random));
    return glm::normalize(v - glm::dot(v, n) * n);
}

} // namespace trivar::testing
