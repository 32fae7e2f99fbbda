// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/tiles/tiling.h"

#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/tiles/on_surface.h"
#include "core/tiles/tile_motion.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

// Notes the height of the look at which the tiles of a stroke reach their limit.
void lower_limit(Stage& stage, std::size_t stroke, double height, double of_limit)
{
    if (!(of_limit > 0) || !(height > 0)) return;
    stage.stroke_limits[stroke] = std::min(stage.stroke_limits[stroke], height / of_limit);
    stage.height_limit = std::min(stage.height_limit, height / of_limit);
}

std::string tiles(int count)
{
    return count == 1 ? "1 tile is" : with_commas(static_cast<std::uint64_t>(count)) + " tiles are";
}

// Adds notices on strokes that should lay tiles and have none.
void tell_empty_strokes(Stage& stage, const TileLayout& layout, const Tiling& tiling)
{
    std::vector<char> lacks; // by stroke
    for (const auto& stroke : tiling.strokes) {
        using enum TileBrush;
        lacks.push_back(!stroke->hidden && (stroke->brush == scatter || stroke->brush == line ||
                                            stroke->brush == fill));
    }
    const auto look_at = [&](const Tile& tile) {
        if (tile.stroke >= 0) lacks[static_cast<std::size_t>(tile.stroke)] = 0;
    };
    for (const auto& run : layout.tiles.runs()) { // mostly these tell it all
        look_at(run->front());
        look_at(run->back());
    }
    if (std::ranges::find(lacks, 1) != lacks.end()) std::ranges::for_each(layout.tiles, look_at);
    for (std::size_t i = 0; i < lacks.size(); ++i)
        if (lacks[i])
            stage.notices.push_back(fmt::format(
                "stroke {} lays no tile, as there is no room for tiles of {} m; make them "
                "smaller or remove the stroke",
                i + 1, number_text(tiling.strokes[i]->size)));
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
                                " left out, where the surface has no room; smaller ones may fit");
    if (told.overlapping > 0)
        stage.notices.push_back(tiles(told.overlapping) + " left out, which overlap earlier ones");
    if (layout.lost > 0)
        stage.notices.push_back(
            fmt::format("{} of the points that were painted {} no longer on the surface",
                        with_commas(layout.lost), layout.lost == 1 ? "is" : "are"));
    if (layout.too_many)
        stage.notices.push_back(fmt::format(
            "it shows the first {} tiles; make them larger or set them wider apart for all",
            with_commas(most_tiles)));
}

struct OutlinesBy {
    double turn_deg, scale;
    const std::vector<glm::dvec2>& halves; // of the kinds
};

// The outlines of the tiles of a layout from one on.
std::vector<TileOutline> outlines_of(const TileBase& base, const Runs<Tile>& tiles,
                                     const LaidKinds& laid, const OutlinesBy& by, std::size_t from)
{
    std::vector<TileOutline> out(tiles.size() - from);
    parallel_blocks(out.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const Tile& tile = tiles[from + k];
            if (!std::isfinite(tile.size) || !laid.has(from + k, tile)) continue;
            const glm::dvec3 n = base.normal(tile.at);
            out[k] = {base.position(tile.at), turned_about(tile.x, n, glm::radians(by.turn_deg)), n,
                      tile.size * by.scale * by.halves[laid.kind(from + k, tile)]};
        }
    });
    return out;
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
            return make_ref(layouter_(base, tiling.strokes, input.progress, &curvature));
        });
    });
    Ref<TextureLayout> others;
    if (by_texture) {
        others = timed(input.timings, "tiles", [&] {
            return textures_(pieces, base, limit.base != nullptr, tiling.cover);
        });
        whole = joined_({whole, others}, [&] { return make_ref(joined(*whole, *others)); });
    }
    const MasksOf::MaskedLayout masked =
        timed(input.timings, "tiles", [&] { return masks_of_.masked(base, whole, masks); });
    const Ref<TileLayout>& layout = masked.layout;
    const TileLook& look = tiling.look;
    const SlideKey key{base,         layout,       look.turn_deg,   look.scale,
                       look.slide_x, look.slide_y, look.slide_along};
    const Ref<TileLayout> slid =
        look.slide_x == 0 && look.slide_y == 0 && look.slide_along == 0
            ? layout
            : slides_(key, [&] { return make_ref(slid_layout(*base, *layout, look)); });
    const Ref<TileCharts> charts =
        timed(input.timings, "tiles", [&] { return painted_.charts(limit, base, slid, look); });
    return {base, slid, layout, charts, others, masked.factors};
}

TilingStep::OutlineKey TilingStep::outline_key(const Painted& strokes, const LaidKinds& laid,
                                               const TileLook& look) const
{
    OutlineKey key{look.turn_deg, look.scale, strokes.factors, {}, laid.kinds.weights};
    for (const TileKind& kind : laid.kinds.all) {
        const glm::dvec3 size =
            unit_cell_in(box_at_rest(kind.parts, kind.turned), look_of(kind, look)).size();
        key.halves.push_back(glm::dvec2(size) / (2 * std::max({size.x, size.y, 1e-9})));
    }
    return key;
}

Ref<std::vector<char>> TilingStep::left_out(const Painted& strokes, const LaidKinds& laid,
                                            const OutlineKey& key)
{
    return left_out_({strokes.layout, key}, [&] {
        return make_ref(
            overlapping_earlier(outlines_of(*strokes.base, strokes.layout->tiles, laid,
                                            OutlinesBy{key.turn_deg, key.scale, key.halves}, 0)));
    });
}

