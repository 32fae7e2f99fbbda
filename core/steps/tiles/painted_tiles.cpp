// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/tiles/painted_tiles.h"

#include "core/tiles/fold_limit.h"
#include "core/tiles/tile_motion.h"

#include <algorithm>

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

bool stands_alike(const Tile& a, const Tile& b)
{
    return a.at == b.at && a.x == b.x && a.size == b.size && a.mirrored == b.mirrored;
}

} // namespace

std::size_t LaidKinds::kind(std::size_t i, const Tile& tile) const
{
    return choice.of(tile.seed, factors ? (*factors)[i].morph : 1, tile.morph, tile.mirrored);
}

bool LaidKinds::has(std::size_t i, const Tile& tile) const
{
    return !factors ||
           ((*factors)[i].scale >= smallest && is_there(tile.seed, (*factors)[i].density));
}

Ref<TileCharts> PaintedTiles::charts(const FoundLimit& limit, const Ref<TileBase>& base,
                                     const Ref<TileLayout>& layout, const TileLook& look)
{
    return charts_(
        {{base, limit.base, look.turn_deg, look.scale}, layout},
        [](const ChartInput& in, PaintedTiles& tiles) { return tiles.made_charts(in); }, *this);
}

Ref<TileCharts> PaintedTiles::made_charts(const ChartInput& input)
{
    const ChartFrom& from = input.from;
    const std::vector<Runs<Tile>::Run>& runs = input.layout->tiles.runs();
    // Runs that changed have most of their tiles in common with those that stood there.
    const std::vector<Ref<ChartRun>> before =
        chart_runs_.values(from) ? *chart_runs_.values(from) : std::vector<Ref<ChartRun>>();
    const auto made = [&](std::size_t r) {
        ChartRun out;
        (from.limit ? out.smooth.resize(runs[r]->size()) : out.flat.resize(runs[r]->size()));
        const std::size_t known = r < before.size() ? charted_.runs()[r]->size() : 0;
        for (std::size_t i = 0; i < runs[r]->size(); ++i) {
            const Tile& tile = (*runs[r])[i];
            const bool stays = i < known && stands_alike(tile, (*charted_.runs()[r])[i]);
            if (from.limit)
                out.smooth[i] = stays
                                    ? before[r]->smooth[i]
                                    : limit_chart_of(*from.limit, tile, from.turn_deg, from.scale);
            else
                out.flat[i] = stays ? before[r]->flat[i]
                                    : chart_of(*from.base, tile, from.turn_deg, from.scale);
        }
        return make_ref(std::move(out));
    };
    Ref<TileCharts> out = make_ref(chart_runs_(from, runs, made));
    charted_ = input.layout->tiles;
    return out;
}

StandingTile PaintedTiles::standing_tile(const Member& member, const PaintedInput& input,
                                         std::size_t run, std::size_t i)
{
    using Fate = StandingTile::Fate;
    const TileBase& base = *input.base;
    const TileLayout& layout = *input.layout;
    const Tile& laid = (*layout.tiles.runs()[run])[i];
    const ChartRun& charts = *(*input.charts)[run];
    const std::size_t number = layout.tiles.begin_of(run) + i;
    const TileMotion motion = motion_of(input.look, layout, laid, base.position(laid.at));
    StandingTile tile;
    tile.fate = !input.laid.has(number, laid)                 ? Fate::not_there
                : charts.cut(i) > most_cut                    ? Fate::at_border
                : motion.size < smallest                      ? Fate::not_there
                : input.left_out && (*input.left_out)[number] ? Fate::overlapping
                                                              : Fate::there;
    if (tile.fate != Fate::there) return tile;
    const bool on_limit = charts.flat.empty();
    const std::size_t piece =
        on_limit ? charts.smooth[i].piece : base.piece_of(charts.flat[i].nodes[0].triangle);
    tile.patch = on_limit ? patch_through(charts.smooth[i], member.ways[piece])
                          : patch_of(base, member.pose, charts.flat[i]);
    if (member.mirrored[piece]) tile.patch = with_x_reversed(tile.patch);
    if (motion.size < 1) tile.patch = middle_of(tile.patch, motion.size);
    tile.side = side_in_world(tile.patch);
    return tile;
}

PaintedTiles::StandingRun PaintedTiles::standing_run(const Member& member,
                                                     const PaintedInput& input, std::size_t run)
{
    const std::vector<Tile>& laid = *input.layout->tiles.runs()[run];
    std::vector<StandingTile> out;
    out.reserve(laid.size());
    std::vector<std::size_t> guarded;
    std::vector<TilePatch> bounded; // those whose limits are asked for
    for (std::size_t i = 0; i < laid.size(); ++i) {
        const StandingTile& tile = out.emplace_back(standing_tile(member, input, run, i));
        if (!input.look.guard || tile.fate != StandingTile::Fate::there) continue;
        const std::size_t number = input.layout->tiles.begin_of(run) + i;
        const double reach = input.cells[input.laid.kind(number, laid[i])].reach;
        guarded.push_back(i);
        bounded.push_back(reach > 1 ? middle_of(tile.patch, reach) : tile.patch);
    }
    const std::vector<double> limits = fold_limits(bounded);
    for (std::size_t k = 0; k < guarded.size(); ++k) out[guarded[k]].limit = limits[k];
    return make_ref(std::move(out));
}

