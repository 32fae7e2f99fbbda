// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/split/bodies.h"

#include "core/mesh/primitives.h"

#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace trivar::testing {

Mesh welded(Mesh mesh)
{
    if (mesh.points.empty()) mesh.points = points_by_position(mesh.positions);
    return mesh;
}

Mesh ball(const glm::dvec3& middle, double radius, int segments)
{
    Mesh mesh = welded(sphere_mesh(radius, segments, segments / 2));
    for (glm::vec3& p : mesh.positions) p += glm::vec3(middle);
    return mesh;
}

Mesh bar(const std::function<glm::dvec3(double)>& axis, double radius, int pieces)
{
    constexpr int round = 48;
    Mesh mesh;
    for (int i = 0; i <= pieces; ++i) {
        const double s = static_cast<double>(i) / pieces;
        const glm::dvec3 t =
            glm::normalize(axis(std::min(1.0, s + 1e-4)) - axis(std::max(0.0, s - 1e-4)));
        const glm::dvec3 x = glm::normalize(glm::cross(glm::dvec3(0, 1, 0), t));
        const glm::dvec3 y = glm::cross(t, x);
        for (int j = 0; j < round; ++j) {
            const double a = 2 * std::numbers::pi * j / round;
            mesh.positions.emplace_back(axis(s) + radius * (std::cos(a) * x + std::sin(a) * y));
        }
    }
    const auto ends = static_cast<std::uint32_t>(mesh.vertex_count());
    mesh.positions.emplace_back(axis(0));
    mesh.positions.emplace_back(axis(1));
    for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(pieces); ++i)
        for (std::uint32_t j = 0; j < round; ++j) {
            const std::uint32_t a = i * round + j, b = i * round + (j + 1) % round;
            add_face(mesh, std::array{a, b, a + round});
            add_face(mesh, std::array{b, b + round, a + round});
        }
    const std::uint32_t last = static_cast<std::uint32_t>(pieces) * round;
    for (std::uint32_t j = 0; j < round; ++j) {
        add_face(mesh, std::array{ends, (j + 1) % round, j});
        add_face(mesh, std::array{ends + 1, last + j, last + (j + 1) % round});
    }
    mesh.normals = smooth_normals(mesh);
    return mesh;
}

Closedness closedness(const Mesh& mesh)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    std::set<std::uint32_t> points;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const std::uint32_t begin = mesh.face_begin[f], end = mesh.face_begin[f + 1];
        for (std::uint32_t c = begin; c < end; ++c) {
            const std::uint32_t a = mesh.point(mesh.corners[c]);
            const std::uint32_t b = mesh.point(mesh.corners[c + 1 < end ? c + 1 : begin]);
            points.insert(a);
            if (a != b) ++edges[{a, b}];
        }
    }
    Closedness out;
    for (const auto& [edge, count] : edges) {
        out.twice += count > 1;
        const auto back = edges.find({edge.second, edge.first});
        out.open += back == edges.end();
        out.unequal += back == edges.end() || back->second < count;
    }
    out.euler = static_cast<long>(points.size()) - static_cast<long>(edges.size()) / 2 +
                static_cast<long>(mesh.face_count());
    return out;
}

Mesh half_of(const Mesh& mesh, const std::vector<char>& above, bool which)
{
    Mesh out = mesh;
    out.corners.clear();
    out.face_begin = {0};
    out.face_material.clear();
    out.face_group.clear();
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const std::span<const std::uint32_t> face(mesh.corners.data() + mesh.face_begin[f],
                                                  mesh.face_begin[f + 1] - mesh.face_begin[f]);
        if ((above[face[0]] != 0) == which) add_face(out, face);
    }
    return out;
}

} // namespace trivar::testing
