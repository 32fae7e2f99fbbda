// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/unwrap/surfaces.h"

#include "core/mesh/primitives.h"

#include <cmath>

namespace trivar::testing {
namespace {

// Two unit boxes, the second moved, welded where they meet.
Mesh two_boxes(const glm::vec3& moved)
{
    Mesh mesh = box_mesh({1, 1, 1}, {2, 2, 2});
    const Mesh other = mesh;
    const auto first = static_cast<std::uint32_t>(mesh.vertex_count());
    for (const glm::vec3& p : other.positions) mesh.positions.push_back(p + moved);
    mesh.normals.insert(mesh.normals.end(), other.normals.begin(), other.normals.end());
    mesh.uvs[0].insert(mesh.uvs[0].end(), other.uvs[0].begin(), other.uvs[0].end());
    for (std::size_t f = 0; f < other.face_count(); ++f) {
        std::vector<std::uint32_t> face;
        for (std::uint32_t c = other.face_begin[f]; c < other.face_begin[f + 1]; ++c)
            face.push_back(first + other.corners[c]);
        add_face(mesh, face);
    }
    mesh.points = points_by_position(mesh.positions);
    return mesh;
}

Mesh rough_ground()
{
    Mesh mesh = plane_mesh({2, 2}, {30, 30});
    for (glm::vec3& p : mesh.positions)
        p.z = 0.15f * std::sin(7 * p.x + 1) * std::cos(5 * p.y) + 0.05f * std::sin(19 * p.x * p.y);
    mesh.normals = smooth_normals(mesh);
    return mesh;
}

} // namespace

Mesh bumpy_ball(int segments, double height)
{
    Mesh mesh = sphere_mesh(1, segments, segments / 2);
    for (glm::vec3& p : mesh.positions)
        p *= 1 + static_cast<float>(height) * std::sin(7 * p.x) * std::sin(6 * p.y + 1) *
                     std::sin(8 * p.z);
    mesh.normals = smooth_normals(mesh);
    return mesh;
}

std::vector<NamedMesh> surfaces_to_unwrap()
{
    return {{"ball", sphere_mesh(1, 48, 24)},
            {"torus", torus_mesh(1, 0.4, {48, 24})},
            {"box", box_mesh({1, 2, 3}, {4, 4, 4})},
            {"Moebius band", moebius_mesh(1, 0.5, {60, 6})},
            {"bumpy ball", bumpy_ball(64, 0.25)},
            {"rough ground", rough_ground()},
            {"boxes that share an edge", two_boxes({1, 1, 0})},
            {"boxes that touch in a point", two_boxes({1, 1, 1})}};
}

Unwrapped unwrapped_alone(const Mesh& mesh, const UnwrapOptions& options)
{
    const UnwrapInput input{make_ref(mesh)};
    return unwrapped({&input, 1}, options);
}

} // namespace trivar::testing
