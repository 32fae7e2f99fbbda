// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/closed_body.h"

#include "core/base/joined_sets.h"
#include "core/mesh/adjacency.h"

namespace trivar {
namespace {

// Returns for each point a point that represents its piece.
std::vector<std::uint32_t> pieces(const Adjacency& adjacency)
{
    JoinedSets sets(adjacency.point_count());
    for (const glm::uvec2& edge : adjacency.edges()) sets.join(edge.x, edge.y);
    std::vector<std::uint32_t> out(adjacency.point_count());
    for (std::uint32_t p = 0; p < out.size(); ++p) out[p] = sets.root(p);
    return out;
}

} // namespace

bool is_closed_body(const Mesh& mesh)
{
    if (mesh.face_count() == 0) return false;
    const Adjacency adjacency(mesh);
    if (!adjacency.is_closed()) return false;
    const std::vector<std::uint32_t> piece = pieces(adjacency);
    std::vector<double> volume(piece.size(), 0); // six times, by representative
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
    for (const glm::uvec2& edge : adjacency.edges())
        if (!(volume[piece[edge.x]] > 0)) return false;
    return true;
}

} // namespace trivar
