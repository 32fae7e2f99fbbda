// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluation/tiling.h"

#include "core/base/parallel.h"
#include "core/tiles/fold_limit.h"
#include "core/tiles/on_surface.h"
#include "core/tiles/overlaps.h"
#include "core/tiles/tile_motion.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

// Tiles that have grown to less than this share of their size are not shown.
constexpr double smallest = 1e-3;

double side_in_world(const TilePatch& patch)
{
    const auto at = [&](double x, double y) { return tile_point(patch, {x, y, 0}).p; };
    return (glm::distance(at(0, 0.5), at(1, 0.5)) + glm::distance(at(0.5, 0), at(0.5, 1))) / 2;
}

// Seen in a mirror, a patch has its outside at the bottom; the other way round it does not.
TilePatch with_x_reversed(TilePatch patch)
{
    for (std::size_t j = 0; j < 16; j += 4) {
        std::reverse(patch.p.data() + j, patch.p.data() + j + 4);
        std::reverse(patch.n.data() + j, patch.n.data() + j + 4);
    }
    return patch;
}

TilePatch patch_through(const LimitChart& chart, const RestToWorld& way)
{
    TilePatch out;
    for (std::size_t k = 0; k < 16; ++k) {
        const SurfacePoint there = way(chart.nodes[k]);
        out.p[k] = there.p;
        out.n[k] = there.normal;
    }
    return {through_nodes(out.p), through_nodes(out.n)};
}

// One for each tile of a layout, where one member of its base stands.
std::vector<TilePatch> patches_of(const TileCharts& charts, const TileBase& base,
                                  const TiledPieces& pieces, const std::vector<Part>& parts)
{
    std::vector<TilePatch> out(charts.count());
    const std::vector<char> mirrored = mirrored_parts(pieces, parts);
    const std::vector<RestToWorld> ways = ways_to_world(pieces, parts);
    const BasePose pose = charts.flat.empty() ? BasePose{} : pose_of(base, parts, mirrored);
    parallel_blocks(out.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (charts.cut(i) > most_cut) continue;
            const bool on_limit = charts.flat.empty();
            const std::size_t piece =
                on_limit ? charts.smooth[i].piece : base.piece_of(charts.flat[i].nodes[0].triangle);
            out[i] = on_limit ? patch_through(charts.smooth[i], ways[piece])
                              : patch_of(base, pose, charts.flat[i]);
            if (mirrored[piece]) out[i] = with_x_reversed(out[i]);
        }
    });
    return out;
}

// The tiles of a layout where one member of its base stands, by their patches. `overlapping`: those
// that are left out; null: none.
std::vector<StandingTile> standing_tiles(const TileBase& base, const TileLayout& layout,
                                         const TileCharts& charts, std::vector<TilePatch> patches,
                                         const TileLook& look, const LaidKinds& laid,
                                         const Ref<std::vector<char>>& overlapping)
{
    using Fate = StandingTile::Fate;
    std::vector<StandingTile> out(patches.size());
    parallel_blocks(patches.size(), 64, [&](std::size_t begin, std::size_t end) {
        std::vector<std::size_t> guarded;
        std::vector<TilePatch> bounded; // those whose limits are asked for
        for (std::size_t i = begin; i < end; ++i) {
            StandingTile& tile = out[i];
            const TileMotion motion =
                motion_of(look, layout, layout.tiles[i], base.position(layout.tiles[i].at));
            const double reach = laid.cells[laid.kinds[i]].reach;
            tile.fate = !laid.has(i, layout.tiles[i])      ? Fate::not_there
                        : charts.cut(i) > most_cut         ? Fate::at_border
                        : motion.size < smallest           ? Fate::not_there
                        : overlapping && (*overlapping)[i] ? Fate::overlapping
                                                           : Fate::there;
            if (tile.fate != Fate::there) continue;
            tile.patch = patches[i];
            if (motion.size < 1) tile.patch = middle_of(tile.patch, motion.size);
            tile.side = side_in_world(tile.patch);
            if (!look.guard) continue;
            guarded.push_back(i);
            bounded.push_back(reach > 1 ? middle_of(tile.patch, reach) : tile.patch);
        }
        const std::vector<double> limits = fold_limits(bounded);
        for (std::size_t k = 0; k < guarded.size(); ++k) out[guarded[k]].limit = limits[k];
    });
    return out;
}

