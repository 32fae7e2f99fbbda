// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/cover_heights.h"

#include "core/base/parallel.h"
#include "core/tiles/fold_limit.h"

#include <algorithm>

namespace trivar {
namespace {

// The mean of the two sides of a cell along its row, by chords between their nodes.
double row_length(const Covering& covering, std::uint32_t cell,
                  std::span<const SurfacePoint> points)
{
    const std::array<std::uint32_t, 16> ids = covering.cell_nodes(cell);
    const bool along_u = covering.turns(cell) % 2 == 0;
    double sum = 0;
    for (const std::size_t side : {0, 3})
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t a = along_u ? 4 * side + k : 4 * k + side, b = a + (along_u ? 1 : 4);
            sum += glm::distance(points[ids[a]].p, points[ids[b]].p);
        }
    return sum / 2;
}

} // namespace

std::vector<double> heights_along_rows(const Covering& covering,
                                       std::span<const SurfacePoint> points, double factor)
{
    std::vector<double> sums(points.size(), 0);
    std::vector<int> counts(points.size(), 0);
    for (std::uint32_t c = 0; c < covering.cell_count(); ++c) {
        const double length = row_length(covering, c, points);
        for (const std::uint32_t node : covering.corners(c)) {
            sums[node] += length;
            ++counts[node];
        }
    }
    for (std::size_t n = 0; n < sums.size(); ++n)
        if (counts[n] > 0) sums[n] *= factor / counts[n];
    return sums;
}

GuardedHeights guarded_heights(const Covering& covering, const CoveringPose& pose, double top)
{
    const std::size_t count = covering.cell_count();
    GuardedHeights out{pose.heights, std::vector<char>(count, 0), std::vector<char>(count, 0),
                       std::vector<double>(count, 0)};
    if (!(top > 0)) return out;
    std::vector<double> highest(count);
    parallel_blocks(count, 64, [&](std::size_t begin, std::size_t end) {
        std::vector<TilePatch> patches;
        for (std::size_t c = begin; c < end; ++c)
            patches.push_back(upright_patch(covering, static_cast<std::uint32_t>(c), pose));
        const std::vector<double> limits = fold_limits(patches);
        for (std::size_t c = begin; c < end; ++c)
            highest[c] = proven_share * limits[c - begin] / top;
    });
    for (std::uint32_t c = 0; c < count; ++c) {
        out.folded[c] = !(highest[c] > 0);
        if (out.folded[c]) continue;
        for (const std::uint32_t node : covering.corners(c)) {
            if (pose.heights[node] > highest[c]) out.lowered[c] = 1;
            out.of_limit[c] = std::max(out.of_limit[c], pose.heights[node] / highest[c]);
            out.heights[node] = std::min(out.heights[node], highest[c]);
        }
    }
    return out;
}

} // namespace trivar
