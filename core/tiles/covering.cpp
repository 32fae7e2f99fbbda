// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/covering.h"

#include "core/tiles/cell_counts.h"
#include "core/tiles/tile_stroke.h"

#include <algorithm>

namespace trivar {
namespace {

constexpr int steps_per_cell = 3; // between the four nodes of a patch

double share_of_node(int step, int count)
{
    const double in_cell = patch_nodes[static_cast<std::size_t>(step % steps_per_cell)];
    return (step / steps_per_cell + in_cell) / (count / steps_per_cell);
}

std::vector<glm::ivec2> counts_for(const ChartSurface& surface, const std::vector<int>& turns,
                                   const TileCover& cover, const glm::dvec2& tile_size)
{
    const bool even = cover.pattern != TilePattern::grid;
    if (cover.per_face > 0)
        return cell_counts(surface.net(),
                           even ? cover.per_face + cover.per_face % 2 : cover.per_face, most_tiles);
    // Hexagons reach into the rows beside theirs by a quarter of their width in all.
    const double row = cover.pattern == TilePattern::hexagon ? 0.75 : 1;
    return cell_counts(surface, turns, {tile_size.x, row * tile_size.y}, even, most_tiles);
}

std::vector<glm::ivec2> times(std::vector<glm::ivec2> counts, int factor)
{
    for (glm::ivec2& each : counts) each *= factor;
    return counts;
}

// The nodes of each side, from the lower-left corner counter-clockwise along the edges of the
// square.
constexpr std::array<std::array<std::size_t, 4>, 4> side_nodes{
    {{0, 1, 2, 3}, {3, 7, 11, 15}, {15, 14, 13, 12}, {12, 8, 4, 0}}};

// The control points of the cubic through the values at a side's nodes. They come out the same
// whichever way round the side is taken: it is always taken in one of them.
std::array<glm::dvec3, 4> side_curve(const std::array<glm::dvec3, 4>& values, bool backwards)
{
    if (std::ranges::count(values, values[0]) == 4) return values; // a pole, to the last bit
    std::array<glm::dvec3, 16> grid{};
    for (std::size_t k = 0; k < 4; ++k) grid[k] = values[backwards ? 3 - k : k];
    for (std::size_t k = 4; k < 16; ++k) grid[k] = grid[k % 4];
    const std::array<glm::dvec3, 16> c = through_nodes(grid);
    if (backwards) return {c[3], c[2], c[1], c[0]};
    return {c[0], c[1], c[2], c[3]};
}

} // namespace

Covering::Covering(const ChartSurface& surface, const TileCover& cover, const glm::dvec2& tile_size)
    : pattern_(cover.pattern),
      net_(surface.net()),
      turns_(row_turns(net_)),
      counts_(counts_for(surface, turns_, cover, tile_size)),
      nodes_(net_, times(counts_, steps_per_cell))
{
    for (std::uint32_t c = 0; c < net_.size(); ++c) {
        first_.push_back(static_cast<std::uint32_t>(cells_.size()));
        for (int j = 0; j < counts_[c].y; ++j)
            for (int i = 0; i < counts_[c].x; ++i) cells_.push_back({c, i, j});
    }
    lay();
}

std::vector<SurfacePoint> Covering::points(const ChartSurface& surface) const
{
    return points_at(surface, nodes_, share_of_node);
}

std::array<std::uint32_t, 4> Covering::corners(std::uint32_t id) const
{
    const Cell& c = cells_[id];
    std::array<std::uint32_t, 4> out{};
    for (int k = 0; k < 4; ++k) {
        const glm::ivec2 at = glm::ivec2(c.i, c.j) + glm::ivec2(chart_corner(k));
        out[static_cast<std::size_t>(k)] =
            nodes_.node(c.chart, steps_per_cell * at.x, steps_per_cell * at.y);
    }
    return out;
}

std::array<std::uint32_t, 16> Covering::cell_nodes(std::uint32_t id) const
{
    const Cell& c = cells_[id];
    std::array<std::uint32_t, 16> out{};
    for (int b = 0; b < 4; ++b)
        for (int a = 0; a < 4; ++a)
            out[static_cast<std::size_t>(4 * b + a)] =
                nodes_.node(c.chart, steps_per_cell * c.i + a, steps_per_cell * c.j + b);
    return out;
}

TilePatch Covering::patch(std::uint32_t id, std::span<const SurfacePoint> points) const
{
    const std::array<std::uint32_t, 16> ids = cell_nodes(id);
    std::array<glm::dvec3, 16> p{}, n{};
    for (std::size_t k = 0; k < 16; ++k) {
        p[k] = points[ids[k]].p;
        n[k] = points[ids[k]].normal;
    }
    TilePatch patch{through_nodes(p), through_nodes(n)};
    for (const std::array<std::size_t, 4>& side : side_nodes) {
        std::array<glm::dvec3, 4> on_p{}, on_n{};
        for (std::size_t k = 0; k < 4; ++k) on_p[k] = p[side[k]], on_n[k] = n[side[k]];
        const bool backwards =
            std::pair(ids[side[3]], ids[side[2]]) < std::pair(ids[side[0]], ids[side[1]]);
        const auto curve_p = side_curve(on_p, backwards), curve_n = side_curve(on_n, backwards);
        for (std::size_t k = 0; k < 4; ++k) {
            patch.p[side[k]] = curve_p[k];
            patch.n[side[k]] = curve_n[k];
        }
    }
    return patch;
}

std::uint32_t Covering::cell_at(std::uint32_t chart, int i, int j) const
{
    return first_[chart] + static_cast<std::uint32_t>(j * counts_[chart].x + i);
}

Covering::Beside Covering::beside(std::uint32_t id, int side) const
{
    const Cell& c = cells_[id];
    const glm::ivec2 step(out_of_edge(side)), next = glm::ivec2(c.i, c.j) + step;
    const glm::ivec2& n = counts_[c.chart];
    if (next.x >= 0 && next.x < n.x && next.y >= 0 && next.y < n.y)
        return {cell_at(c.chart, next.x, next.y), (side + 2) % 4};
    const ChartNet::Side& other = net_.across(c.chart, side);
    if (other.chart == ChartNet::none) return {};
    // The number of cells before it along the edge, which the other chart counts from its other
    // end.
    const std::array<int, 4> before{c.i, c.j, n.x - 1 - c.i, n.y - 1 - c.j};
    const int along = side % 2 == 0 ? n.x : n.y;
    const int k = along - 1 - before[static_cast<std::size_t>(side)];
    const glm::ivec2& m = counts_[other.chart];
    switch (other.edge) {
    case 0: return {cell_at(other.chart, k, 0), 0};
    case 1: return {cell_at(other.chart, m.x - 1, k), 1};
    case 2: return {cell_at(other.chart, m.x - 1 - k, m.y - 1), 2};
    default: return {cell_at(other.chart, 0, m.y - 1 - k), 3};
    }
}

bool Covering::row_goes_on(std::uint32_t id, int side) const
{
    const Beside next = beside(id, side);
    if (next.cell == ChartNet::none) return false;
    const std::uint32_t from = cells_[id].chart, to = cells_[next.cell].chart;
    return ((turns_[from] + next.side - side + 2) & 3) == turns_[to];
}

// The number of a cell's row in its chart, counted across the rows.
int Covering::row_of(std::uint32_t id) const
{
    const Cell& c = cells_[id];
    const glm::ivec2& n = counts_[c.chart];
    switch (turns_[c.chart]) {
    case 0: return c.j;
    case 1: return n.x - 1 - c.i;
    case 2: return n.y - 1 - c.j;
    default: return c.i;
    }
}

void Covering::lay()
{
    for (std::uint32_t id = 0; id < cells_.size(); ++id) {
        const int turns = turns_[cells_[id].chart];
        const auto side = [&](int of_tile) { return (of_tile + turns) % 4; };
        const bool hexagon = pattern_ == TilePattern::hexagon;
        Laid tile{id};
        if (hexagon) {
            tile.flat_before = !row_goes_on(id, side(0));
            tile.flat_behind = !row_goes_on(id, side(2));
        }
        const auto add = [&](Extent extent) {
            tile.extent = extent;
            tiles_.push_back(tile);
        };
        const bool shifted = pattern_ != TilePattern::grid && row_of(id) % 2 == 1;
        if (!shifted) {
            add(Extent::whole);
            continue;
        }
        // Where rows go on they keep their shift: the numbers of cells are even.
        if (!row_goes_on(id, side(3))) add(Extent::first);
        add(row_goes_on(id, side(1)) ? Extent::spanning : Extent::second);
    }
}

glm::dvec2 Covering::in_chart(std::uint32_t cell, const glm::dvec2& uv) const
{
    const Cell& at = cells_[cell];
    const glm::dvec2 whole = (glm::dvec2(at.i, at.j) + uv) / glm::dvec2(counts_[at.chart]);
    return {snapped(whole.x), snapped(whole.y)};
}

Covering::Spot Covering::spot(const Laid& tile, const glm::dvec2& at) const
{
    Spot out{tile.cell, at};
    const bool hexagon = pattern_ == TilePattern::hexagon;
    if (hexagon) {
        // The outline's height over the middle line at x: 2/3 in the middle, 1/3 at both ends.
        const double outline = 2.0 / 3 - std::abs(at.x - 0.5) * 2.0 / 3;
        const bool flat = at.y < 0.5 ? tile.flat_before : tile.flat_behind;
        if (flat) out.uv.y = snapped(0.5 + (at.y - 0.5) * 0.5 / std::max(outline, 1.0 / 3));
    }
    switch (tile.extent) {
    case Extent::whole: break;
    case Extent::spanning: out.uv.x = at.x + 0.5; break;
    case Extent::first:
        out.uv.x = hexagon ? std::max(at.x - 0.5, 0.0) : 0.5 * at.x;
        out.along = hexagon ? 1 : 0.5;
        break;
    case Extent::second:
        out.uv.x = hexagon ? std::min(at.x + 0.5, 1.0) : 0.5 * at.x + 0.5;
        out.along = hexagon ? 1 : 0.5;
        break;
    }
    // Turns the tile's directions to the chart's, about the middle of the cell.
    out.turns = turns_[cells_[tile.cell].chart];
    switch (out.turns) {
    case 1: out.uv = {1 - out.uv.y, out.uv.x}; break;
    case 2: out.uv = {1 - out.uv.x, 1 - out.uv.y}; break;
    case 3: out.uv = {out.uv.y, 1 - out.uv.x}; break;
    default: break;
    }
    constexpr int most_cells_crossed = 8;
    for (int crossed = 0; crossed < most_cells_crossed; ++crossed) {
        const glm::dvec2& q = out.uv;
        const int side = q.x < 0 ? 3 : q.x > 1 ? 1 : q.y < 0 ? 0 : q.y > 1 ? 2 : -1;
        if (side < 0) break;
        const Beside next = beside(out.cell, side);
        if (next.cell == ChartNet::none) break;
        // The place along the side, as the next cell counts it, and beyond it.
        const std::array<double, 4> along{q.x, q.y, 1 - q.x, 1 - q.y},
            beyond{-q.y, q.x - 1, q.y - 1, -q.x};
        const double t = 1 - along[static_cast<std::size_t>(side)],
                     s = beyond[static_cast<std::size_t>(side)];
        switch (next.side) {
        case 0: out.uv = {t, s}; break;
        case 1: out.uv = {1 - s, t}; break;
        case 2: out.uv = {1 - t, 1 - s}; break;
        default: out.uv = {s, 1 - t}; break;
        }
        out.turns = (out.turns + next.side - side + 2) & 3;
        out.cell = next.cell;
    }
    return out;
}

} // namespace trivar