std::size_t TilingStep::count_overlaps(const Painted& strokes, const LaidKinds& laid,
                                       const OutlineKey& key)
{
    const Runs<Tile>& tiles = strokes.layout->tiles;
    std::size_t same = 0; // number of the first tiles that are as they were
    if (counted_ && counted_->key == key) {
        const auto end = std::ranges::mismatch(tiles.runs(), counted_->tiles.runs()).in1;
        same = tiles.begin_of(static_cast<std::size_t>(end - tiles.runs().begin()));
    }
    const std::vector<TileOutline> others = outlines_of(
        *strokes.base, tiles, laid, OutlinesBy{key.turn_deg, key.scale, key.halves}, same);
    if (same == 0) counted_ = Counted{key, {}, OverlapCount(others)};
    counted_->tiles = tiles;
    counted_->count.keep(same);
    counted_->count.add(others);
    return counted_->count.overlapping();
}

Ref<Stage> TilingStep::operator()(const Ref<Stage>& before, const StepInput& input)
{
    if (!input.object.tiles) return before;
    const Tiling& tiling = *input.object.tiles;
    const auto found = input.done.find(tiling.base);
    if (found == input.done.end())
        return refused(before, "what its tiles were painted on is no longer there");
    const Ref<EvaluatedObject> shown =
        uncut_({found->second->whole(), found->second->shape}, [&] { return found->second; });
    const std::map<int, std::vector<Part>> members = by_member(*shown);
    if (members.empty()) return refused(before, "what its tiles were painted on has no surface");

    const TiledPieces pieces =
        pieces_of(*shown, object(input.document, tiling.base), members.begin()->second);
    const FoundLimit limit = limits_(pieces);
    const FoundMasks masks = masks_of_(pieces, input);
    const Painted strokes = painted(pieces, limit, masks, input);
    const TileLook& look = tiling.look;
    const Ref<TileLayout> laid_out = strokes.layout ? strokes.layout : make_ref(TileLayout{});
    const TileKinds of_layer = kinds_of_(*before, input,
                                         tiling.into != 0 ? painted_morphs(*laid_out, look.phases)
                                                          : std::vector<double>{0},
                                         std::any_of(laid_out->tiles.begin(), laid_out->tiles.end(),
                                                     [](const Tile& t) { return t.mirrored; }));
    return shown_({before, shown, strokes.charts, look, tiling.cover, of_layer, masks}, [&] {
        const std::vector<TileKind>& kinds = of_layer.all;
        Stage stage = cleared(*before);
        stage.own_to_world = glm::dmat4(1);
        stage.mixed_materials = materials_of_others(of_layer);
        stage.tile_objects = of_layer.objects_of_meshes();
        TileCounts told;
        if (strokes.charts) {
            LaidKinds laid{of_layer, {}, strokes.factors};
            for (const TileKind& kind : kinds) laid.cells.push_back(tile_cell(kind, look));
            const OutlineKey outline = outline_key(strokes, laid, look);
            stage.painted = strokes.layout->tiles.size() -
                            (strokes.by_texture ? strokes.by_texture->tiles.size() : 0);
            Ref<std::vector<char>> left;
            timed(input.timings, "tiles", [&] {
                if (look.keep_overlaps)
                    stage.overlapping = count_overlaps(strokes, laid, outline);
                else
                    left = left_out(strokes, laid, outline);
            });
            PaintedTiles::Placed placed = timed(input.timings, "tiles", [&] {
                return painted_({pieces, limit, shown, members, strokes.base, strokes.layout,
                                 strokes.charts, look, laid, left, tiling.strokes.size()});
            });
            told = placed.counts;
            stage.stroke_limits = std::move(placed.limits);
            stage.height_limit = *std::ranges::min_element(stage.stroke_limits);
            stage.stroke_limits.pop_back();
            std::vector<std::size_t> counts;
            for (const PlacedTiles& of_kind : placed.of_kinds) counts.push_back(of_kind.size());
            if (const std::string words = too_many_words(kinds, counts); !words.empty())
                return refused(before, words);
            std::vector<Ref<TileSet>> sets;
            for (std::size_t k = 0; k < kinds.size(); ++k) {
                if (placed.of_kinds[k].empty()) continue;
                const Ref<PlacedTiles> places = make_ref(std::move(placed.of_kinds[k]));
                for (const Part& part : kinds[k].parts) {
                    if (part.rest->positions.empty()) continue;
                    const Ref<TileModel> model = kinds_of_.model(kinds[k], part, laid.cells[k]);
                    PartKey key = part.key;
                    key.mesh += kinds[k].first_mesh;
                    const auto last = std::ranges::find(sets_, model, &TileSet::model);
                    sets.push_back(timed(input.timings, "tiles", [&] {
                        return tile_set(model, places, last != sets_.end() ? *last : nullptr);
                    }));
                    stage.parts.push_back(part_of(sets.back(), key));
                }
            }
            sets_ = std::move(sets);
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
        if (strokes.layout && tiling.masks.empty())
            tell_empty_strokes(stage, *strokes.layout, tiling);
        stage.notices.insert(stage.notices.end(), cover.notices.begin(), cover.notices.end());
        stage.notices.insert(stage.notices.end(), masks.notices.begin(), masks.notices.end());
        stage.lacks.insert(stage.lacks.end(), masks.lacks.begin(), masks.lacks.end());
        return make_ref(std::move(stage));
    });
}

} // namespace trivar
