// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/split/opening_wall.h"

#include "core/base/parallel.h"
#include "core/split/wall_certificate.h"

#include <algorithm>

namespace trivar {
namespace {

constexpr int along = 26;                    // control points by v
constexpr int fewest = 14, most_across = 72; // by w
constexpr int grid = 160;                    // columns along either axis
constexpr int most_sweeps = 400;

// Metres that a lift adds so that it ends; less for what is tiny, and as much as numbers can tell.
double lift_rest(const Box& box)
{
    const double size = glm::length(box.size());
    return std::max(std::min(1e-6, 1e-4 * size), 1e-11 * size);
}

// A long obstacle has more of them.
int points_across(const Box& box)
{
    return static_cast<int>(
        std::clamp(6 * box.size().z / box.size().y + 7, double{fewest}, double{most_across}));
}

// A Need is the height that a wall must reach at one place: metres below and above the cut surface.
struct Need {
    glm::dvec2 vw;
    std::array<double, 2> height;
};

std::vector<Need> needs(const ObstacleColumns& columns, const CutSurface& surface, double clearance,
                        const std::vector<glm::dvec2>& at)
{
    const std::vector<std::optional<glm::dvec2>> extents = columns.at(at);
    std::vector<Need> out;
    for (std::size_t k = 0; k < at.size(); ++k) {
        if (!extents[k]) continue;
        const double phi = evaluate(surface, at[k]).value;
        out.push_back({at[k], {phi - extents[k]->x + clearance, extents[k]->y - phi + clearance}});
    }
    return out;
}

// Rows of control points that are 0 at either end along v.
int rows_at_ends(SplitEnds ends)
{
    return ends == SplitEnds::smooth ? 3 : 1;
}

bool fixed(const Surface<double>& wall, int rows, int i, int j)
{
    return i < rows || i >= wall.axes[0].count() - rows || j == 0 || j == wall.axes[1].count() - 1;
}

// Raises control points, each by as much as the neediest sample asks of it, until none is short.
// A sample that is short by r would be lifted enough by r b / sum b^2 alone; the largest of these
// only adds.
void lift(Surface<double>& wall, int rows_at_end, const std::vector<Need>& samples,
          std::size_t side, double rest)
{
    struct Row {
        std::array<double, 16> weight;
        std::array<std::size_t, 16> index;
        double squares, target;
    };
    std::vector<Row> rows(samples.size());
    parallel_blocks(samples.size(), 2048, [&](std::size_t begin, std::size_t end) {
        for (std::size_t s = begin; s < end; ++s) {
            const Basis a = basis(wall.axes[0], samples[s].vw.x);
            const Basis b = basis(wall.axes[1], samples[s].vw.y);
            Row& row = rows[s];
            row.squares = 0;
            row.target = samples[s].height[side] + rest;
            for (std::size_t k = 0; k < 16; ++k) {
                const int i = a.first + static_cast<int>(k / 4),
                          j = b.first + static_cast<int>(k % 4);
                row.weight[k] = a.value[k / 4] * b.value[k % 4];
                row.index[k] = wall.index(i, j);
                if (!fixed(wall, rows_at_end, i, j)) row.squares += row.weight[k] * row.weight[k];
            }
        }
    });
    std::vector<double> more(wall.points.size());
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
        std::ranges::fill(more, 0.0);
        bool short_of = false;
        for (const Row& row : rows) {
            double value = 0;
            for (std::size_t k = 0; k < 16; ++k) value += row.weight[k] * wall.points[row.index[k]];
            const double missing = row.target - value;
            if (missing <= 1e-3 * rest || row.squares <= 0) continue;
            short_of = true;
            for (std::size_t k = 0; k < 16; ++k)
                more[row.index[k]] =
                    std::max(more[row.index[k]], missing * row.weight[k] / row.squares);
        }
        if (!short_of) break;
        for (int i = rows_at_end; i + rows_at_end < wall.axes[0].count(); ++i)
            for (int j = 1; j + 1 < wall.axes[1].count(); ++j)
                wall.points[wall.index(i, j)] += more[wall.index(i, j)];
    }
}

// Lifts a wall at points of the obstacle that it is too near to, until none is.
void certify(const ObstacleColumns& columns, const CutSurface& surface, double clearance,
             OpeningWall& wall, int rows_at_end, std::size_t side)
{
    constexpr int most_lifts = 8;
    // metres: with less nothing is made certain
    const double least_clearance = std::min(1e-4, 1e-2 * glm::length(columns.box().size()));
    if (clearance < least_clearance) return;
    for (int round = 0; round < most_lifts; ++round) {
        const WallCertificate known =
            certificate(columns, surface, wall.height, side, clearance / 2);
        wall.clear = known.clear;
        if (known.too_near.empty()) return;
        std::vector<Need> samples;
        for (const glm::dvec3& p : known.too_near) {
            const double phi = evaluate(surface, {p.y, p.z}).value;
            samples.push_back({{p.y, p.z}, {phi - p.x + clearance, p.x - phi + clearance}});
        }
        lift(wall.height, rows_at_end, samples, side, lift_rest(columns.box()));
    }
}

} // namespace

