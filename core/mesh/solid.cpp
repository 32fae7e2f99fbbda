// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/solid.h"

#include <algorithm>
#include <numeric>

namespace trivar {
namespace {

struct Edge {
    std::uint32_t a, b; // points, a < b
    bool turned;        // the face runs from b to a
    auto operator<=>(const Edge&) const = default;
};

std::vector<Edge> edges_of_faces(const Mesh& mesh)
{
    std::vector<Edge> edges;
    edges.reserve(mesh.corners.size());
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const std::uint32_t begin = mesh.face_begin[f], end = mesh.face_begin[f + 1];
        for (std::uint32_t c = begin; c < end; ++c) {
            const std::uint32_t a = mesh.point(mesh.corners[c]);
            const std::uint32_t b = mesh.point(mesh.corners[c + 1 < end ? c + 1 : begin]);
            edges.push_back({std::min(a, b), std::max(a, b), b < a});
        }
    }
    return edges;
}

bool is_closed(std::vector<Edge> edges)
{
    std::sort(edges.begin(), edges.end());
    for (auto at = edges.begin(); at != edges.end();) {
        std::ptrdiff_t balance = 0;
        const Edge first = *at;
        for (; at != edges.end() && at->a == first.a && at->b == first.b; ++at)
            balance += at->turned ? -1 : 1;
        if (balance != 0) return false;
    }
    return true;
}

// By point, a point of its piece that stands for all of it.
std::vector<std::uint32_t> pieces(const std::vector<Edge>& edges, std::size_t points)
{
    std::vector<std::uint32_t> parent(points);
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&](std::uint32_t p) {
        while (parent[p] != p) p = parent[p] = parent[parent[p]];
        return p;
    };
    for (const Edge& edge : edges) parent[root(edge.a)] = root(edge.b);
    for (std::uint32_t p = 0; p < points; ++p) parent[p] = root(p);
    return parent;
}

} // namespace

bool is_solid(const Mesh& mesh)
{
    if (mesh.face_count() == 0) return false;
    const std::vector<Edge> edges = edges_of_faces(mesh);
    if (!is_closed(edges)) return false;
    const std::vector<std::uint32_t> piece = pieces(edges, point_count(mesh));
    std::vector<double> volume(piece.size(), 0); // six times, by what stands for a piece
    const glm::dvec3 origin(mesh.positions[mesh.corners.front()]);
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const std::uint32_t begin = mesh.face_begin[f], end = mesh.face_begin[f + 1];
        const auto at = [&](std::uint32_t c) {
            return glm::dvec3(mesh.positions[mesh.corners[c]]) - origin;
        };
        for (std::uint32_t c = begin + 1; c + 1 < end; ++c)
            volume[piece[mesh.point(mesh.corners[begin])]] +=
                glm::dot(at(begin), glm::cross(at(c), at(c + 1)));
    }
    for (const Edge& edge : edges)
        if (!(volume[piece[edge.a]] > 0)) return false;
    return true;
}

} // namespace trivar
