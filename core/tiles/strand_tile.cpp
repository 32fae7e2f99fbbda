// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/strand_tile.h"

#include "core/base/parallel.h"
#include "core/base/unit.h"
#include "core/mesh/adjacency.h"
#include "core/mesh/mesh_copies.h"
#include "core/patches/tile_set.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace trivar {
namespace {

// A point as near to an end as this, in cells, lies at it; and two are alike that near.
constexpr float at_end = 1e-3f;

bool is_at(const glm::vec3& p, float x)
{
    return std::abs(p.x - x) < at_end;
}

// The points of open edges, by their numbers.
std::vector<char> open_points(const Mesh& mesh)
{
    const Adjacency adjacency(mesh);
    std::vector<char> open(adjacency.point_count(), 0);
    for (std::size_t e = 0; e < adjacency.edge_count(); ++e)
        if (adjacency.sides(e).size() == 1)
            open[adjacency.edges()[e].x] = open[adjacency.edges()[e].y] = 1;
    return open;
}

} // namespace

StrandTile strand_tile(Mesh mesh)
{
    StrandTile out;
    std::multimap<float, glm::vec3> first; // those at the first end, by y
    for (const glm::vec3& p : mesh.positions)
        if (is_at(p, 0)) first.emplace(p.y, p);
    std::map<std::pair<float, float>, char> met; // of the first end: it has its like
    const std::vector<char> open = open_points(mesh);
    std::vector<char> lonely(open.size(), 0);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        glm::vec3& p = mesh.positions[v];
        if (!is_at(p, 1)) continue;
        float least = at_end;
        const glm::vec3* like = nullptr;
        for (auto it = first.lower_bound(p.y - at_end);
             it != first.end() && it->first <= p.y + at_end; ++it) {
            const float away =
                glm::distance(glm::vec2(p.y, p.z), glm::vec2(it->second.y, it->second.z));
            if (away < least) least = away, like = &it->second;
        }
        if (!like) {
            lonely[mesh.point(static_cast<std::uint32_t>(v))] = 1;
            continue;
        }
        met[{like->y, like->z}] = 1;
        p = {1, like->y, like->z};
    }
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        glm::vec3& p = mesh.positions[v];
        if (!is_at(p, 0)) continue;
        if (met.contains({p.y, p.z}))
            p.x = 0;
        else
            lonely[mesh.point(static_cast<std::uint32_t>(v))] = 1;
    }
    for (std::size_t k = 0; k < open.size(); ++k) out.unmatched += open[k] && lonely[k];
    out.mesh = std::move(mesh);
    return out;
}

Mesh strand_mesh(const Mesh& unit, std::span<const PlacedTile> tiles)
{
    const std::size_t count = unit.vertex_count();
    Mesh out = copies_of(unit, tiles.size(), false);
    tint_copies(out, tiles);
    parallel_blocks(tiles.size(), 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            for (std::size_t v = 0; v < count; ++v) {
                const glm::dvec3 u(unit.positions[v]);
                const PlacedTile& tile = tiles[k];
                TilePoint at = tile_point(tile.patch, {u.x, u.y, tile.height * u.z + tile.base});
                at.z *= tile.height;
                const std::size_t to = k * count + v;
                out.positions[to] = glm::vec3(at.p) + 0.0f; // no negative zeros
                if (!out.normals.empty()) {
                    const glm::dvec3 n(unit.normals[v]);
                    out.normals[to] =
                        unit_or(n.x * glm::cross(at.y, at.z) + n.y * glm::cross(at.z, at.x) +
                                    n.z * glm::cross(at.x, at.y),
                                {0, 0, 1});
                }
                if (!out.tangents.empty()) {
                    const glm::dvec3 a(unit.tangents[v]);
                    out.tangents[to] = glm::vec4(
                        glm::vec3(unit_or(a.x * at.x + a.y * at.y + a.z * at.z, {0, 0, 1})),
                        unit.tangents[v].w);
                }
            }
    });
    return out;
}

} // namespace trivar
