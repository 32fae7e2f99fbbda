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

std::vector<TileOutline> TilingStep::Outlines::of(const Runs<Tile>& tiles, std::size_t from) const
{
    std::vector<TileOutline> out(tiles.size() - from);
    parallel_blocks(out.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const Tile& tile = tiles[from + k];
            if (!std::isfinite(tile.size) || !laid.has(from + k, tile)) continue;
            const glm::dvec3 n = base->normal(tile.at);
            out[k] = {base->position(tile.at), turned_about(tile.x, n, glm::radians(turn_deg)), n,
                      tile.size * scale * halves[laid.kind(from + k, tile)]};
        }
    });
    return out;
}

Ref<TileLayout> TilingStep::slid(const Ref<TileBase>& base, const Ref<TileLayout>& layout,
                                 const TileLook& look)
{
    if (look.slide_x == 0 && look.slide_y == 0 && look.slide_along == 0) return layout;
    TileLook way;
    way.turn_deg = look.turn_deg;
    way.scale = look.scale;
    way.slide_x = look.slide_x;
    way.slide_y = look.slide_y;
    way.slide_along = look.slide_along;
    return slides_({base, layout, way}, [](const SlideInput& in) {
        return make_ref(slid_layout(*in.base, *in.layout, in.way));
    });
}

TilingStep::Painted TilingStep::painted(const ShownInput& shown, const StepInput& input)
{
    const Tiling& tiling = shown.tiling;
    const bool by_texture = tiling.cover.pattern == TilePattern::texture;
    if (tiling.strokes.empty() && !by_texture) return {};
    const Ref<LimitBase>& limit = shown.limit.base;
    Ref<TileBase> base(limit, limit ? &limit->triangles() : nullptr);
    if (!base) {
        Pieces meshes;
        for (const TiledPiece& piece : shown.pieces)
            meshes.push_back({input.ray_meshes(piece.mesh, input.timings), piece.to_model});
        base =
            bases_(meshes, [](const Pieces& in) { return std::make_shared<const TileBase>(in); });
    }
    const Lazy<TileCurvature> curvature = curvatures_({base, limit}, [](const Ground& in) {
        return Lazy<TileCurvature>(
            [in] { return in.limit ? TileCurvature(in.limit) : TileCurvature(*in.base); });
    });
    Ref<TileLayout> whole = layouts_(
        {{base, limit}, tiling.strokes},
        [](const LayoutInput& in, Layouter& layouter, const Lazy<TileCurvature>& curvature_there,
           const Progress& progress, Timings& timings) {
            return timed(timings, "tiles", [&] {
                return make_ref(layouter(in.on.base, in.strokes, progress, &curvature_there));
            });
        },
        layouter_, curvature, input.progress, input.timings);
    Ref<TextureLayout> others;
    if (by_texture) {
        others = timed(input.timings, "tiles", [&] {
            return textures_(shown.pieces, base, limit != nullptr, tiling.cover);
        });
        whole = joined_({whole, others},
                        [](const auto& in) { return make_ref(joined(*in.first, *in.second)); });
    }
    const MasksOf::MaskedLayout masked = timed(
        input.timings, "tiles", [&] { return masks_of_.masked(base, whole, shown.masks.on_base); });
    const Ref<TileLayout> there = slid(base, masked.layout, tiling.look);
    const Ref<TileCharts> charts = timed(input.timings, "tiles", [&] {
        return painted_.charts(shown.limit, base, there, tiling.look);
    });
    return {base, there, masked.layout, charts, others, masked.factors};
}

std::size_t TilingStep::count_overlaps(const Runs<Tile>& tiles, const Outlines& outlines)
{
    std::size_t same = 0; // number of the first tiles that are as they were
    if (counted_ && counted_->outlines == outlines) {
        const auto end = std::ranges::mismatch(tiles.runs(), counted_->tiles.runs()).in1;
        same = tiles.begin_of(static_cast<std::size_t>(end - tiles.runs().begin()));
    }
    const std::vector<TileOutline> others = outlines.of(tiles, same);
    if (same == 0) counted_ = Counted{outlines, {}, OverlapCount(others)};
    counted_->tiles = tiles;
    counted_->count.keep(same);
    counted_->count.add(others);
    return counted_->count.overlapping();
}

void TilingStep::add_sets(Stage& stage, const ShownInput& in, const std::vector<TileCell>& cells,
                          std::vector<PlacedTiles> of_kinds, Timings& timings)
{
    std::vector<Ref<TileSet>> sets;
    for (std::size_t k = 0; k < of_kinds.size(); ++k) {
        if (of_kinds[k].empty()) continue;
        const TileKind& kind = in.kinds.all[k];
        const Ref<PlacedTiles> places = make_ref(std::move(of_kinds[k]));
        for (const Part& part : kind.parts) {
            if (part.rest->positions.empty()) continue;
            const Ref<TileModel> model = kinds_of_.model(kind, part, cells[k]);
            PartKey key = part.key;
            key.mesh += kind.first_mesh;
            const auto last = std::ranges::find(sets_, model, &TileSet::model);
            sets.push_back(timed(timings, "tiles", [&] {
                return tile_set(model, places, last != sets_.end() ? *last : nullptr);
            }));
            stage.parts.push_back(part_of(sets.back(), key));
        }
    }
    sets_ = std::move(sets);
}

