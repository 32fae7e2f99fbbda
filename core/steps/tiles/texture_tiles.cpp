// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/tiles/texture_tiles.h"

#include "core/limit/tangent.h"
#include "core/steps/tiles/covers.h"
#include "core/tiles/near_tiles.h"
#include "core/tiles/texture_cells.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

// Two tiles stand in one place where their middles are nearer to each other than this share of
// their sides; in a chart that is stretched to the half they are farther apart.
constexpr double too_near = 0.5;

struct AllSpots {
    std::vector<TextureSpot> spots;
    std::vector<std::size_t> piece; // of each
    std::size_t repeated = 0, flat = 0, without = 0;
    bool too_many = false;
};

AllSpots spots_on(const TiledPieces& pieces, const TileCover& cover)
{
    AllSpots out;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        const auto found = texture_spots(*pieces[k].mesh, pieces[k].to_model, cover.columns,
                                         cover.rows, most_tiles - out.spots.size());
        if (!found) {
            ++out.without;
            continue;
        }
        out.spots.insert(out.spots.end(), found->spots.begin(), found->spots.end());
        out.piece.resize(out.spots.size(), k);
        out.repeated += found->repeated;
        out.flat += found->flat;
        out.too_many |= found->too_many;
    }
    return out;
}

std::vector<std::optional<SurfacePlace>> places_of(const AllSpots& all, const TiledPieces& pieces,
                                                   const TileBase& base, bool limit)
{
    if (limit) {
        std::vector<SurfacePoint> points;
        double longest = 0;
        for (const TextureSpot& each : all.spots) {
            points.push_back({each.p, each.normal});
            longest = std::max(longest, each.side);
        }
        return base.locate(points, std::max(longest, 1e-2 * base.diagonal()));
    }
    std::vector<std::optional<SurfacePlace>> out;
    for (std::size_t i = 0; i < all.spots.size(); ++i) {
        const TextureSpot& spot = all.spots[i];
        SurfacePlace at{base.first_triangle(all.piece[i]) + spot.triangle, spot.weights};
        // The base has the triangles of a mirrored mesh the other way round.
        if (glm::determinant(glm::dmat3(pieces[all.piece[i]].to_model)) < 0)
            std::swap(at.weights.y, at.weights.z);
        out.push_back(inside(at));
    }
    return out;
}

std::string spoken(std::size_t count, std::string_view one, std::string_view many)
{
    return count == 1 ? std::string(one) : fmt::format("{} {}", count, many);
}

TextureLayout layout_on(const TiledPieces& pieces, const TileBase& base, bool limit,
                        const TileCover& cover)
{
    TextureLayout out;
    const AllSpots all = spots_on(pieces, cover);
    const auto places = places_of(all, pieces, base, limit);
    std::int64_t lowest = 0, highest = 0;
    double least = base.diagonal(), most = 0;
    for (const TextureSpot& each : all.spots) {
        lowest = std::min(lowest, each.cell.y);
        highest = std::max(highest, each.cell.y);
        least = std::min(least, each.side);
        most = std::max(most, each.side);
    }
    NearTiles near(std::max(least, 1e-4 * base.diagonal()) + 1e-300);
    std::size_t left_out = 0;
    for (std::size_t i = 0; i < all.spots.size(); ++i) {
        if (!places[i]) continue;
        const TextureSpot& spot = all.spots[i];
        const glm::dvec3 p = base.position(*places[i]), n = base.normal(*places[i]);
        const bool taken =
            near.any(p, too_near * (spot.side + most) / 2, [&](int other, double away) {
                const Tile& its = out.tiles[static_cast<std::size_t>(other)];
                return away < too_near * (its.size + spot.side) / 2 &&
                       glm::dot(base.normal(its.at), n) > 0;
            });
        if (taken) {
            ++left_out;
            continue;
        }
        Tile tile;
        tile.at = *places[i];
        tile.x = in_tangent_plane(spot.along_u, n);
        if (tile.x == glm::dvec3(0)) continue;
        tile.size = spot.side;
        tile.stroke = -1;
        tile.seed = seed_of(cover.seed, spot.cell.x, spot.cell.y, all.piece[i]);
        tile.height =
            1 - cover.height_variation * random_share(tile.seed, random_purpose::texture_height);
        tile.time_s = static_cast<double>(spot.cell.y - lowest) /
                      static_cast<double>(std::max<std::int64_t>(highest - lowest, 1));
        near.add(p, static_cast<int>(out.tiles.size()));
        out.tiles.push_back(tile);
    }
    out.too_many = all.too_many;
    if (all.without == pieces.size())
        out.notices.push_back(fmt::format("what it covers {}; unwrap it first", lacks_uvs_words));
    else if (all.without > 0)
        out.notices.push_back(spoken(all.without, "1 part", "parts") +
                              " of what it covers without UVs carry no tiles");
    else if (all.spots.empty())
        out.notices.emplace_back("no cell of the texture has its centre on what it covers; give it "
                                 "more columns and rows");
    if (all.flat > 0)
        out.notices.push_back(spoken(all.flat, "1 triangle", "triangles") +
                              " whose UVs have no area carry no tiles");
    if (all.repeated > 0)
        out.notices.push_back(spoken(all.repeated, "1 tile stands", "tiles stand") +
                              " where the texture of another part is used again");
    if (left_out > 0)
        out.notices.push_back(spoken(left_out, "1 tile is", "tiles are") +
                              " left out, where two would stand in one place");
    return out;
}

} // namespace

Ref<TextureLayout> TextureTiles::operator()(const TiledPieces& pieces, const Ref<TileBase>& base,
                                            bool limit, const TileCover& cover)
{
    return known_({pieces, base, limit, cover}, [](const Input& in) {
        return make_ref(layout_on(in.pieces, *in.base, in.limit, in.cover));
    });
}

TileLayout joined(const TileLayout& painted, const TextureLayout& by_texture)
{
    TileLayout out = painted;
    for (Tile tile : by_texture.tiles) {
        tile.time_s += painted.duration_s;
        out.tiles.push_back(tile);
    }
    if (!by_texture.tiles.empty()) out.duration_s += 1;
    out.too_many |= by_texture.too_many;
    return out;
}

} // namespace trivar
