// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/overlaps.h"

#include "core/base/parallel.h"
#include "core/tiles/near_tiles.h"
#include "core/tiles/on_surface.h"

#include <algorithm>

namespace trivar {
namespace {

// Tiles whose normals differ by more than about 70 degrees stand beside an edge, not on each other.
constexpr double least_alike = 0.35;
// The most tiles that one is compared with, so that a heap of them takes no longer.
constexpr int most_compared = 512;

double reach(const TileOutline& tile)
{
    return glm::length(tile.half);
}

bool overlap(const TileOutline& a, const TileOutline& b)
{
    const double side = 2 * std::min(std::max(a.half.x, a.half.y), std::max(b.half.x, b.half.y));
    return overlap_depth(a, b) > overlap_share * side;
}

double mean_reach(std::span<const TileOutline> tiles)
{
    double sum = 0;
    for (const TileOutline& each : tiles) sum += reach(each);
    return tiles.empty() ? 1 : std::max(2 * sum / static_cast<double>(tiles.size()), 1e-300);
}

} // namespace

double overlap_depth(const TileOutline& a, const TileOutline& b)
{
    if (!(reach(a) > 0) || !(reach(b) > 0) || glm::dot(a.n, b.n) < least_alike) return 0;
    const glm::dvec3 n = glm::normalize(a.n + b.n), way = b.p - a.p;
    // In the plane between both, along the axes of each: of two rectangles one of these parts them,
    // if they can be parted.
    struct Axes {
        glm::dvec3 x, y;
    };
    const auto axes = [&](const TileOutline& tile) {
        const glm::dvec3 x = direction_on(tile.x, n);
        return Axes{x, glm::cross(n, x)};
    };
    const Axes of_a = axes(a), of_b = axes(b);
    const auto extent = [](const TileOutline& tile, const Axes& own, const glm::dvec3& along) {
        return tile.half.x * std::abs(glm::dot(own.x, along)) +
               tile.half.y * std::abs(glm::dot(own.y, along));
    };
    double depth = 1e300;
    for (const glm::dvec3& along : {of_a.x, of_a.y, of_b.x, of_b.y})
        depth = std::min(depth, extent(a, of_a, along) + extent(b, of_b, along) -
                                    std::abs(glm::dot(way, along)));
    return std::max(0.0, depth);
}

std::vector<char> overlapping(std::span<const TileOutline> tiles)
{
    NearTiles near(mean_reach(tiles));
    for (std::size_t i = 0; i < tiles.size(); ++i)
        if (reach(tiles[i]) > 0) near.add(tiles[i].p, static_cast<int>(i));
    // Each is compared with those that are no larger, which are near it.
    std::vector<std::vector<int>> found(tiles.size());
    parallel_blocks(tiles.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (!(reach(tiles[i]) > 0)) continue;
            int compared = 0;
            near.any(tiles[i].p, 2 * reach(tiles[i]), [&](int other, double) {
                const auto o = static_cast<std::size_t>(other);
                if (o == i || reach(tiles[o]) > reach(tiles[i])) return false;
                if (overlap(tiles[i], tiles[o])) found[i].push_back(other);
                return ++compared >= most_compared;
            });
        }
    });
    std::vector<char> out(tiles.size(), 0);
    for (std::size_t i = 0; i < found.size(); ++i)
        for (const int other : found[i]) out[i] = out[static_cast<std::size_t>(other)] = 1;
    return out;
}

std::vector<char> overlapping_earlier(std::span<const TileOutline> tiles)
{
    NearTiles kept(mean_reach(tiles));
    double largest = 0; // of those that are kept
    std::vector<char> out(tiles.size(), 0);
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        if (!(reach(tiles[i]) > 0)) continue;
        int compared = 0;
        kept.any(tiles[i].p, reach(tiles[i]) + largest, [&](int other, double) {
            out[i] = overlap(tiles[i], tiles[static_cast<std::size_t>(other)]);
            return out[i] || ++compared >= most_compared;
        });
        if (out[i]) continue;
        kept.add(tiles[i].p, static_cast<int>(i));
        largest = std::max(largest, reach(tiles[i]));
    }
    return out;
}

} // namespace trivar
