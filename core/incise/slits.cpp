// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/slits.h"

#include "core/base/mistake.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

constexpr int part_of_floor = 4; // floors that are alike differ by less than this part of them

struct EdgeEnd {
    std::uint32_t edge;
    bool at_a;
};
int& depth_of(std::vector<SlitEdge>& edges, const EdgeEnd& end)
{
    return end.at_a ? edges[end.edge].depth_a : edges[end.edge].depth_b;
}

// Ends of edges by point; points are numbered in the order in which they come.
struct EdgeEnds {
    KeyNumbers number;
    std::vector<std::uint32_t> points;
    std::vector<std::vector<EdgeEnd>> ends;

    explicit EdgeEnds(const std::vector<SlitEdge>& edges)
    {
        for (std::uint32_t e = 0; e < edges.size(); ++e)
            for (const bool at_a : {true, false}) {
                const std::uint32_t point = at_a ? edges[e].a : edges[e].b;
                const auto [i, fresh] = number.number(point);
                if (fresh) {
                    points.push_back(point);
                    ends.emplace_back();
                }
                ends[i].push_back({e, at_a});
            }
    }
};

// Sets the floor of an edge. If several runs pass over it, the one through the body decides, else
// the deepest.
void set_floor(SlitEdge& edge, SlitRun::Kind kind, int depth_a, int depth_b, bool flat)
{
    if (kind == SlitRun::Kind::far_side) {
        edge.far_side = true;
        return;
    }
    if (edge.through) return;
    if (kind == SlitRun::Kind::through) {
        edge.through = true;
        edge.flat_floor = false;
        edge.depth_a = depth_a;
        edge.depth_b = depth_b;
        return;
    }
    edge.depth_a = std::max(edge.depth_a, depth_a);
    edge.depth_b = std::max(edge.depth_b, depth_b);
    edge.flat_floor = edge.flat_floor || flat;
}

std::vector<SlitEdge> edges_of(const std::vector<SlitRun>& runs,
                               const std::vector<SlitPiece>& pieces,
                               std::span<const Incision> incisions, double step)
{
    std::vector<SlitEdge> edges;
    KeyNumbers number;
    std::uint32_t first_piece = 0;
    for (std::uint32_t k = 0; k < runs.size(); ++k) {
        std::uint32_t last_piece = first_piece;
        while (last_piece < pieces.size() && pieces[last_piece].run == k) ++last_piece;
        const std::vector<SlitRun::At>& at = runs[k].at;
        for (std::size_t i = 0; i + 1 < at.size(); ++i) {
            const bool forward = at[i].point < at[i + 1].point;
            const SlitRun::At &a = forward ? at[i] : at[i + 1], &b = forward ? at[i + 1] : at[i];
            const auto [e, fresh] = number.number(pair_key(a.point, b.point));
            if (fresh) {
                SlitEdge edge;
                edge.a = a.point;
                edge.b = b.point;
                edges.push_back(edge);
            }
            SlitEdge& edge = edges[e];
            const auto steps = [&](double depth) {
                return static_cast<int>(std::lround(depth / step));
            };
            const Incision& incision = incisions[runs[k].incision];
            set_floor(edge, runs[k].kind, steps(a.depth), steps(b.depth),
                      incision.floor == Incision::Floor::u);
            if (runs[k].kind != SlitRun::Kind::far_side && incision.bevel > 0) {
                edge.bevel_a = std::max(edge.bevel_a, steps(bevel_at(runs[k], incision, a.s)));
                edge.bevel_b = std::max(edge.bevel_b, steps(bevel_at(runs[k], incision, b.s)));
                edge.rounded = edge.rounded || incision.roundness > 0;
            }
            for (std::uint32_t p = first_piece; p < last_piece; ++p) {
                if (!(at[i + 1].s > pieces[p].begin && at[i].s < pieces[p].end)) continue;
                if (std::ranges::count(edge.passes, p, &SlitEdge::Pass::piece) > 0) continue;
                edge.passes.push_back({p, a.s, b.s, forward});
            }
        }
        first_piece = last_piece;
    }
    return edges;
}