// Adds the tiles that have room, each as high as it may be, to those of their kind. `kinds` and
// `cells` hold the kind of each tile and the cell of each kind. `height_limits` are, by stroke, the
// heights of the look up to which none is lowered; they only fall.
void place_tiles(std::vector<std::vector<PlacedTile>>& out, const TileBase& base,
                 const TileLayout& layout, const std::vector<StandingTile>& standing,
                 const TileLook& look, const LaidKinds& of, TileCounts& told,
                 std::vector<double>& height_limits)
{
    enum class Guarded : char { as_wanted, lowered, folded };
    std::vector<PlacedTile> all(standing.size());
    std::vector<Guarded> guarded(standing.size(), Guarded::as_wanted);
    std::vector<double> limits(standing.size(), std::numeric_limits<double>::infinity());
    parallel_blocks(standing.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const StandingTile& there = standing[i];
            if (there.fate != StandingTile::Fate::there) continue;
            PlacedTile& tile = all[i];
            const Tile& laid = layout.tiles[i];
            const TileCell& cell = of.cells[of.kinds[i]];
            const double masked = of.factors ? (*of.factors)[i].height : 1;
            const TileMotion motion = motion_of(look, layout, laid, base.position(laid.at));
            tile.patch = there.patch;
            tile.tint = glm::vec3(laid.tint);
            tile.height = there.side * laid.height * look.height * motion.height * masked;
            const double top = tile.height * cell.top / cell.side;
            tile.base = -look.sink * top;
            if (!look.guard) continue;
            if (!(there.limit > 0)) {
                guarded[i] = Guarded::folded;
                continue;
            }
            const double proven = proven_share * there.limit;
            const double per_height = there.side * laid.height * motion.height * masked * cell.top /
                                      cell.side * (1 - look.sink);
            if (per_height > 0) limits[i] = proven / per_height;
            const double highest = std::max(0.0, top + tile.base);
            tile.of_limit = static_cast<float>(highest / proven);
            if (highest <= proven) continue;
            const double factor = proven / highest;
            tile.height *= factor;
            tile.base *= factor;
            guarded[i] = Guarded::lowered;
        }
    });
    for (std::size_t i = 0; i < all.size(); ++i) {
        const StandingTile::Fate fate = standing[i].fate;
        told.at_borders += fate == StandingTile::Fate::at_border;
        told.overlapping += fate == StandingTile::Fate::overlapping;
        if (fate != StandingTile::Fate::there) continue;
        told.lowered += guarded[i] == Guarded::lowered;
        told.folded += guarded[i] == Guarded::folded;
        if (guarded[i] == Guarded::folded) continue;
        const std::size_t others = height_limits.size() - 1; // tiles of no stroke
        const int stroke = layout.tiles[i].stroke;
        double& limit = height_limits[stroke < 0 ? others : static_cast<std::size_t>(stroke)];
        limit = std::min(limit, limits[i]);
        out[of.kinds[i]].push_back(std::move(all[i]));
    }
}

bool stands_alike(const Tile& a, const Tile& b)
{
    return a.at == b.at && a.x == b.x && a.size == b.size;
}

// Notes the height of the look at which the tiles of a stroke reach their limit.
void lower_limit(Stage& stage, std::size_t stroke, double height, double of_limit)
{
    if (!(of_limit > 0) || !(height > 0)) return;
    stage.stroke_limits[stroke] = std::min(stage.stroke_limits[stroke], height / of_limit);
    stage.height_limit = std::min(stage.height_limit, height / of_limit);
}

std::string tiles(int count)
{
    return count == 1 ? "1 tile is" : fmt::format("{} tiles are", count);
}

