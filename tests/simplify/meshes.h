// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/primitives.h"
#include "core/simplify/reach.h"
#include "core/simplify/simplify.h"

#include <algorithm>
#include <random>

namespace trivar::testing {

inline SimplifiedMesh to_number(const Mesh& mesh, std::size_t triangles)
{
    return simplified(make_ref(mesh), {.triangles = triangles, .error = {}, .poses = {}});
}
inline SimplifiedMesh to_error(const Mesh& mesh, double error)
{
    return simplified(make_ref(mesh), {.triangles = {}, .error = error, .poses = {}});
}

inline Mesh bumpy_torus(glm::ivec2 segments)
{
    Mesh mesh = torus_mesh(2, 0.7, segments);
    for (glm::vec3& p : mesh.positions)
        p *= 1 + 0.02f * std::sin(9 * p.x) * std::sin(11 * p.y) * std::sin(13 * p.z);
    mesh.normals = smooth_normals(mesh);
    return mesh;
}

inline std::vector<Triangle3> placed_triangles(const Mesh& mesh)
{
    std::vector<Triangle3> out;
    for (const glm::uvec3& t : triangles(mesh))
        out.push_back({glm::dvec3(mesh.positions[t.x]), glm::dvec3(mesh.positions[t.y]),
                       glm::dvec3(mesh.positions[t.z])});
    return out;
}

// The greatest distance of samples of the first mesh from the second, corners and random points.
inline double sampled_distance(const Mesh& from, const Mesh& to, int samples_each)
{
    const std::vector<Triangle3> goals = placed_triangles(to);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> share(0, 1);
    double most = 0;
    const auto measure = [&](const glm::dvec3& p) {
        double least = 1e300;
        for (const Triangle3& t : goals) least = std::min(least, distance_squared(p, t));
        most = std::max(most, std::sqrt(least));
    };
    for (const Triangle3& t : placed_triangles(from)) {
        for (const glm::dvec3& p : t) measure(p);
        for (int i = 0; i < samples_each; ++i) {
            double a = share(random), b = share(random);
            if (a + b > 1) a = 1 - a, b = 1 - b;
            measure(t[0] + a * (t[1] - t[0]) + b * (t[2] - t[0]));
        }
    }
    return most;
}

inline double area(const Mesh& mesh)
{
    double sum = 0;
    for (const Triangle3& t : placed_triangles(mesh))
        sum += glm::length(glm::cross(t[1] - t[0], t[2] - t[0])) / 2;
    return sum;
}

// Whether each vertex of a mesh has the values of one vertex of another, normals and tangents
// apart.
inline bool has_vertices_of(const Mesh& mesh, const Mesh& whole)
{
    const auto same = [&](std::size_t v, std::size_t w) {
        return mesh.positions[v] == whole.positions[w] &&
               (mesh.colors.empty() || mesh.colors[v] == whole.colors[w]) &&
               (mesh.influences.empty() || mesh.influences[v] == whole.influences[w]) &&
               std::equal(mesh.uvs.begin(), mesh.uvs.end(), whole.uvs.begin(), whole.uvs.end(),
                          [&](const auto& a, const auto& b) { return a[v] == b[w]; }) &&
               std::equal(
                   mesh.morph_targets.begin(), mesh.morph_targets.end(),
                   whole.morph_targets.begin(), whole.morph_targets.end(),
                   [&](const auto& a, const auto& b) { return a.positions[v] == b.positions[w]; });
    };
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        bool found = false;
        for (std::size_t w = 0; w < whole.vertex_count() && !found; ++w) found = same(v, w);
        if (!found) return false;
    }
    return true;
}

} // namespace trivar::testing