// Floors that are nearly one at a node become the deepest of them.
void unite_floors(std::vector<SlitEdge>& edges, int alike)
{
    EdgeEnds all(edges);
    for (std::vector<EdgeEnd>& ends : all.ends) {
        std::erase_if(ends, [&](const EdgeEnd& end) { return !edges[end.edge].has_floor(); });
        std::ranges::stable_sort(ends, std::greater(),
                                 [&](const EdgeEnd& end) { return depth_of(edges, end); });
        for (std::size_t i = 1; i < ends.size(); ++i) {
            const int deeper = depth_of(edges, ends[i - 1]);
            int& depth = depth_of(edges, ends[i]);
            if (depth > 0 && deeper - depth < std::min(alike, deeper / part_of_floor))
                depth = deeper;
        }
    }
}

// Floors end at walls through the body, above their last rows.
void keep_floors_above_last_rows(std::vector<SlitEdge>& edges)
{
    EdgeEnds all(edges);
    for (const std::vector<EdgeEnd>& ends : all.ends)
        for (const EdgeEnd& through : ends) {
            if (!edges[through.edge].through) continue;
            const int most = depth_of(edges, through) - 1;
            for (const EdgeEnd& end : ends)
                if (edges[end.edge].has_floor())
                    depth_of(edges, end) = std::min(depth_of(edges, end), most);
        }
}

// A wall that ended alone in its depth would hang free: both its sides would be one column.
bool lower_free_floors(std::vector<SlitEdge>& edges, const SlitDrawing& drawing,
                       const Inward& inward)
{
    bool changed = false;
    const EdgeEnds all(edges);
    for (std::size_t n = 0; n < all.points.size(); ++n) {
        int deepest = 0, next = 0;
        for (const EdgeEnd& end : all.ends[n]) {
            const int depth = depth_of(edges, end);
            next = std::max(next, std::min(depth, deepest));
            deepest = std::max(deepest, depth);
        }
        if (!inward.has_inside(drawing.point(all.points[n]))) next = 0;
        for (const EdgeEnd& end : all.ends[n]) {
            if (!edges[end.edge].has_floor()) continue;
            int& depth = depth_of(edges, end);
            changed = changed || depth > next;
            depth = std::min(depth, next);
        }
    }
    return changed;
}

} // namespace

std::size_t SlitNode::edge_number(std::uint32_t edge) const
{
    const auto found = std::ranges::find(edges, edge);
    ensure(found != edges.end(), "an edge of a slit does not meet its node");
    return static_cast<std::size_t>(found - edges.begin());
}

std::size_t SlitNode::level_number(int depth) const
{
    return static_cast<std::size_t>(std::ranges::lower_bound(levels, depth) - levels.begin());
}

SlitGraph slits_of(const std::vector<SlitRun>& runs, const std::vector<SlitPiece>& pieces,
                   std::span<const Incision> incisions, const SlitDrawing& drawing,
                   const Inward& inward, double step, int alike)
{
    SlitGraph graph;
    graph.edges = edges_of(runs, pieces, incisions, step);
    unite_floors(graph.edges, alike);
    keep_floors_above_last_rows(graph.edges);
    do
        std::erase_if(graph.edges, [](const SlitEdge& e) {
            return e.depth_a == 0 && e.depth_b == 0 && !e.far_side;
        });
    while (lower_free_floors(graph.edges, drawing, inward));
    EdgeEnds all(graph.edges);
    for (std::size_t n = 0; n < all.points.size(); ++n) {
        SlitNode node;
        node.point = all.points[n];
        for (const EdgeEnd& end : all.ends[n]) node.edges.push_back(end.edge);
        graph.nodes.push_back(std::move(node));
    }
    graph.node_of_point = std::move(all.number);
    return graph;
}

} // namespace trivar