void tell(Stage& stage, const TileLayout& layout, const TileCounts& told)
{
    if (told.lowered > 0)
        stage.notices.push_back(tiles(told.lowered) + " lowered, so as not to fold");
    if (told.folded > 0)
        stage.notices.push_back(tiles(told.folded) +
                                " left out, where the surface bends more than a tile can");
    if (told.at_borders > 0)
        stage.notices.push_back(tiles(told.at_borders) +
                                " left out, where the surface has no room for them");
    if (told.overlapping > 0)
        stage.notices.push_back(tiles(told.overlapping) + " left out, which overlap earlier ones");
    if (layout.lost > 0)
        stage.notices.push_back(
            fmt::format("{} of the points that were painted {} no longer on the surface",
                        layout.lost, layout.lost == 1 ? "is" : "are"));
    if (layout.too_many)
        stage.notices.push_back(fmt::format(
            "it shows the first {} tiles; make them larger or set them wider apart for all",
            most_tiles));
}

// Returns the stage without its parts and curves.
Stage cleared(const Stage& before)
{
    Stage stage = before;
    stage.parts.clear();
    stage.curves.clear();
    stage.own_parts.clear();
    return stage;
}

Ref<Stage> refused(const Ref<Stage>& before, const std::string& why)
{
    Stage stage = cleared(*before);
    stage.notices.push_back(why);
    return make_ref(std::move(stage));
}

} // namespace

Ref<TileCharts> TilingStep::charts(const FoundLimit& limit, const Ref<TileBase>& base,
                                   const Ref<TileLayout>& layout, const TileLook& look,
                                   Timings& timings)
{
    return charts_({layout, look.turn_deg, look.scale}, [&] {
        return timed(timings, "tiles", [&] {
            // While strokes are added most tiles stay, and with them their charts.
            const bool alike =
                last_.base == base && last_.turn_deg == look.turn_deg && last_.scale == look.scale;
            const std::size_t known = alike ? last_.layout->tiles.size() : 0;
            TileCharts out;
            (limit.base ? out.smooth.resize(layout->tiles.size())
                        : out.flat.resize(layout->tiles.size()));
            parallel_blocks(layout->tiles.size(), 64, [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i) {
                    const Tile& tile = layout->tiles[i];
                    if (i < known && stands_alike(tile, last_.layout->tiles[i])) {
                        if (limit.base)
                            out.smooth[i] = last_.charts->smooth[i];
                        else
                            out.flat[i] = last_.charts->flat[i];
                    } else if (limit.base)
                        out.smooth[i] =
                            limit_chart_of(*limit.base, tile, look.turn_deg, look.scale);
                    else
                        out.flat[i] = chart_of(*base, tile, look.turn_deg, look.scale);
                }
            });
            last_ = {base, look.turn_deg, look.scale, layout, make_ref(std::move(out))};
            return last_.charts;
        });
    });
}

TilingStep::Painted TilingStep::painted(const TiledPieces& pieces, const FoundLimit& limit,
                                        const FoundMasks& masks, const StepInput& input)
{
    const Tiling& tiling = *input.object.tiles;
    const bool by_texture = tiling.cover.pattern == TilePattern::texture;
    if (tiling.strokes.empty() && !by_texture) return {};
    Ref<TileBase> base(limit.base, limit.base ? &limit.base->triangles() : nullptr);
    if (!base) {
        Pieces meshes;
        for (const TiledPiece& piece : pieces)
            meshes.push_back({input.ray_meshes(piece.mesh, input.timings), piece.to_model});
        base = bases_(meshes, [&] { return std::make_shared<const TileBase>(meshes); });
    }
    const Lazy<TileCurvature> curvature = curvatures_(base, [&] {
        return Lazy<TileCurvature>([base, smooth = limit.base] {
            return smooth ? TileCurvature(smooth) : TileCurvature(*base);
        });
    });
    Ref<TileLayout> whole = layouts_({base, tiling.strokes}, [&] {
        return timed(input.timings, "tiles", [&] {
            return make_ref(layout_of(*base, tiling.strokes, input.progress, &curvature));
        });
    });
    Ref<TextureLayout> others;
    if (by_texture) {
        others = timed(input.timings, "tiles", [&] {
            return textures_(pieces, base, limit.base != nullptr, tiling.cover);
        });
        whole = joined_({whole, others}, [&] { return make_ref(joined(*whole, *others)); });
    }
    const auto& [layout, factors] =
        timed(input.timings, "tiles", [&] { return masks_of_.masked(base, whole, masks); });
    const TileLook& look = tiling.look;
    const SlideKey key{base,         layout,       look.turn_deg,   look.scale,
                       look.slide_x, look.slide_y, look.slide_along};
    const Ref<TileLayout> slid =
        look.slide_x == 0 && look.slide_y == 0 && look.slide_along == 0
            ? layout
            : slides_(key, [&] { return make_ref(slid_layout(*base, *layout, look)); });
    return {base, slid, layout, charts(limit, base, slid, look, input.timings), others, factors};
}

