// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

#include <map>
#include <utility>

namespace trivar::testing {

struct EdgeCount {
    int edges = 0;
    int open = 0;    // with one face
    int against = 0; // with two faces that run along it the same way
    int crowded = 0; // with more than two faces
    int points = 0;  // that some face has a corner at
};

// Counts the edges between points (not vertices: seams are closed).
inline EdgeCount count_edges(const Mesh& mesh)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<int, int>> uses;
    std::map<std::uint32_t, int> points;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const std::uint32_t begin = mesh.face_begin[f], end = mesh.face_begin[f + 1];
        for (std::uint32_t c = begin; c < end; ++c) {
            const std::uint32_t a = mesh.point(mesh.corners[c]);
            const std::uint32_t b = mesh.point(mesh.corners[c + 1 < end ? c + 1 : begin]);
            ++points[a];
            if (a < b)
                ++uses[{a, b}].first;
            else
                ++uses[{b, a}].second;
        }
    }
    EdgeCount count;
    count.edges = static_cast<int>(uses.size());
    count.points = static_cast<int>(points.size());
    for (const auto& [edge, use] : uses) {
        const int total = use.first + use.second;
        count.open += total == 1;
        count.crowded += total > 2;
        count.against += total == 2 && use.first != 1;
    }
    return count;
}

// Volume inside a closed mesh: positive where the faces turn outward.
inline double volume(const Mesh& mesh)
{
    double sum = 0;
    for (const glm::uvec3& t : triangles(mesh))
        sum +=
            glm::dot(glm::dvec3(mesh.positions[t.x]),
                     glm::cross(glm::dvec3(mesh.positions[t.y]), glm::dvec3(mesh.positions[t.z])));
    return sum / 6;
}

} // namespace trivar::testing
