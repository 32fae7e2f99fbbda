// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/cage.h"

#include "core/mesh/repair.h"

#include <algorithm>

namespace trivar {
namespace {

Mesh with_every_point_used(Mesh mesh)
{
    std::vector<std::uint32_t> number(point_count(mesh), ~0u), points(mesh.vertex_count());
    std::uint32_t count = 0;
    for (std::uint32_t v = 0; v < points.size(); ++v) {
        std::uint32_t& known = number[mesh.point(v)];
        if (known == ~0u) known = count++;
        points[v] = known;
    }
    mesh.points = std::move(points);
    return mesh;
}

} // namespace

Mesh ready_to_subdivide(const Mesh& mesh)
{
    return with_every_point_used(repaired(mesh).mesh);
}

Cage cage_of(const Mesh& mesh, const glm::dmat4& to_model)
{
    Cage out;
    out.points.resize(point_count(mesh));
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v)
        out.points[mesh.point(v)] = glm::dvec3(to_model * glm::dvec4(mesh.positions[v], 1));
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        out.face_sizes.push_back(static_cast<int>(mesh.face_begin[f + 1] - mesh.face_begin[f]));
    for (const std::uint32_t v : mesh.corners)
        out.corners.push_back(static_cast<int>(mesh.point(v)));
    if (glm::determinant(glm::dmat3(to_model)) < 0)
        for (std::size_t f = 0; f < mesh.face_count(); ++f)
            std::reverse(out.corners.begin() + mesh.face_begin[f],
                         out.corners.begin() + mesh.face_begin[f + 1]);
    for (const Mesh::Crease& crease : mesh.creases) {
        const int a = static_cast<int>(mesh.point(crease.a)),
                  b = static_cast<int>(mesh.point(crease.b));
        const float sharpness = std::clamp(crease.sharpness, 0.0f, 10.0f);
        if (a == b) {
            out.sharp_points.push_back(a);
            out.point_sharpness.push_back(sharpness);
        } else {
            out.crease_ends.insert(out.crease_ends.end(), {a, b});
            out.crease_sharpness.push_back(sharpness);
        }
    }
    return out;
}

void append(Cage& cage, const Cage& other)
{
    const int first = static_cast<int>(cage.points.size());
    const auto add = [](auto& to, const auto& from, auto step) {
        for (const auto each : from) to.push_back(each + step);
    };
    cage.points.insert(cage.points.end(), other.points.begin(), other.points.end());
    add(cage.face_sizes, other.face_sizes, 0);
    add(cage.corners, other.corners, first);
    add(cage.crease_ends, other.crease_ends, first);
    add(cage.crease_sharpness, other.crease_sharpness, 0.0f);
    add(cage.sharp_points, other.sharp_points, first);
    add(cage.point_sharpness, other.point_sharpness, 0.0f);
}

} // namespace trivar