bool LaidKinds::has(std::size_t i, const Tile& tile) const
{
    return !factors ||
           ((*factors)[i].scale >= smallest && is_there(tile.seed, (*factors)[i].density));
}

Ref<std::vector<char>> TilingStep::overlaps(const Painted& strokes, const TileKinds& kinds,
                                            const LaidKinds& laid, const TileLook& look,
                                            Timings& timings)
{
    OverlapKey key{strokes.layout,      look.turn_deg,   look.scale,
                   !look.keep_overlaps, strokes.factors, {},
                   kinds.weights};
    for (const TileKind& kind : kinds.all) {
        const glm::dvec3 size = unit_cell_in(box_at_rest(kind.parts, kind.turned), look).size();
        key.halves.push_back(glm::dvec2(size) / (2 * std::max({size.x, size.y, 1e-9})));
    }
    return overlaps_(key, [&] {
        return timed(timings, "tiles", [&] {
            const std::vector<Tile>& tiles = strokes.layout->tiles;
            std::vector<TileOutline> outlines(tiles.size());
            parallel_blocks(tiles.size(), 256, [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i) {
                    const Tile& tile = tiles[i];
                    if (!std::isfinite(tile.size) || !laid.has(i, tile)) continue;
                    const glm::dvec3 n = strokes.base->normal(tile.at);
                    outlines[i] = {strokes.base->position(tile.at),
                                   turned_about(tile.x, n, glm::radians(look.turn_deg)), n,
                                   tile.size * look.scale * key.halves[laid.kinds[i]]};
                }
            });
            return make_ref(look.keep_overlaps ? overlapping(outlines)
                                               : overlapping_earlier(outlines));
        });
    });
}

