// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/left_out.h"

#include <algorithm>

namespace trivar {
namespace {

// The triangles of a shape round each of its vertices. Numbers of triangles: those of the patch,
// then the walls, then the skin.
class ShapeTriangles {
public:
    explicit ShapeTriangles(const SlitShape& shape) : shape_(shape), skin_(shape.drawing.skin())
    {
        const std::size_t count = first_of_skin();
        for (std::uint32_t t = 0; t < count; ++t)
            for (const std::uint32_t vertex : corners(t)) {
                const auto [n, fresh] = number_.number(vertex);
                if (fresh) round_.emplace_back();
                round_[n].push_back(t);
            }
    }
    std::uint32_t first_wall() const
    {
        return static_cast<std::uint32_t>(shape_.walls.skin.size());
    }
    std::uint32_t first_of_skin() const
    {
        return first_wall() + static_cast<std::uint32_t>(shape_.walls.walls.size());
    }
    std::array<std::uint32_t, 3> corners(std::uint32_t t) const
    {
        if (t < first_wall()) return shape_.walls.skin[t];
        if (t < first_of_skin()) {
            const auto& c = shape_.walls.walls[t - first_wall()].corners;
            return {c[0].vertex, c[1].vertex, c[2].vertex};
        }
        const glm::uvec3& p = skin_.triangle(t - first_of_skin());
        return {p.x, p.y, p.z};
    }
    void around(std::uint32_t vertex, const auto& visit) const // visit(triangle)
    {
        if (const std::uint32_t n = number_.find(vertex); n != KeyNumbers::none)
            for (const std::uint32_t t : round_[n]) visit(t);
        if (vertex >= skin_.point_count() || shape_.graph.node_of_point.contains(vertex)) return;
        skin_.around(vertex, [&](std::uint32_t side) {
            if (!shape_.patch.replaces(side / 3)) visit(first_of_skin() + side / 3);
        });
    }

private:
    const SlitShape& shape_;
    const SlitSkin& skin_;
    KeyNumbers number_; // by vertex
    std::vector<std::vector<std::uint32_t>> round_;
};

// A part of a shape that grows from one vertex.
struct Part {
    KeyNumbers reached; // vertices
    std::vector<std::uint32_t> open;
    std::size_t next = 0;

    explicit Part(std::uint32_t vertex) : open{vertex} { reached.number(vertex); }
    bool whole() const { return next == open.size(); }
    void grow(const ShapeTriangles& all)
    {
        all.around(open[next++], [&](std::uint32_t t) {
            for (const std::uint32_t vertex : all.corners(t))
                if (reached.number(vertex).second) open.push_back(vertex);
        });
    }
};

void mark(const Part& part, const ShapeTriangles& all, const SlitShape& shape, LeftOut& out)
{
    out.patch.resize(shape.walls.skin.size(), 0);
    out.walls.resize(shape.walls.walls.size(), 0);
    for (const std::uint32_t vertex : part.open)
        all.around(vertex, [&](std::uint32_t t) {
            if (t < all.first_wall())
                out.patch[t] = 1;
            else if (t < all.first_of_skin())
                out.walls[t - all.first_wall()] = 1;
            else
                out.skin.push_back(t - all.first_of_skin());
        });
}

} // namespace

LeftOutPieces left_out_pieces(const SlitShape& shape, std::span<const Incision> incisions)
{
    LeftOutPieces out;
    const auto asks = [&](const SlitRun& run) {
        return incisions[run.incision].piece == Incision::Piece::left_out &&
               run.kind != SlitRun::Kind::far_side;
    };
    if (std::ranges::none_of(shape.runs, asks)) return out;
    const ShapeTriangles all(shape);
    for (const SlitRun& run : shape.runs) {
        if (!asks(run)) continue;
        if (run.kind != SlitRun::Kind::through || !run.closed()) {
            out.kept.push_back({run.incision, false});
            continue;
        }
        const std::uint32_t from = run.at[0].point, to = run.at[1].point;
        const SlitNode& node = shape.graph.nodes[shape.graph.node_of_point.find(from)];
        std::size_t way = 0; // of the edge to the next point
        while (shape.graph.edges[node.edges[way]].a + shape.graph.edges[node.edges[way]].b !=
               from + to)
            ++way;
        const std::size_t count = node.edges.size();
        Part left(node.corner(0, way)), right(node.corner(0, (way + count - 1) % count));
        bool apart = true;
        while (apart && !left.whole() && !right.whole()) {
            for (Part* part : {&left, &right})
                if (!part->whole()) part->grow(all);
            apart = !left.reached.contains(right.open.front()) &&
                    !right.reached.contains(left.open.front());
        }
        if (apart)
            mark(left.whole() ? left : right, all, shape, out.pieces);
        else
            out.kept.push_back({run.incision, true});
    }
    std::ranges::sort(out.pieces.skin);
    out.pieces.skin.erase(std::unique(out.pieces.skin.begin(), out.pieces.skin.end()),
                          out.pieces.skin.end());
    return out;
}

} // namespace trivar
