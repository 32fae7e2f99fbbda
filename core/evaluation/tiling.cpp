// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluation/tiling.h"

#include "core/base/parallel.h"
#include "core/tiles/fold_limit.h"
#include "core/tiles/tile_motion.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

// Tiles of which a border cuts off more than this share of their size are left out.
constexpr double most_cut = 0.2;
// Lowered tiles stay below the proven limit by this factor, for the rounding of positions.
constexpr double below_limit = 0.98;
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

// Adds the tiles that have room, each as high as it may be, to those of their kind. `kinds` and
// `cells` hold the kind of each tile and the cell of each kind.
void place_tiles(std::vector<std::vector<PlacedTile>>& out, const TileBase& base,
                 const TileLayout& layout, const TileCharts& charts,
                 const std::vector<MaskFactors>* factors, const std::vector<TilePatch>& patches,
                 const TileLook& look, const std::vector<std::size_t>& kinds,
                 const std::vector<TileCell>& cells, TileCounts& told)
{
    enum class Fate : char { as_wanted, lowered, folded, at_border, not_there };
    std::vector<PlacedTile> all(patches.size());
    std::vector<Fate> fates(patches.size(), Fate::as_wanted);
    parallel_blocks(patches.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const MaskFactors masked = factors ? (*factors)[i] : MaskFactors{};
            if (masked.scale < smallest || !is_there(layout.tiles[i].seed, masked.density)) {
                fates[i] = Fate::not_there;
                continue;
            }
            if (charts.cut(i) > most_cut) {
                fates[i] = Fate::at_border;
                continue;
            }
            PlacedTile& tile = all[i];
            const TileCell& cell = cells[kinds[i]];
            const TileMotion motion =
                motion_of(look, layout, layout.tiles[i], base.position(layout.tiles[i].at));
            if (motion.size < smallest) {
                fates[i] = Fate::not_there;
                continue;
            }
            tile.patch = patches[i];
            if (motion.size < 1) tile.patch = middle_of(tile.patch, motion.size);
            tile.height = side_in_world(tile.patch) * layout.tiles[i].height * look.height *
                          motion.height * masked.height;
            const double top = tile.height * cell.top / cell.side;
            tile.base = -look.sink * top;
            if (!look.guard) continue;
            const double limit =
                fold_limit(cell.reach > 1 ? middle_of(tile.patch, cell.reach) : tile.patch);
            if (!(limit > 0)) {
                fates[i] = Fate::folded;
                continue;
            }
            const double highest = std::max(0.0, top + tile.base);
            if (highest <= below_limit * limit) continue;
            const double factor = below_limit * limit / highest;
            tile.height *= factor;
            tile.base *= factor;
            fates[i] = Fate::lowered;
        }
    });
    for (std::size_t i = 0; i < all.size(); ++i) {
        told.lowered += fates[i] == Fate::lowered;
        told.folded += fates[i] == Fate::folded;
        told.at_borders += fates[i] == Fate::at_border;
        if (fates[i] == Fate::as_wanted || fates[i] == Fate::lowered)
            out[kinds[i]].push_back(std::move(all[i]));
    }
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
                    if (i < known && tile == last_.layout->tiles[i]) {
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
    Ref<TileLayout> whole = layouts_({base, tiling.strokes}, [&] {
        return timed(input.timings, "tiles",
                     [&] { return make_ref(layout_of(*base, tiling.strokes, input.progress)); });
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
    const SlideKey key{base, layout, look.turn_deg, look.scale, look.slide_x, look.slide_y};
    const Ref<TileLayout> slid =
        look.slide_x == 0 && look.slide_y == 0
            ? layout
            : slides_(key, [&] { return make_ref(slid_layout(*base, *layout, look)); });
    return {base, slid, charts(limit, base, slid, look, input.timings), others, factors};
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
    const TileKinds of_layer = kinds_of_(*before, input);
    return shown_({before, shown, strokes.charts, look, tiling.cover, of_layer, masks}, [&] {
        const std::vector<TileKind>& kinds = of_layer.all;
        Stage stage = cleared(*before);
        stage.own_to_world = glm::dmat4(1);
        stage.mixed_materials = materials_of_others(of_layer);
        TileCounts told;
        if (strokes.charts) {
            std::vector<TileCell> cells;
            for (const TileKind& kind : kinds) cells.push_back(tile_cell(kind, look));
            std::vector<std::size_t> kind_of_tile, counts;
            for (std::size_t i = 0; i < strokes.layout->tiles.size(); ++i)
                kind_of_tile.push_back(
                    of_layer.of(strokes.layout->tiles[i].seed,
                                strokes.factors ? (*strokes.factors)[i].morph : 1));
            std::vector<std::vector<PlacedTile>> all(kinds.size());
            for (const auto& [member, parts] : members) {
                if (parts.size() != pieces.size()) continue; // a part is too far away
                timed(input.timings, "tiles", [&] {
                    place_tiles(all, *strokes.base, *strokes.layout, *strokes.charts,
                                strokes.factors.get(),
                                patches_of(*strokes.charts, *strokes.base, pieces, parts), look,
                                kind_of_tile, cells, told);
                });
            }
            for (const auto& of_kind : all) counts.push_back(of_kind.size());
            if (const std::string words = too_many_words(kinds, counts); !words.empty())
                return refused(before, words);
            for (std::size_t k = 0; k < kinds.size(); ++k) {
                if (all[k].empty()) continue;
                const Ref<std::vector<PlacedTile>> places = make_ref(std::move(all[k]));
                for (const Part& part : kinds[k].parts) {
                    if (part.rest->positions.empty()) continue;
                    const Ref<TileModel> model = kinds_of_.model(kinds[k], part, cells[k]);
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
            strands = strands_({tiling, of_layer, strokes.base, strokes.layout, pieces, limit,
                                members, input.timings});
        stage.parts.insert(stage.parts.end(), strands.parts.begin(), strands.parts.end());
        told += strands.counts;
        if (!of_layer.trouble.empty()) stage.notices.push_back(of_layer.trouble);
        CoverParts cover =
            covers_({tiling, of_layer, pieces, limit, members, masks, input.timings});
        stage.parts.insert(stage.parts.end(), cover.parts.begin(), cover.parts.end());
        told += cover.counts;
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