SplitRectangle opening_rectangle(const ObstacleColumns& columns, double clearance, double margin)
{
    const Box& box = columns.box();
    const double more = margin * box.size().y + clearance;
    // Along w the wall falls to 0 over two cells, so that its control points need not be high
    const double more_w = std::max(more, 2 * box.size().z / (points_across(box) - 7) + clearance);
    return {{box.lo.y - more, box.lo.z - more_w}, {box.hi.y + more, box.hi.z + more_w}};
}

std::array<OpeningWall, 2> opening_walls(const ObstacleColumns& columns, const CutSurface& surface,
                                         const SplitRectangle& over, double clearance,
                                         SplitEnds ends)
{
    const Box& box = columns.box();
    const int rows = rows_at_ends(ends);
    const int across = points_across(box);
    const std::array<Knots, 2> axes{Knots::uniform(4, along, over.lo.x, over.hi.x),
                                    Knots::uniform(4, across, over.lo.y, over.hi.y)};
    std::vector<glm::dvec2> at;
    for (int i = 0; i < grid; ++i)
        for (int j = 0; j <= grid; ++j)
            at.emplace_back(box.lo.y + box.size().y * (i + 0.5) / grid,
                            box.lo.z + box.size().z * j / double{grid});
    for (const glm::dvec3& p : columns.vertices()) at.emplace_back(p.y, p.z);
    std::vector<Need> samples = needs(columns, surface, clearance, at);
    // A ray may slip past a vertex on the rim of the shadow
    for (const glm::dvec3& p : columns.vertices()) {
        const double phi = evaluate(surface, {p.y, p.z}).value;
        samples.push_back({{p.y, p.z}, {phi - p.x + clearance, p.x - phi + clearance}});
    }
    std::vector<glm::dvec2> sites;
    for (int i = 0; i < along; ++i)
        for (int j = 0; j < across; ++j)
            sites.emplace_back(axes[0].greville(i), axes[1].greville(j));
    const std::vector<std::optional<glm::dvec2>> extents = columns.at(sites);

    std::array<OpeningWall, 2> out{OpeningWall{{axes, std::vector<double>(sites.size())}, 0},
                                   OpeningWall{{axes, std::vector<double>(sites.size())}, 0}};
    for (std::size_t side = 0; side < 2; ++side) {
        Surface<double>& wall = out[side].height;
        for (int i = rows; i + rows < along; ++i)
            for (int j = 1; j + 1 < across; ++j) {
                const std::size_t k = wall.index(i, j);
                if (!extents[k]) continue;
                const double phi = evaluate(surface, sites[k]).value;
                wall.points[k] = std::max(
                    0.0, (side == 0 ? phi - extents[k]->x : extents[k]->y - phi) + clearance);
            }
        lift(wall, rows, samples, side, lift_rest(box));
        certify(columns, surface, clearance, out[side], rows, side);
        out[side].most = *std::ranges::max_element(wall.points);
    }
    return out;
}

} // namespace trivar
