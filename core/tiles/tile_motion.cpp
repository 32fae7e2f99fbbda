// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/tile_motion.h"

#include "core/base/parallel.h"
#include "core/base/smooth_step.h"
#include "core/tiles/on_surface.h"
#include "core/tiles/straightest.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>
#include <limits>

namespace trivar {
namespace {

} // namespace

TileMotion motion_of(const TileLook& look, const TileLayout& layout, const Tile& tile,
                     const glm::dvec3& p)
{
    TileMotion motion;
    if (look.growth < 1) {
        const double when = layout.duration_s > 0 ? tile.time_s / layout.duration_s : 0;
        const double soft = std::max(look.growth_softness, 1e-6);
        const double since = look.growth * (1 + soft) - when;
        motion.size = smooth_step(since / soft);
    }
    if (look.wave != 0) {
        const double length = glm::length(look.wave_direction);
        const double along = length > 0 ? glm::dot(p, look.wave_direction / length) : p.z;
        const double turns = look.wave_phase +
                             look.wave_variation * random_share(tile.seed, random_purpose::wave) -
                             (look.wave_length > 0 ? along / look.wave_length : 0);
        motion.height = std::max(0.0, 1 + look.wave * std::sin(glm::two_pi<double>() * turns));
    }
    return motion;
}

double morph_of(const TileLook& look, double share)
{
    const double behind = look.morph_variation;
    if (!(behind > 0)) return look.morph;
    return std::clamp(look.morph * (1 + behind) - behind * share, std::min(0.0, look.morph),
                      std::max(1.0, look.morph));
}

std::optional<Tile> slid_along(const TileBase& base, const Tile& tile, const StrokeTrack& track,
                               double sides)
{
    const auto from = point_on(base, track, tile.along),
               to = point_on(base, track, tile.along + sides * track.side);
    if (!from || !to) return {};
    const glm::dvec3 n = base.normal(tile.at), m = base.normal(to->at);
    Tile there = tile;
    there.at = to->at;
    // The x axis keeps its angle to the stroke.
    const double angle = angle_about(direction_on(from->ahead, n), tile.x, n);
    there.x = turned_about(direction_on(to->ahead, m), m, angle);
    return there;
}

std::optional<Tile> slid(const TileBase& base, const Tile& tile, const TileLook& look)
{
    const glm::dvec2 slide(look.slide_x, tile.mirrored ? -look.slide_y : look.slide_y);
    const double length = glm::length(slide);
    if (!(length > 0)) return tile;
    const glm::dvec3 n = base.normal(tile.at);
    const glm::dvec3 x = turned_about(tile.x, n, glm::radians(turn_of(tile, look.turn_deg))),
                     y = glm::cross(n, x);
    const glm::dvec2 to = slide / length;
    const glm::dvec3 ahead = to.x * x + to.y * y;
    const SurfaceRay ray = straightest(base, tile.at, tile.size * look.scale * length * ahead);
    if (ray.left > 0) return {};
    Tile there = tile;
    there.at = ray.at;
    const glm::dvec3 m = base.normal(there.at), d = in_tangent_plane(ray.direction, m);
    if (d == glm::dvec3(0)) return {};
    // The x axis keeps its angle to the way.
    there.x = turned_about(d, m, angle_about(ahead, tile.x, n));
    return there;
}

TileLayout slid_layout(const TileBase& base, const TileLayout& layout, const TileLook& look)
{
    std::vector<Tile> tiles = layout.tiles.all();
    parallel_blocks(tiles.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            std::optional<Tile> there = tiles[i];
            if (look.slide_along != 0 && there->track >= 0)
                there =
                    slid_along(base, *there, layout.tracks[static_cast<std::size_t>(there->track)],
                               look.slide_along);
            if (there) there = slid(base, *there, look);
            if (there)
                tiles[i] = *there;
            else
                tiles[i].size = std::numeric_limits<double>::infinity();
        }
    });
    TileLayout out = layout;
    out.tiles = Runs<Tile>::cut(tiles);
    return out;
}

TilePatch middle_of(const TilePatch& patch, double share)
{
    TilePatch part;
    for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t i = 0; i < 4; ++i) {
            const double x = 0.5 + share * (patch_nodes[i] - 0.5),
                         y = 0.5 + share * (patch_nodes[j] - 0.5);
            const TilePoint at = tile_point(patch, {x, y, 0});
            part.p[4 * j + i] = at.p;
            part.n[4 * j + i] = at.z;
        }
    part.p = through_nodes(part.p);
    part.n = through_nodes(part.n);
    return part;
}

} // namespace trivar
