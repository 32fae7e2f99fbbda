// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/walls.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trivar {
namespace {

// Rows of a rounded bevel, as shares of its depth; a flat one ends at the last.
constexpr std::array bevel_levels{0.07, 0.25, 0.55, 1.0};

class WallBuilder {
public:
    WallBuilder(const SlitDrawing& drawing, const SlitPatch& patch, SlitGraph& graph,
                std::span<const int> borders)
        : edge_number_(graph.edges.size()),
          first_made_(static_cast<std::uint32_t>(drawing.point_count())),
          patch_(patch),
          graph_(graph),
          borders_(borders)
    {
    }

    SlitWalls operator()(int rows, const std::vector<SlitRun>& runs,
                         const std::vector<ThroughSlit>& throughs)
    {
        for (std::uint32_t e = 0; e < graph_.edges.size(); ++e)
            edge_number_.insert(pair_key(graph_.edges[e].a, graph_.edges[e].b), e);
        for (std::uint32_t n = 0; n < graph_.nodes.size(); ++n) make_column(n, rows);
        cut_skin();
        for (std::uint32_t e = 0; e < graph_.edges.size(); ++e) {
            make_strip(e, true);
            make_strip(e, false);
            if (graph_.edges[e].flat_floor) make_floor(e);
        }
        for (std::uint32_t n = 0; n < graph_.nodes.size(); ++n) close_ends_of_floors(n);
        for (const ThroughSlit& cut : throughs)
            for (const bool left : {true, false})
                join_to_far_side(runs[cut.near], runs[cut.far], cut, left);
        return std::move(out_);
    }

private:
    std::uint32_t made(std::uint32_t node, int depth)
    {
        out_.made.push_back({node, depth});
        return first_made_ + static_cast<std::uint32_t>(out_.made.size()) - 1;
    }

    // Sectors on both sides of an edge are one below its floor; on a V floor too.
    void make_column(std::uint32_t n, int rows)
    {
        SlitNode& node = graph_.nodes[n];
        const std::size_t count = node.edges.size();
        std::vector<int> depths;
        for (const std::uint32_t e : node.edges)
            depths.push_back(graph_.edges[e].depth_at(node.point));
        set_levels(node, depths, rows);
        for (const int level : node.levels) {
            const auto joins = [&](std::size_t i) { // the sectors beside edge i
                const SlitEdge& edge = graph_.edges[node.edges[i]];
                return depths[i] < level ||
                       (depths[i] == level && edge.has_floor() && (level == 0 || !edge.flat_floor));
            };
            std::size_t start = 0;
            while (start < count && joins(start)) ++start;
            const std::size_t row_begin = node.corners.size();
            node.corners.resize(row_begin + count);
            std::uint32_t vertex = level == 0 ? node.point : made(n, level);
            const bool all_one = start == count;
            for (std::size_t k = 0; k < count; ++k) {
                const std::size_t i = all_one ? k : (start + k) % count;
                if (k > 0 && !joins(i)) vertex = made(n, level);
                node.corners[row_begin + i] = vertex;
            }
        }
    }

    void set_levels(SlitNode& node, const std::vector<int>& depths, int rows) const
    {
        node.levels = depths;
        node.levels.push_back(0);
        int deepest = 0, deepest_floor = 0;
        for (std::size_t i = 0; i < depths.size(); ++i) {
            const SlitEdge& edge = graph_.edges[node.edges[i]];
            deepest = std::max(deepest, depths[i]);
            if (edge.has_floor()) deepest_floor = std::max(deepest_floor, depths[i]);
            for (int k = 1; edge.through && k < rows - 1; ++k)
                node.levels.push_back(static_cast<int>(std::int64_t{depths[i]} * k / (rows - 1)));
            for (const double share : bevel_levels) {
                if (share < 1 && !edge.rounded) continue;
                const int bevel = edge.starts_at(node.point) ? edge.bevel_a : edge.bevel_b;
                const int level = static_cast<int>(share * bevel);
                if (level > 0 && level < depths[i]) node.levels.push_back(level);
            }
        }
        const int row = std::max(1, depth_steps / std::max(1, rows));
        for (int level = row; level < deepest_floor; level += row) node.levels.push_back(level);
        for (const int border : borders_)
            if (border > 0 && border < deepest) node.levels.push_back(border);
        std::ranges::sort(node.levels);
        node.levels.erase(std::unique(node.levels.begin(), node.levels.end()), node.levels.end());
    }

