// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/tile_brushes.h"

#include "core/limit/tangent.h"
#include "core/tiles/on_surface.h"

#include <algorithm>
#include <optional>

namespace trivar {
namespace {

// The tile that is nearest to a step, within half of its size, and not taken yet.
std::optional<std::size_t> take_nearest(const LaidTiles& laid, const StrokeStep& step,
                                        std::vector<char>& taken)
{
    std::optional<std::size_t> nearest;
    double least = 1e300;
    laid.near.any(step.p, laid.base.diagonal(), [&](int tile, double distance) {
        const auto t = static_cast<std::size_t>(tile);
        const bool within =
            !laid.gone[t] && t < taken.size() && !taken[t] && distance <= 0.5 * laid.tiles[t].size;
        if (within && distance < least) {
            least = distance;
            nearest = t;
        }
        return false;
    });
    if (nearest) taken[*nearest] = 1;
    return nearest;
}

// A Grip lists the tiles that a hand has taken, and the place to which the first goes; nothing, if
// it took none.
struct Grip {
    std::vector<std::size_t> tiles;
    const StrokeStep* to = nullptr;
};

Grip grip_of(const LaidTiles& laid, const std::vector<StrokeStep>& path, std::vector<char>& taken)
{
    Grip grip;
    if (path.empty()) return grip;
    const std::size_t picks = std::max<std::size_t>(1, path.size() - 1);
    for (std::size_t i = 0; i < picks; ++i) {
        const std::optional<std::size_t> t = take_nearest(laid, path[i], taken);
        if (t) grip.tiles.push_back(*t);
        if (grip.tiles.empty()) return grip;
    }
    grip.to = &path.back();
    return grip;
}

void move_along(LaidTiles& laid, const Grip& grip)
{
    if (!grip.to) return;
    const TileBase& base = laid.base;
    const StrokeStep& to = *grip.to;
    const SurfacePlace from = laid.tiles[grip.tiles.front()].at;
    const glm::dvec3 p = base.position(from), n = base.normal(from);
    for (const std::size_t t : grip.tiles) {
        Tile moved = laid.tiles[t];
        const bool first = t == grip.tiles.front();
        // All go as one body; then each comes down to the surface.
        const glm::dvec3 away = base.position(moved.at) - p,
                         own_n = turned_from_to(n, to.n, base.normal(moved.at));
        const double reach = glm::length(away) + moved.size;
        std::optional<SurfacePlace> there = to.at;
        if (!first) {
            const SurfacePoint above{to.p + turned_from_to(n, to.n, away), own_n};
            there = base.locate({&above, 1}, reach).front();
            if (!there) continue;
        }
        laid.gone.replace(t, 1);
        const glm::dvec3 x = turned_from_to(n, to.n, moved.x), new_n = base.normal(*there);
        // Its direction turns as its normal does, by the smallest rotation.
        moved.x = direction_on(first ? x : turned_from_to(own_n, new_n, x), new_n);
        moved.at = *there;
        moved.track = -1;
        laid.add(moved);
    }
}

} // namespace

void change_look(glm::dvec3& tint, double& morph, const TileStroke& stroke, double much)
{
    if (stroke.brush == TileBrush::color) // back to none where the strength is negative
        tint = glm::mix(tint, much < 0 ? glm::dvec3(1) : stroke.color,
                        std::min(1.0, 2 * std::abs(much)));
    else if (stroke.brush == TileBrush::morph)
        morph = std::clamp(morph + much, -1.0, 1.0);
}

void change_tiles(LaidTiles& laid, const TileStroke& stroke, const std::vector<StrokeStep>& path)
{
    const TileBase& base = laid.base;
    // For each tile this is the nearest sample of the stroke on its side of the surface.
    std::unordered_map<int, std::pair<double, std::size_t>> nearest;
    for (std::size_t i = 0; i < path.size(); ++i)
        laid.near.any(path[i].p, stroke.radius, [&](int tile, double distance) {
            const auto t = static_cast<std::size_t>(tile);
            if (laid.gone[t] || !same_side(base.normal(laid.tiles[t].at), path[i].n)) return false;
            const auto [known, added] = nearest.try_emplace(tile, distance, i);
            if (!added && distance < known->second.first) known->second = {distance, i};
            return false;
        });
    for (const auto& [tile, by] : nearest) {
        const auto t = static_cast<std::size_t>(tile);
        const StrokeStep& step = path[by.second];
        const double much = brush_share(by.first, stroke.radius) * stroke.strength * step.pressure;
        Tile each = laid.tiles[t];
        switch (stroke.brush) {
        case TileBrush::erase: laid.gone.replace(t, 1); break;
        case TileBrush::comb: {
            const glm::dvec3 n = base.normal(each.at);
            const double angle = angle_about(each.x, direction_on(step.ahead, n), n);
            each.x = turned_about(each.x, n, angle * std::min(1.0, 2 * much));
            break;
        }
        case TileBrush::resize: each.size *= std::exp2(much); break;
        case TileBrush::raise: each.height *= std::exp2(much); break;
        default: change_look(each.tint, each.morph, stroke, much);
        }
        if (stroke.brush != TileBrush::erase) laid.tiles.replace(t, each);
    }
}

void grab_tiles(LaidTiles& laid, const std::vector<StrokeStep>& path,
                const std::vector<StrokeStep>& mirrored)
{
    std::vector<char> taken(laid.tiles.size(), 0);
    const Grip here = grip_of(laid, path, taken), there = grip_of(laid, mirrored, taken);
    move_along(laid, here);
    move_along(laid, there);
}

void adjust_tiles(LaidTiles& laid, const TileStroke& stroke, const std::vector<StrokeStep>& path,
                  const std::vector<StrokeStep>& mirrored)
{
    std::vector<char> taken(laid.tiles.size(), 0);
    const auto adjust = [&](const std::vector<StrokeStep>& steps, double turn) {
        for (const StrokeStep& step : steps) {
            const std::optional<std::size_t> t = take_nearest(laid, step, taken);
            if (!t) continue;
            Tile tile = laid.tiles[*t];
            tile.x = turned_about(tile.x, laid.base.normal(tile.at), turn);
            tile.size *= stroke.factor;
            laid.tiles.replace(*t, tile);
            if (!(tile.size > 0)) laid.gone.replace(*t, 1);
        }
    };
    adjust(path, glm::radians(stroke.turn_deg));
    adjust(mirrored, -glm::radians(stroke.turn_deg));
}

} // namespace trivar