std::string TilingStep::add_painted(Stage& stage, const ShownInput& in, const Members& members,
                                    TileCounts& told, Timings& timings)
{
    const Painted& strokes = in.strokes;
    const TileLook& look = in.tiling.look;
    Outlines outlines{
        strokes.base, {in.kinds.choice, strokes.factors}, look.turn_deg, look.scale, {}};
    std::vector<TileCell> cells;
    for (const TileKind& kind : in.kinds.all) {
        cells.push_back(tile_cell(kind, look));
        const glm::dvec3 size =
            unit_cell_in(box_at_rest(kind.parts, kind.turned), look_of(kind, look)).size();
        outlines.halves.push_back(glm::dvec2(size) / (2 * std::max({size.x, size.y, 1e-9})));
    }
    stage.painted =
        strokes.layout->tiles.size() - (strokes.by_texture ? strokes.by_texture->tiles.size() : 0);
    Ref<std::vector<char>> left;
    timed(timings, "tiles", [&] {
        if (look.keep_overlaps)
            stage.overlapping = count_overlaps(strokes.layout->tiles, outlines);
        else
            left = left_out_({strokes.layout, outlines}, [](const OverlapInput& of) {
                return make_ref(overlapping_earlier(of.outlines.of(of.layout->tiles, 0)));
            });
    });
    PaintedTiles::Placed placed = timed(timings, "tiles", [&] {
        return painted_({in.pieces, in.limit, in.base, members, strokes.base, strokes.layout,
                         strokes.charts, look, outlines.laid, cells, left,
                         in.tiling.strokes.size()});
    });
    told = placed.counts;
    stage.stroke_limits = std::move(placed.limits);
    stage.height_limit = *std::ranges::min_element(stage.stroke_limits);
    stage.stroke_limits.pop_back();
    std::vector<std::size_t> counts;
    for (const PlacedTiles& of_kind : placed.of_kinds) counts.push_back(of_kind.size());
    std::string words = too_many_words(in.kinds.all, counts);
    if (words.empty()) add_sets(stage, in, cells, std::move(placed.of_kinds), timings);
    return words;
}

Ref<Stage> TilingStep::shown(const ShownInput& in, Timings& timings)
{
    const auto append = [](auto& to, const auto& more) {
        to.insert(to.end(), more.begin(), more.end());
    };
    const Painted& strokes = in.strokes;
    const Tiling& tiling = in.tiling;
    Stage stage = cleared(*in.before);
    stage.own_to_world = glm::dmat4(1);
    stage.mixed_materials = materials_of_others(in.kinds);
    stage.tile_objects = in.kinds.objects_of_meshes();
    const Members members = by_member(*in.base);
    TileCounts told;
    if (strokes.charts)
        if (const std::string words = add_painted(stage, in, members, told, timings);
            !words.empty())
            return refused(in.before, words);
    StrandParts strands;
    if (strokes.layout)
        strands = strands_({tiling, in.kinds, strokes.base, strokes.unslid, in.pieces, in.limit,
                            members, timings});
    for (std::size_t k = 0; k < strands.of_limit.size(); ++k)
        lower_limit(stage, k, tiling.look.height, strands.of_limit[k]);
    append(stage.parts, strands.parts);
    told += strands.counts;
    const CoverParts cover =
        covers_({tiling, in.kinds, in.pieces, in.limit, members, in.masks.on_base, timings});
    append(stage.parts, cover.parts);
    told += cover.counts;
    if (cover.of_limit > 0 && tiling.look.height > 0)
        stage.height_limit = std::min(stage.height_limit, tiling.look.height / cover.of_limit);
    if (!in.kinds.trouble.empty()) stage.notices.push_back(in.kinds.trouble);
    if (strokes.by_texture) append(stage.notices, strokes.by_texture->notices);
    append(stage.notices, strands.notices);
    tell(stage, strokes.layout ? *strokes.layout : TileLayout{}, told);
    if (strokes.layout && tiling.masks.empty()) tell_empty_strokes(stage, *strokes.layout, tiling);
    append(stage.notices, cover.notices);
    append(stage.notices, in.masks.notices);
    append(stage.lacks, in.masks.lacks);
    return make_ref(std::move(stage));
}

Ref<Stage> TilingStep::operator()(const Ref<Stage>& before, const StepInput& input)
{
    if (!input.object.tiles) return before;
    const Tiling& tiling = *input.object.tiles;
    const auto found = input.done.find(tiling.base);
    if (found == input.done.end())
        return refused(before, "what its tiles were painted on is no longer there");
    ShownInput in;
    in.before = before;
    in.tiling = tiling;
    in.base = uncut_({found->second, found->second->whole()},
                     [](const Uncut& uncut) { return uncut.base; });
    const Members members = by_member(*in.base);
    if (members.empty()) return refused(before, "what its tiles were painted on has no surface");
    in.pieces = pieces_of(*in.base, object(input.document, tiling.base), members.begin()->second);
    in.limit = limits_(in.pieces);
    in.masks = masks_of_(in.pieces, input);
    in.strokes = painted(in, input);
    const Ref<TileLayout> laid = in.strokes.layout ? in.strokes.layout : make_ref(TileLayout{});
    in.kinds = kinds_of_(*before, input,
                         tiling.into != 0 ? painted_morphs(*laid, tiling.look.phases)
                                          : std::vector<double>{0},
                         std::any_of(laid->tiles.begin(), laid->tiles.end(),
                                     [](const Tile& t) { return t.mirrored; }));
    return shown_(
        in,
        [](const ShownInput& now, TilingStep& step, Timings& timings) {
            return step.shown(now, timings);
        },
        *this, input.timings);
}

} // namespace trivar