    void cut_skin()
    {
        for (std::size_t t = 0; t < patch_.triangles.size(); ++t) {
            std::array<std::uint32_t, 3> corners = patch_.triangles[t].points;
            for (std::size_t k = 0; k < 3; ++k) {
                if (patch_.sectors[t][k] == KeyNumbers::none) continue;
                const SlitNode& node = graph_.nodes[graph_.node_of_point.find(corners[k])];
                corners[k] = node.corner(0, patch_.sectors[t][k]);
            }
            out_.skin.push_back(corners);
        }
    }

    WallCorner corner(std::uint32_t n, std::size_t level, std::size_t sector,
                      std::uint32_t edge) const
    {
        return {graph_.nodes[n].corner(level, sector), n, static_cast<std::uint32_t>(sector), edge};
    }
    void add(const WallCorner& a, const WallCorner& b, const WallCorner& c, int level, bool floor)
    {
        if (a.vertex == b.vertex || b.vertex == c.vertex || c.vertex == a.vertex) return;
        out_.walls.push_back({{a, b, c}, level, floor});
    }
    long layer_of(int level) const
    {
        return std::ranges::upper_bound(borders_, level) - borders_.begin();
    }

    // One side of an edge: the strip between two columns. Next comes the diagonal that reaches less
    // far down, as a share of each column's depth, but no layer is begun on one side before the
    // layer above is finished on the other.
    void make_strip(std::uint32_t e, bool left)
    {
        const SlitEdge& edge = graph_.edges[e];
        const std::uint32_t na = graph_.node_of_point.find(edge.a);
        const std::uint32_t nb = graph_.node_of_point.find(edge.b);
        const SlitNode &a = graph_.nodes[na], &b = graph_.nodes[nb];
        const std::size_t end_a = a.level_number(edge.depth_a),
                          end_b = b.level_number(edge.depth_b);
        const std::size_t ia = a.edge_number(e), ib = b.edge_number(e);
        const std::size_t sa = left ? ia : before(a, ia), sb = left ? before(b, ib) : ib;
        const auto share = [](int level, int whole) {
            return static_cast<double>(level) / std::max(1, whole);
        };
        for (std::size_t i = 0, j = 0; i < end_a || j < end_b;) {
            bool down_a = j == end_b;
            if (i < end_a && j < end_b) {
                const long layer_a = layer_of(a.levels[i]), layer_b = layer_of(b.levels[j]);
                const double step_a = std::abs(share(a.levels[i + 1], edge.depth_a) -
                                               share(b.levels[j], edge.depth_b));
                const double step_b = std::abs(share(b.levels[j + 1], edge.depth_b) -
                                               share(a.levels[i], edge.depth_a));
                down_a = layer_a != layer_b ? layer_a < layer_b : step_a <= step_b;
            }
            const WallCorner x = corner(na, i, sa, e), y = corner(nb, j, sb, e);
            const WallCorner z = down_a ? corner(na, i + 1, sa, e) : corner(nb, j + 1, sb, e);
            const int level = down_a ? a.levels[i] : b.levels[j];
            if (left)
                add(y, x, z, level, false);
            else
                add(x, y, z, level, false);
            ++(down_a ? i : j);
        }
    }
    static std::size_t before(const SlitNode& node, std::size_t i)
    {
        return (i + node.edges.size() - 1) % node.edges.size();
    }

    void make_floor(std::uint32_t e)
    {
        const SlitEdge& edge = graph_.edges[e];
        const std::uint32_t na = graph_.node_of_point.find(edge.a);
        const std::uint32_t nb = graph_.node_of_point.find(edge.b);
        const SlitNode &a = graph_.nodes[na], &b = graph_.nodes[nb];
        const std::size_t la = a.level_number(edge.depth_a), lb = b.level_number(edge.depth_b);
        const std::size_t ia = a.edge_number(e), ib = b.edge_number(e);
        const WallCorner a_left = corner(na, la, ia, e), a_right = corner(na, la, before(a, ia), e);
        const WallCorner b_left = corner(nb, lb, before(b, ib), e), b_right = corner(nb, lb, ib, e);
        const int level = std::max(edge.depth_a, edge.depth_b);
        add(a_right, b_right, b_left, level, true);
        add(a_right, b_left, a_left, level, true);
    }

