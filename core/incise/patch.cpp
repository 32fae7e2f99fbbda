// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/mistake.h"
#include "core/incise/walls.h"

#include <algorithm>

namespace trivar {
namespace {

// Adds all triangles of the faces that have one of `triangles`.
void complete_faces(const SlitSkin& skin, std::vector<std::uint32_t>& triangles)
{
    const std::span<const std::uint32_t> faces = skin.faces();
    const std::size_t given = triangles.size();
    for (std::size_t i = 0; i < given; ++i) {
        const std::uint32_t face = skin.face_of(triangles[i]);
        std::uint32_t t = triangles[i];
        while (t > 0 && faces[t - 1] == face) --t;
        for (; t < faces.size() && faces[t] == face; ++t) triangles.push_back(t);
    }
    std::ranges::sort(triangles);
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
}

int corner_at(const SkinTriangle& t, std::uint32_t point)
{
    return t.points[0] == point ? 0 : t.points[1] == point ? 1 : 2;
}

// Puts the edges of a node in order and gives its number of sector to each corner round it.
void go_round(SlitPatch& patch, SlitGraph& graph, std::uint32_t n)
{
    SlitNode& node = graph.nodes[n];
    KeyNumbers edge_to; // by the point at the other end
    for (const std::uint32_t e : node.edges) {
        const SlitEdge& edge = graph.edges[e];
        edge_to.insert(edge.a == node.point ? edge.b : edge.a, e);
    }
    const std::uint32_t first = node.edges[0];
    const std::uint32_t start =
        graph.edges[first].a == node.point ? graph.edges[first].b : graph.edges[first].a;
    node.edges.clear();
    std::uint32_t to = start;
    do {
        const std::uint32_t edge = edge_to.find(to);
        if (edge != KeyNumbers::none) node.edges.push_back(edge);
        const std::uint32_t t = patch.triangle_of_side.find(pair_key(node.point, to));
        ensure(t != KeyNumbers::none, "a node of an incision is not surrounded by triangles");
        const int k = corner_at(patch.triangles[t], node.point);
        patch.sectors[t][static_cast<std::size_t>(k)] =
            static_cast<std::uint32_t>(node.edges.size() - 1);
        to = patch.triangles[t].points[static_cast<std::size_t>((k + 2) % 3)];
    } while (to != start);
    ensure(node.edges.size() == edge_to.size(),
           "a node of an incision has an edge that is not beside it");
}

} // namespace

bool SlitPatch::replaces(std::uint32_t triangle) const
{
    return std::ranges::binary_search(replaced, triangle);
}

SlitPatch patch_of(const SlitDrawing& drawing, std::vector<SkinTriangle> pieces, SlitGraph& graph)
{
    const SlitSkin& skin = drawing.skin();
    SlitPatch patch;
    patch.triangles = std::move(pieces);
    for (const SkinTriangle& piece : patch.triangles)
        if (patch.replaced.empty() || patch.replaced.back() != piece.parent)
            patch.replaced.push_back(piece.parent);
    std::vector<std::uint32_t> all = patch.replaced;
    for (const SlitNode& node : graph.nodes)
        if (node.point < skin.point_count())
            skin.around(node.point, [&](std::uint32_t side) { all.push_back(side / 3); });
    std::ranges::sort(all);
    all.erase(std::unique(all.begin(), all.end()), all.end());
    complete_faces(skin, all);
    for (const std::uint32_t t : all)
        if (!patch.replaces(t)) {
            const glm::uvec3& p = skin.triangle(t);
            patch.triangles.push_back({{p.x, p.y, p.z}, t});
        }
    patch.replaced = std::move(all);
    for (std::uint32_t t = 0; t < patch.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto& p = patch.triangles[t].points;
            const bool fresh =
                patch.triangle_of_side.insert(pair_key(p[k], p[(k + 1) % 3]), t).second;
            ensure(fresh, "two triangles of an incision lie on one side of an edge");
        }
    patch.sectors.assign(patch.triangles.size(),
                         {KeyNumbers::none, KeyNumbers::none, KeyNumbers::none});
    for (std::uint32_t n = 0; n < graph.nodes.size(); ++n) go_round(patch, graph, n);
    return patch;
}

} // namespace trivar
