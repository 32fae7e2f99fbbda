// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/silhouette/border_lines.h"

#include "core/silhouette/silhouette_curves.h"

#include <utility>

namespace trivar {
namespace {

// Whether cells of a brick have sides in a face of a grid, 0 or `end` along an axis.
bool touches_a_face(const LevelMesh::Brick& brick, const glm::vec3& end)
{
    constexpr float half = LevelMesh::half_brick;
    return glm::any(glm::lessThanEqual(brick.middle - half, glm::vec3(0))) ||
           glm::any(glm::greaterThanEqual(brick.middle + half, end));
}

} // namespace

void BorderEdges::add(const ScalarField<float>& field, const LevelMesh& level, std::size_t bricks,
                      std::uint32_t first_vertex)
{
    for (std::size_t n = 0; n < bricks; ++n) {
        const LevelMesh::Brick& brick = level.bricks[n];
        if (!touches_a_face(brick, field.end())) continue;
        for (std::size_t t = brick.first_triangle; t < brick.triangle_end; ++t) {
            const std::array<std::uint32_t, 3> corners = level.vertices(brick, t);
            for (std::size_t k = 0; k < 3; ++k) {
                const std::uint32_t a = corners[k], b = corners[(k + 1) % 3];
                const glm::vec3& p = level.positions[a];
                if (!are_in_a_face(p, level.positions[b], field.end())) continue;
                known_.insert(pair_key(first_vertex + a, first_vertex + b), 0);
                edges_.push_back({first_vertex + a, first_vertex + b, p,
                                  glm::length(gradient_of(field.at<1>(p)))});
            }
        }
    }
}

Silhouettes BorderEdges::lines(float spacing)
{
    std::vector<Edge> edges = std::exchange(edges_, {});
    const KeyNumbers known = std::exchange(known_, {});
    // Vertices at a sample may be in a face although their edge is not: then it has two triangles.
    std::erase_if(edges, [&](const Edge& e) { return known.contains(pair_key(e.to, e.from)); });
    KeyNumbers leaving(edges.size());
    for (std::size_t i = 0; i < edges.size(); ++i)
        leaving.insert(edges[i].from, static_cast<std::uint32_t>(i));

    Silhouettes out;
    std::vector<char> seen(edges.size(), 0);
    for (std::size_t begin = 0; begin < edges.size(); ++begin) {
        if (seen[begin]) continue;
        const std::size_t before = out.points.size();
        std::vector<std::uint32_t> loop;
        for (std::uint32_t i = static_cast<std::uint32_t>(begin); i != KeyNumbers::none && !seen[i];
             i = leaving.find(edges[i].to)) {
            seen[i] = 1;
            loop.push_back(i);
        }
        const auto add = [&](const Edge& edge) {
            out.points.push_back({.p = edge.p,
                                  .polished = true,
                                  .edge = edge_key(edge.from, edge.to),
                                  .slope = edge.slope});
        };
        for (const std::uint32_t i : loop)
            if (out.points.size() == before ||
                glm::distance(edges[i].p, out.points.back().p) >= spacing)
                add(edges[i]);
        if (out.points.size() - before < 3 && loop.size() >= 3) {
            out.points.resize(before);
            for (std::size_t e = 0; e < 3; ++e) add(edges[loop[e * loop.size() / 3]]);
        }
        out.first.push_back(static_cast<std::uint32_t>(out.points.size()));
        out.closed.push_back(1);
    }
    return out;
}

Silhouettes border_lines(const ScalarField<float>& field, const LevelMesh& level, float spacing)
{
    BorderEdges edges;
    edges.add(field, level, level.bricks.size(), 0);
    return edges.lines(spacing);
}

} // namespace trivar