    // Where U floors end at one level of a node they leave a hole: a polygon if no edge is deeper,
    // otherwise a fan round each corner of the next level.
    void close_ends_of_floors(std::uint32_t n)
    {
        const SlitNode& node = graph_.nodes[n];
        const std::size_t count = node.edges.size();
        for (std::size_t l = 1; l < node.levels.size(); ++l) {
            std::vector<std::size_t> ends, deeper;
            for (std::size_t i = 0; i < count; ++i) {
                const SlitEdge& edge = graph_.edges[node.edges[i]];
                const int depth = edge.depth_at(node.point);
                if (depth == node.levels[l] && edge.flat_floor) ends.push_back(i);
                if (depth > node.levels[l]) deeper.push_back(i);
            }
            if (ends.empty()) continue;
            const auto at = [&](std::size_t level, std::size_t sector) {
                return corner(n, level, sector, node.edges[ends[0]]);
            };
            if (deeper.empty())
                for (std::size_t q = 1; q + 1 < ends.size(); ++q)
                    add(at(l, ends[0]), at(l, ends[q]), at(l, ends[q + 1]), node.levels[l], true);
            for (std::size_t q = 0; q < deeper.size(); ++q) {
                const std::size_t from = deeper[q], to = deeper[(q + 1) % deeper.size()];
                for (std::size_t j = (from + 1) % count; j != to; j = (j + 1) % count)
                    if (std::ranges::binary_search(ends, j))
                        add(at(l + 1, from), at(l, before(node, j)), at(l, j), node.levels[l],
                            true);
            }
        }
    }

    // A point of a run as the side of a wall sees it: along the edge to the next point, or the one
    // before.
    WallCorner corner_of(const SlitRun& run, std::size_t i, bool left, bool to_next) const
    {
        const std::size_t k = to_next ? i : i - 1;
        const std::uint32_t from = run.at[k].point, to = run.at[k + 1].point;
        const std::uint32_t e = edge_number_.find(pair_key(std::min(from, to), std::max(from, to)));
        const std::uint32_t n = graph_.node_of_point.find(run.at[i].point);
        const SlitNode& node = graph_.nodes[n];
        const std::size_t way = node.edge_number(e), other = before(node, way);
        const std::size_t sector = (k == i) == left ? way : other;
        return corner(n, node.level_number(graph_.edges[e].depth_at(node.point)), sector, e);
    }

    // Makes the last row of a wall through the body: between its last levels and the far side,
    // where the left of the cut lies right.
    void join_to_far_side(const SlitRun& near, const SlitRun& far, const ThroughSlit& cut,
                          bool left)
    {
        auto next_crossing = cut.crossings.begin(); // at or after both points
        const auto reached = [&](std::size_t i, std::size_t j) {
            return i >= next_crossing->near && j >= next_crossing->far;
        };
        for (std::size_t k = 0; k + 1 < cut.zip.size(); ++k) {
            const auto [i, j] = cut.zip[k];
            while (next_crossing != cut.crossings.end() && reached(i, j)) ++next_crossing;
            const bool along_near = cut.zip[k + 1].near > i;
            // The point that stays is seen from the side from which the other one comes
            const bool last_near =
                next_crossing == cut.crossings.end() ? i == near.last : i == next_crossing->near;
            const bool last_far =
                next_crossing == cut.crossings.end() ? j == far.last : j == next_crossing->far;
            const WallCorner p = corner_of(near, i, left, !last_near);
            const WallCorner q = corner_of(far, j, !left, !last_far);
            const int level = graph_.edges[p.edge].depth_at(near.at[i].point);
            const WallCorner next = along_near ? corner_of(near, i + 1, left, false)
                                               : corner_of(far, j + 1, !left, false);
            if (left)
                add(p, q, next, level, false);
            else
                add(p, next, q, level, false);
        }
    }

    KeyNumbers edge_number_; // by its two points
    std::uint32_t first_made_;
    const SlitPatch& patch_;
    SlitGraph& graph_;
    std::span<const int> borders_;
    SlitWalls out_;
};

} // namespace

SlitWalls walls_of(const SlitDrawing& drawing, const SlitPatch& patch, SlitGraph& graph, int rows,
                   std::span<const int> borders, const std::vector<SlitRun>& runs,
                   const std::vector<ThroughSlit>& throughs)
{
    return WallBuilder(drawing, patch, graph, borders)(rows, runs, throughs);
}

} // namespace trivar