Ref<Stage> TilingStep::operator()(const Ref<Stage>& before, const StepInput& input)
{
    if (!input.object.tiles) return before;
    const Tiling& tiling = *input.object.tiles;
    const auto found = input.done.find(tiling.base);
    if (found == input.done.end())
        return refused(before, "what its tiles were painted on is no longer there");
    const Ref<EvaluatedObject>& shown = found->second;
    const std::map<int, std::vector<Part>> members = by_member(*shown);
    if (members.empty()) return refused(before, "what its tiles were painted on has no surface");

    const TiledPieces pieces =
        pieces_of(*shown, object(input.document, tiling.base), members.begin()->second);
    const FoundLimit limit = limits_(pieces);
    const FoundMasks masks = masks_of_(pieces, input);
    const Painted strokes = painted(pieces, limit, masks, input);
    const TileLook& look = tiling.look;
    const TileKinds of_layer = kinds_of_(
        *before, input,
        painted_morphs(strokes.layout ? *strokes.layout : TileLayout{}, look.phases));
    return shown_({before, shown, strokes.charts, look, tiling.cover, of_layer, masks}, [&] {
        const std::vector<TileKind>& kinds = of_layer.all;
        Stage stage = cleared(*before);
        stage.own_to_world = glm::dmat4(1);
        stage.mixed_materials = materials_of_others(of_layer);
        TileCounts told;
        if (strokes.charts) {
            std::vector<TileCell> cells;
            for (const TileKind& kind : kinds) cells.push_back(tile_cell(kind, look));
            std::vector<std::size_t> counts;
            LaidKinds laid{{}, std::move(cells), strokes.factors.get()};
            for (std::size_t i = 0; i < strokes.layout->tiles.size(); ++i) {
                const Tile& tile = strokes.layout->tiles[i];
                laid.kinds.push_back(of_layer.of(
                    tile.seed, strokes.factors ? (*strokes.factors)[i].morph : 1, tile.morph));
            }
            const Ref<std::vector<char>> overlapping =
                overlaps(strokes, of_layer, laid, look, input.timings);
            stage.painted = strokes.layout->tiles.size() -
                            (strokes.by_texture ? strokes.by_texture->tiles.size() : 0);
            if (look.keep_overlaps)
                stage.overlapping =
                    static_cast<std::size_t>(std::ranges::count(*overlapping, char(1)));
            const Ref<std::vector<char>> left_out = look.keep_overlaps ? nullptr : overlapping;
            StandingKey standing_key{shown,     strokes.charts,   left_out,    strokes.factors,
                                     {},        of_layer.weights, look.growth, look.growth_softness,
                                     look.guard};
            for (const TileCell& cell : laid.cells) standing_key.reaches.push_back(cell.reach);
            const Ref<Members> standing = standing_(standing_key, [&] {
                return timed(input.timings, "tiles", [&] {
                    Members out;
                    for (const auto& [member, parts] : members)
                        if (parts.size() == pieces.size()) // else a part is too far away
                            out[member] = standing_tiles(
                                *strokes.base, *strokes.layout, *strokes.charts,
                                patches_of(*strokes.charts, *strokes.base, pieces, parts), look,
                                laid, left_out);
                    return make_ref(std::move(out));
                });
            });
            std::vector<std::vector<PlacedTile>> all(kinds.size());
            stage.stroke_limits.assign(tiling.strokes.size() + 1,
                                       std::numeric_limits<double>::infinity());
            for (const auto& [member, tiles] : *standing)
                timed(input.timings, "tiles", [&] {
                    place_tiles(all, *strokes.base, *strokes.layout, tiles, look, laid, told,
                                stage.stroke_limits);
                });
            stage.height_limit = *std::ranges::min_element(stage.stroke_limits);
            stage.stroke_limits.pop_back();
            for (const auto& of_kind : all) counts.push_back(of_kind.size());
            if (const std::string words = too_many_words(kinds, counts); !words.empty())
                return refused(before, words);
            for (std::size_t k = 0; k < kinds.size(); ++k) {
                if (all[k].empty()) continue;
                const Ref<std::vector<PlacedTile>> places = make_ref(std::move(all[k]));
                for (const Part& part : kinds[k].parts) {
                    if (part.rest->positions.empty()) continue;
                    const Ref<TileModel> model = kinds_of_.model(kinds[k], part, laid.cells[k]);
                    PartKey key = part.key;
                    key.mesh += kinds[k].first_mesh;
                    stage.parts.push_back(timed(input.timings, "tiles", [&] {
                        return part_of(tile_set(model, places), key);
                    }));
                }
            }
        }
        StrandParts strands;
        if (strokes.layout)
            strands = strands_({tiling, of_layer, strokes.base, strokes.unslid, pieces, limit,
                                members, input.timings});
        for (std::size_t k = 0; k < strands.of_limit.size(); ++k)
            lower_limit(stage, k, look.height, strands.of_limit[k]);
        stage.parts.insert(stage.parts.end(), strands.parts.begin(), strands.parts.end());
        told += strands.counts;
        if (!of_layer.trouble.empty()) stage.notices.push_back(of_layer.trouble);
        CoverParts cover =
            covers_({tiling, of_layer, pieces, limit, members, masks, input.timings});
        stage.parts.insert(stage.parts.end(), cover.parts.begin(), cover.parts.end());
        told += cover.counts;
        if (cover.of_limit > 0 && look.height > 0)
            stage.height_limit = std::min(stage.height_limit, look.height / cover.of_limit);
        if (strokes.by_texture)
            stage.notices.insert(stage.notices.end(), strokes.by_texture->notices.begin(),
                                 strokes.by_texture->notices.end());
        stage.notices.insert(stage.notices.end(), strands.notices.begin(), strands.notices.end());
        tell(stage, strokes.layout ? *strokes.layout : TileLayout{}, told);
        stage.notices.insert(stage.notices.end(), cover.notices.begin(), cover.notices.end());
        stage.notices.insert(stage.notices.end(), masks.notices.begin(), masks.notices.end());
        stage.lacks.insert(stage.lacks.end(), masks.lacks.begin(), masks.lacks.end());
        return make_ref(std::move(stage));
    });
}

} // namespace trivar
