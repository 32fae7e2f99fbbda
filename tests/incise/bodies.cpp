// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/incise/bodies.h"

#include "core/mesh/primitives.h"

#include <array>
#include <cmath>
#include <map>

namespace trivar::testing {

SlitSkin skin_of(Mesh mesh)
{
    if (mesh.points.empty()) mesh.points = points_by_position(mesh.positions);
    return SlitSkin(std::make_shared<const RayMesh>(make_ref(std::move(mesh))));
}

Mesh icosphere(int halvings)
{
    const double g = (1 + std::sqrt(5.0)) / 2;
    std::vector<glm::dvec3> p{{-1, g, 0}, {1, g, 0}, {-1, -g, 0}, {1, -g, 0},
                              {0, -1, g}, {0, 1, g}, {0, -1, -g}, {0, 1, -g},
                              {g, 0, -1}, {g, 0, 1}, {-g, 0, -1}, {-g, 0, 1}};
    std::vector<glm::uvec3> t{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                              {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                              {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                              {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    for (glm::dvec3& q : p) q = glm::normalize(q);
    for (int i = 0; i < halvings; ++i) {
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
        const auto middle = [&](std::uint32_t a, std::uint32_t b) {
            const auto [found, fresh] =
                middles.emplace(std::minmax(a, b), static_cast<std::uint32_t>(p.size()));
            if (fresh) p.push_back(glm::normalize(p[a] + p[b]));
            return found->second;
        };
        std::vector<glm::uvec3> finer;
        for (const glm::uvec3& f : t) {
            const std::uint32_t x = middle(f.x, f.y), y = middle(f.y, f.z), z = middle(f.z, f.x);
            for (const glm::uvec3& each : {glm::uvec3(f.x, x, z), glm::uvec3(f.y, y, x),
                                           glm::uvec3(f.z, z, y), glm::uvec3(x, y, z)})
                finer.push_back(each);
        }
        t = finer;
    }
    Mesh mesh;
    for (const glm::dvec3& q : p) mesh.positions.emplace_back(q);
    for (const glm::uvec3& f : t) add_face(mesh, std::array{f.x, f.y, f.z});
    mesh.normals = smooth_normals(mesh);
    return mesh;
}

Mesh shell_mesh(int halvings, double inner)
{
    const Mesh ball = icosphere(halvings);
    Mesh out;
    out.positions = ball.positions;
    const auto first = static_cast<std::uint32_t>(ball.vertex_count());
    for (const glm::vec3& p : ball.positions)
        out.positions.push_back(static_cast<float>(inner) * p);
    for (std::size_t f = 0; f < ball.face_count(); ++f) {
        const std::uint32_t* const c = ball.corners.data() + ball.face_begin[f];
        add_face(out, std::array{c[0], c[1], c[2]});
        add_face(out, std::array{first + c[0], first + c[2], first + c[1]});
    }
    out.normals = smooth_normals(out);
    return out;
}

Mesh any_closed_primitive(std::size_t i)
{
    switch (i % 5) {
    case 0: return sphere_mesh(1, 32, 16);
    case 1: return torus_mesh(1, 0.4, {36, 18});
    case 2: return box_mesh({1, 1.4, 0.8}, {6, 8, 5});
    case 3: return cylinder_mesh(0.6, 1.5, 24, 10);
    default: return icosphere(3);
    }
}

} // namespace trivar::testing
