// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/tile_brushes.h"

#include "core/limit/tangent.h"
#include "core/tiles/on_surface.h"

#include <algorithm>

namespace trivar {
namespace {

double falloff(double distance, double radius) // 1 in the middle, 0 and flat at the rim
{
    const double r = std::min(1.0, distance / radius), s = 1 - r * r;
    return s * s;
}

} // namespace

void change_tiles(LaidTiles& laid, const TileStroke& stroke, const std::vector<StrokeStep>& path)
{
    const TileBase& base = laid.base;
    // For each tile this is the nearest sample of the stroke on its side of the surface.
    std::unordered_map<int, std::pair<double, std::size_t>> nearest;
    for (std::size_t i = 0; i < path.size(); ++i)
        laid.near.any(path[i].p, stroke.radius, [&](int tile, double distance) {
            const auto t = static_cast<std::size_t>(tile);
            if (laid.gone[t] || glm::dot(base.normal(laid.tiles[t].at), path[i].n) < -0.2)
                return false;
            const auto [known, added] = nearest.try_emplace(tile, distance, i);
            if (!added && distance < known->second.first) known->second = {distance, i};
            return false;
        });
    for (const auto& [tile, by] : nearest) {
        const auto t = static_cast<std::size_t>(tile);
        const StrokeStep& step = path[by.second];
        const double much = falloff(by.first, stroke.radius) * stroke.strength * step.pressure;
        Tile& each = laid.tiles[t];
        switch (stroke.brush) {
        case TileBrush::erase: laid.gone[t] = 1; break;
        case TileBrush::comb: {
            const glm::dvec3 n = base.normal(each.at);
            const double angle = angle_about(each.x, direction_on(step.ahead, n), n);
            each.x = turned_about(each.x, n, angle * std::min(1.0, 2 * much));
            break;
        }
        case TileBrush::resize: each.size *= std::exp2(much); break;
        case TileBrush::raise: each.height *= std::exp2(much); break;
        default: break;
        }
    }
}

void grab_tile(LaidTiles& laid, const std::vector<StrokeStep>& path)
{
    const StrokeStep &from = path.front(), &to = path.back();
    std::size_t nearest = laid.tiles.size();
    double least = 1e300;
    laid.near.any(from.p, laid.base.diagonal(), [&](int tile, double distance) {
        const auto t = static_cast<std::size_t>(tile);
        const bool within = !laid.gone[t] && distance <= 0.5 * laid.tiles[t].size;
        if (within && distance < least) {
            least = distance;
            nearest = t;
        }
        return false;
    });
    if (nearest == laid.tiles.size()) return;
    Tile moved = laid.tiles[nearest];
    laid.gone[nearest] = 1;
    // Its direction turns as its normal does, by the smallest rotation.
    moved.x = direction_on(turned_from_to(laid.base.normal(moved.at), to.n, moved.x), to.n);
    moved.at = to.at;
    laid.add(moved);
}

} // namespace trivar