// Each tile that has room, as high as it may be.
Ref<PaintedTiles::PlacedRun> PaintedTiles::placed_run(const PaintedInput& input, std::size_t run,
                                                      const std::vector<StandingTile>& standing)
{
    const TileLook& look = input.look;
    PlacedRun out;
    std::vector<std::vector<PlacedTile>> of_kinds(input.cells.size());
    for (std::size_t i = 0; i < standing.size(); ++i) {
        const StandingTile& there = standing[i];
        out.counts.at_borders += there.fate == StandingTile::Fate::at_border;
        out.counts.overlapping += there.fate == StandingTile::Fate::overlapping;
        if (there.fate != StandingTile::Fate::there) continue;
        const Tile& laid = (*input.layout->tiles.runs()[run])[i];
        const std::size_t number = input.layout->tiles.begin_of(run) + i,
                          kind = input.laid.kind(number, laid);
        const TileCell& cell = input.cells[kind];
        const double masked = input.laid.factors ? (*input.laid.factors)[number].height : 1;
        const TileMotion motion =
            motion_of(look, *input.layout, laid, input.base->position(laid.at));
        PlacedTile tile{there.patch};
        tile.tint = glm::vec3(laid.tint);
        tile.height = there.side * laid.height * look.height * motion.height * masked;
        const double top = tile.height * cell.top / cell.side;
        tile.base = -look.sink * top;
        double limit = std::numeric_limits<double>::infinity();
        if (look.guard) {
            if (!(there.limit > 0)) {
                ++out.counts.folded;
                continue;
            }
            const double proven = proven_share * there.limit;
            const double per_height = there.side * laid.height * motion.height * masked * cell.top /
                                      cell.side * (1 - look.sink);
            if (per_height > 0) limit = proven / per_height;
            const double highest = std::max(0.0, top + tile.base);
            tile.of_limit = static_cast<float>(highest / proven);
            if (highest > proven) {
                const double factor = proven / highest;
                tile.height *= factor;
                tile.base *= factor;
                ++out.counts.lowered;
            }
        }
        if (out.limits.empty() || out.limits.back().first != laid.stroke)
            out.limits.emplace_back(laid.stroke, limit);
        out.limits.back().second = std::min(out.limits.back().second, limit);
        of_kinds[kind].push_back(tile);
    }
    for (std::vector<PlacedTile>& each : of_kinds)
        out.of_kinds.push_back(each.empty() ? nullptr : make_ref(std::move(each)));
    return make_ref(std::move(out));
}

PaintedTiles::Placed PaintedTiles::operator()(const PaintedInput& input)
{
    const TileLook& look = input.look;
    StandingFrom from{input.shown,
                      input.base,
                      input.left_out,
                      input.laid,
                      {},
                      look.growth,
                      look.growth_softness,
                      look.growth < 1 ? input.layout->duration_s : 0,
                      look.guard};
    for (const TileCell& cell : input.cells) from.reaches.push_back(cell.reach);
    const PlacedFrom placed_from{input.base, look, input.laid, input.cells};

    Placed out;
    out.of_kinds.resize(input.cells.size());
    out.limits.assign(input.strokes + 1, std::numeric_limits<double>::infinity());
    std::erase_if(members_, [&](const auto& m) { return !input.members.contains(m.first); });
    for (const auto& [number, parts] : input.members) {
        if (parts.size() != input.pieces.size()) continue; // a part is too far away
        Member& member = members_[number];
        if (member.shown != input.shown || member.base != input.base) {
            member.shown = input.shown;
            member.base = input.base;
            member.mirrored = mirrored_parts(input.pieces, parts);
            member.ways = ways_to_world(input.pieces, parts);
            member.pose =
                input.limit.base ? BasePose{} : pose_of(*input.base, parts, member.mirrored);
        }
        const std::vector<StandingRun>& standing = member.standing(
            from, *input.charts, [&](std::size_t run) { return standing_run(member, input, run); });
        const std::vector<Ref<PlacedRun>>& placed =
            member.placed(placed_from, standing,
                          [&](std::size_t run) { return placed_run(input, run, *standing[run]); });
        for (const Ref<PlacedRun>& run : placed) {
            out.counts += run->counts;
            for (std::size_t k = 0; k < run->of_kinds.size(); ++k)
                if (run->of_kinds[k]) out.of_kinds[k].add(run->of_kinds[k]);
            for (const auto& [stroke, limit] : run->limits) {
                double& least =
                    out.limits[stroke < 0 ? input.strokes : static_cast<std::size_t>(stroke)];
                least = std::min(least, limit);
            }
        }
    }
    return out;
}

} // namespace trivar
