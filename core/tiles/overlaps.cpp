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

OverlapCount::OverlapCount(std::span<const TileOutline> usual) : near_(mean_reach(usual)) {}

void OverlapCount::add(std::span<const TileOutline> tiles)
{
    const std::size_t before = tiles_.size();
    const double largest = largest_;
    for (const TileOutline& each : tiles) largest_ = std::max(largest_, reach(each));
    tiles_.insert(tiles_.end(), tiles.begin(), tiles.end());
    pairs_of_.resize(tiles_.size(), 0);
    for (std::size_t i = before; i < tiles_.size(); ++i)
        if (reach(tiles_[i]) > 0) near_.add(tiles_[i].p, static_cast<int>(i));
    std::vector<std::vector<std::size_t>> found(tiles.size());
    parallel_blocks(tiles.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const std::size_t i = before + k;
            const TileOutline& tile = tiles_[i];
            if (!(reach(tile) > 0)) continue;
            // Each is compared with those that are no larger, which are near it.
            int compared = 0;
            near_.any(tile.p, 2 * reach(tile), [&](int other, double) {
                const auto o = static_cast<std::size_t>(other);
                if (o == i || reach(tiles_[o]) > reach(tile)) return false;
                if (overlap(tile, tiles_[o])) found[k].push_back(o);
                return ++compared >= most_compared;
            });
            compared = 0; // those that were there before and are larger
            if (largest > reach(tile))
                near_.any(tile.p, 2 * largest, [&](int other, double distance) {
                    const auto o = static_cast<std::size_t>(other);
                    const double far = 2 * reach(tiles_[o]);
                    if (o >= before || reach(tiles_[o]) <= reach(tile) || distance > far)
                        return false;
                    if (overlap(tiles_[o], tile)) found[k].push_back(o);
                    return ++compared >= most_compared;
                });
        }
    });
    const auto known = static_cast<std::ptrdiff_t>(pairs_.size());
    for (std::size_t k = 0; k < found.size(); ++k)
        for (const std::size_t o : found[k]) {
            pairs_.emplace_back(std::max(o, before + k), std::min(o, before + k));
            overlapping_ += pairs_of_[o]++ == 0;
            overlapping_ += pairs_of_[before + k]++ == 0;
        }
    std::sort(pairs_.begin() + known, pairs_.end());
}

void OverlapCount::keep(std::size_t count)
{
    while (!pairs_.empty() && pairs_.back().first >= count) {
        overlapping_ -= --pairs_of_[pairs_.back().first] == 0;
        overlapping_ -= --pairs_of_[pairs_.back().second] == 0;
        pairs_.pop_back();
    }
    for (std::size_t i = tiles_.size(); i > count; --i)
        if (reach(tiles_[i - 1]) > 0) near_.remove_last();
    tiles_.resize(count);
    pairs_of_.resize(count);
}

std::vector<char> overlapping(std::span<const TileOutline> tiles)
{
    OverlapCount all(tiles);
    all.add(tiles);
    std::vector<char> out(tiles.size());
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = all.overlaps(i);
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
