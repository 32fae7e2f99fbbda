// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/tiles/strands.h"

#include "core/base/parallel.h"
#include "core/mesh/mesh_materials.h"
#include "core/steps/tiles/covers.h"
#include "core/tiles/fold_limit.h"
#include "core/tiles/strand_slide.h"
#include "core/tiles/strand_tile.h"
#include "core/tiles/tile_motion.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

namespace trivar {
namespace {

enum : int { strand_piece = 3 }; // of a PartKey, and the next number for every other tile

struct PosedStrands {
    std::vector<StrandNodes> nodes; // #stations
    std::vector<char> mirrored;     // #pieces
};

PosedStrands posed_strands(const StrandInput& input, const std::vector<StationChart>& charts,
                           const std::vector<Part>& parts)
{
    PosedStrands out{std::vector<StrandNodes>(charts.size()), mirrored_parts(input.pieces, parts)};
    const bool on_limit = input.limit.base != nullptr;
    const std::vector<RestToWorld> ways = ways_to_world(input.pieces, parts);
    const BasePose pose = on_limit ? BasePose{} : pose_of(*input.base, parts, out.mirrored);
    parallel_blocks(charts.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            for (std::size_t j = 0; j < 4; ++j)
                out.nodes[i][j] =
                    on_limit ? ways[charts[i].piece](charts[i].smooth[j])
                             : posed(*input.base, pose, charts[i].flat[j], charts[i].beyond[j]);
    });
    return out;
}

glm::dvec3 middle_of_nodes(const StrandNodes& nodes)
{
    return 0.5 * (nodes[1].p + nodes[2].p);
}

// Metres in the world of what is as high as a cell is long, at every station: the mean of the two
// cells at those they share, and linear between.
std::vector<double> station_heights(const StrandLayout& layout,
                                    const std::vector<StrandNodes>& nodes)
{
    std::vector<double> lengths(layout.cells.size());
    for (std::size_t c = 0; c < lengths.size(); ++c)
        for (std::size_t k = 1; k < 4; ++k)
            lengths[c] += glm::distance(middle_of_nodes(nodes[layout.cells[c].stations[k]]),
                                        middle_of_nodes(nodes[layout.cells[c].stations[k - 1]]));
    std::vector<double> out(layout.stations.size(), 0);
    for (std::size_t c = 0; c < lengths.size(); ++c) {
        const StrandCell& cell = layout.cells[c];
        const auto mean = [&](int other) {
            return other < 0 ? lengths[c]
                             : 0.5 * (lengths[c] + lengths[static_cast<std::size_t>(other)]);
        };
        const double a = mean(cell.before), b = mean(cell.behind);
        for (std::size_t k = 0; k < 4; ++k) out[cell.stations[k]] = glm::mix(a, b, patch_nodes[k]);
    }
    return out;
}

// Lowers stations until no tile folds; those of a cell that folds in itself stay as they are.
struct GuardedStrands {
    std::vector<double> heights;       // #stations
    std::vector<char> folded, lowered; // #cells
    // The heights that were asked for, as shares of those that are proven; 0: it was not asked.
    std::vector<double> of_limit; // #cells
};
GuardedStrands guarded_strands(const StrandLayout& layout, std::span<const StrandNodes> nodes,
                               std::vector<double> heights, const std::vector<char>& mirrored,
                               double top, double reach)
{
    constexpr int most_rounds = 6;
    const std::size_t count = layout.cells.size();
    GuardedStrands out{std::move(heights), std::vector<char>(count, 0), std::vector<char>(count, 0),
                       std::vector<double>(count, 0)};
    for (int round = 0; round < most_rounds; ++round) {
        std::vector<double> factors(count, 1);
        parallel_blocks(count, 64, [&](std::size_t begin, std::size_t end) {
            for (std::size_t c = begin; c < end; ++c) {
                if (layout.cells[c].gone || out.folded[c]) continue;
                const TilePatch patch =
                    strand_patch(layout, c, nodes, out.heights, mirrored[c] != 0);
                const double limit = fold_limit(reach > 1 ? middle_of(patch, reach) : patch);
                if (!(limit > 0)) {
                    out.folded[c] = 1;
                    continue;
                }
                if (round == 0) out.of_limit[c] = std::max(0.0, top / (proven_share * limit));
                if (top > proven_share * limit)
                    factors[c] = std::max(0.5, proven_share * limit / top);
            }
        });
        bool all_stand = true;
        std::vector<double> at_station(out.heights.size(), 1);
        for (std::size_t c = 0; c < count; ++c) {
            if (factors[c] >= 1) continue;
            all_stand = false;
            out.lowered[c] = 1;
            if (round + 1 == most_rounds) out.folded[c] = 1;
            for (const std::uint32_t s : layout.cells[c].stations)
                at_station[s] = std::min(at_station[s], factors[c]);
        }
        if (all_stand || round + 1 == most_rounds) break;
        for (std::size_t s = 0; s < at_station.size(); ++s) out.heights[s] *= at_station[s];
    }
    return out;
}

Box turned_box(const TileKind& kind, const glm::dmat4& turn, bool posed)
{
    Box box;
    for (const Part& part : kind.parts)
        box.add(
            bounding_box(posed ? *part.mesh() : *part.rest, turn * kind.turned * part.to_world));
    return box;
}

glm::dmat4 unit_of(const StrandPlace& place, double aspect)
{
    const glm::dvec3 factor(1 / place.length, 1 / (place.length * aspect), 1 / place.length);
    glm::dmat4 out(1);
    for (int k = 0; k < 3; ++k) {
        out[k][k] = factor[k];
        out[3][k] = -factor[k] * place.origin[k];
    }
    out[3][1] += 0.5;
    return out * place.turn;
}

// The places of all kinds, and what their cells must hold.
struct KindPlaces {
    std::vector<std::vector<StrandPlace>> of; // #kinds
    double aspect = 1e-6; // width of the cells to their length: that of the widest kind
    double top = 0;       // of the highest kind, in lengths over the surface
    double reach = 1;     // how many times as long or wide as its cell the largest kind is
};
KindPlaces places_of(const TileKinds& kinds, const TileLook& look)
{
    KindPlaces out;
    for (const TileKind& kind : kinds.all)
        for (const StrandPlace& place : out.of.emplace_back(strand_places(kind, look))) {
            out.aspect = std::max(out.aspect, 2 * place.half_width / place.length);
            out.top = std::max(out.top, (1 - look.sink) * place.top);
        }
    for (std::size_t k = 0; k < out.of.size(); ++k)
        for (const StrandPlace& place : out.of[k]) {
            const Box box = turned_box(kinds.all[k], place.turn, true);
            if (box.empty()) continue;
            const glm::dvec3 before = (place.origin - box.lo) / place.length,
                             behind = (box.hi - place.origin) / place.length;
            out.reach = std::max({out.reach, 1 + 2 * before.x, 2 * behind.x - 1,
                                  2 * before.y / out.aspect, 2 * behind.y / out.aspect});
        }
    // But for rounding, a tile that fills its cell does not reach out of it.
    if (out.reach < 1 + 1e-6) out.reach = 1;
    return out;
}

// Returns by how much of the wave's variation each station is ahead: the random shares of the
// tiles, the mean of both where two tiles meet, and linear between.
std::vector<double> random_shares(const StrandLayout& layout)
{
    const auto own = [&](const StrandCell& cell) {
        return random_share(cell.seed, random_purpose::wave);
    };
    std::vector<double> out(layout.stations.size(), 0);
    for (const StrandCell& cell : layout.cells) {
        const auto with = [&](int other) {
            return other < 0 ? own(cell)
                             : (own(cell) + own(layout.cells[static_cast<std::size_t>(other)])) / 2;
        };
        const double a = with(cell.before), b = with(cell.behind);
        for (std::size_t k = 0; k < 4; ++k) out[cell.stations[k]] = glm::mix(a, b, patch_nodes[k]);
    }
    return out;
}

std::vector<double> heights_now(const StrandInput& input, const std::vector<StrandNodes>& nodes)
{
    const TileLook& look = input.tiling.look;
    const StrandLayout& layout = input.layout->strands;
    TileLook wave{
        .wave = look.wave, .wave_length = look.wave_length, .wave_direction = look.wave_direction};
    const std::vector<double> shares = random_shares(layout);
    std::vector<double> out = station_heights(layout, nodes);
    for (std::size_t s = 0; s < out.size(); ++s) {
        const StrandStation& station = layout.stations[s];
        wave.wave_phase = look.wave_phase + look.wave_variation * shares[s];
        const TileMotion motion =
            motion_of(wave, *input.layout, Tile{}, input.base->position(station.at));
        out[s] *= look.scale * look.height * station.height * motion.height;
    }
    return out;
}

// The tiles of each kind, in each of its places.
using TilesOfKinds = std::vector<std::array<std::vector<PlacedTile>, 2>>;

// The strands with their tiles where these have gone.
SlidStrands strands_now(const StrandInput& input, const std::vector<StrandNodes>& nodes)
{
    const StrandLayout& layout = input.layout->strands;
    std::vector<double> heights = heights_now(input, nodes);
    if (const double cells = input.tiling.look.slide_along; cells != 0)
        return slid_strands(layout, nodes, heights, cells);
    SlidStrands out{layout, nodes, std::move(heights), {}};
    for (std::uint32_t c = 0; c < layout.cells.size(); ++c) out.lies_on.push_back({c, c});
    return out;
}

TilesOfKinds tiles_of_strands(const StrandInput& input, const std::vector<StationChart>& charts,
                              const PosedStrands& posed, const KindPlaces& places, StrandParts& to)
{
    const TileLook& look = input.tiling.look;
    const std::vector<StrandCell>& laid = input.layout->strands.cells;
    const SlidStrands now = strands_now(input, posed.nodes);
    const StrandLayout& layout = now.layout;
    std::vector<char> mirrored;
    for (const auto& lies_on : now.lies_on)
        mirrored.push_back(posed.mirrored[charts[laid[lies_on[0]].stations[0]].piece]);
    const std::vector<char> none(layout.cells.size(), 0);
    GuardedStrands guarded{now.heights, none, none, std::vector<double>(none.size(), 0)};
    if (look.guard)
        guarded =
            guarded_strands(layout, now.nodes, now.heights, mirrored, places.top, places.reach);
    const auto cut = [&](std::uint32_t cell) {
        return std::ranges::any_of(laid[cell].stations, [&](std::uint32_t station) {
            return charts[station].cut > most_cut;
        });
    };
    TilesOfKinds out(places.of.size());
    for (std::size_t c = 0; c < layout.cells.size(); ++c) {
        const StrandCell& cell = layout.cells[c];
        const auto there = grown(cell, look.growth, input.layout->duration_s);
        if (cell.gone || !there) continue;
        if (std::ranges::any_of(now.lies_on[c], cut)) {
            ++to.counts.at_borders;
            continue;
        }
        if (guarded.folded[c]) {
            ++to.counts.folded;
            continue;
        }
        to.counts.lowered += guarded.lowered[c];
        double& of_limit = to.of_limit[static_cast<std::size_t>(cell.stroke)];
        of_limit = std::max(of_limit, guarded.of_limit[c]);
        const std::size_t kind = input.kinds.choice.of(cell.seed, cell.morph_factor, cell.morph);
        const std::vector<StrandPlace>& of_kind = places.of[kind];
        const std::size_t which = static_cast<std::size_t>(cell.number & 1) % of_kind.size();
        PlacedTile tile{strand_patch(layout, c, now.nodes, guarded.heights, mirrored[c] != 0)};
        if (*there != glm::dvec2(0, 1)) tile.patch = part_along_x(tile.patch, there->x, there->y);
        tile.base = -look.sink * of_kind[which].top;
        tile.tint = glm::vec3(cell.tint);
        tile.of_limit = static_cast<float>(guarded.of_limit[c]);
        out[kind][which].push_back(tile);
    }
    return out;
}

} // namespace

std::vector<StrandPlace> strand_places(const TileKind& kind, const TileLook& of_layer)
{
    const TileLook look = look_of(kind, of_layer);
    const Box box = turned_box(kind, glm::dmat4(1), false);
    if (box.empty()) return {{}};
    const glm::dvec3 size = box.size(),
                     lo = box.lo + glm::dvec3(look.cell_x0, look.cell_y0, 0) * size,
                     hi = box.lo + glm::dvec3(look.cell_x1, look.cell_y1, 1) * size;
    const glm::dvec3 axis(0, (lo.y + hi.y) / 2, (lo.z + hi.z) / 2);
    const double whole = std::max({hi.x - lo.x, 1e-6 * size.y, 1e-6 * size.z, 1e-9}),
                 length = whole / (1 + 2 * look.overlap);
    const bool rolls = look.roll_deg != 0 || look.alternate_deg != 0;
    std::vector<StrandPlace> out;
    double floor = std::numeric_limits<double>::infinity();
    for (int k = 0; k < (look.alternate_deg != 0 ? 2 : 1); ++k) {
        StrandPlace place;
        if (rolls)
            place.turn =
                glm::translate(glm::dmat4(1), axis) *
                glm::rotate(glm::dmat4(1), glm::radians(look.roll_deg + k * look.alternate_deg),
                            glm::dvec3(1, 0, 0)) *
                glm::translate(glm::dmat4(1), -axis);
        const Box turned = turned_box(kind, place.turn, false);
        place.half_width =
            rolls ? std::max(turned.hi.y - axis.y, axis.y - turned.lo.y) : (hi.y - lo.y) / 2;
        place.half_width = std::max(place.half_width, 1e-6 * length);
        place.length = length;
        place.origin = {lo.x + (whole - length) / 2, axis.y, 0};
        floor = std::min(floor, turned.lo.z + look.base_level * turned.size().z);
        out.push_back(place);
    }
    double top = 0;
    for (const StrandPlace& place : out)
        top = std::max(top, turned_box(kind, place.turn, true).hi.z - floor);
    for (StrandPlace& place : out) { // all on one floor, and all as deep
        place.origin.z = floor;
        place.top = top / length;
    }
    return out;
}

Ref<Strands::Charts> Strands::charts(const StrandInput& input, double width)
{
    return charts_({input.base, input.limit.base, input.layout, width}, [](const ChartInput& in) {
        const std::vector<StrandStation>& stations = in.layout->strands.stations;
        Charts out(stations.size());
        parallel_blocks(out.size(), 64, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                out[i] = station_chart(*in.base, in.limit.get(), stations[i],
                                       in.width * stations[i].width);
        });
        return make_ref(std::move(out));
    });
}

Strands::Model Strands::model(const TileKind& kind, const Part& part, const glm::dmat4& unit)
{
    return models_(
        unit_tile(kind, part, unit * kind.turned * part.to_world), [](const UnitTile& in) -> Model {
            StrandTile tile = strand_tile(
                with_materials_from(in_unit_cell(*in.mesh, in.to_unit), in.first_material));
            return {tile_model(std::move(tile.mesh), !in.moves), tile.unmatched};
        });
}

StrandParts Strands::operator()(const StrandInput& input)
{
    StrandParts out;
    const StrandLayout& layout = input.layout->strands;
    if (layout.too_short > 0)
        out.notices.push_back(
            layout.too_short == 1
                ? "1 strand is too short for a tile; draw it longer or make its tiles smaller"
                : fmt::format("{} strands are too short for a tile; draw them longer or make their "
                              "tiles smaller",
                              layout.too_short));
    if (layout.cells.empty()) return out;
    const KindPlaces places = places_of(input.kinds, input.tiling.look);
    std::vector<std::size_t> counts(places.of.size(), 0);
    for (const StrandCell& cell : layout.cells)
        if (!cell.gone)
            counts[input.kinds.choice.of(cell.seed, cell.morph_factor, cell.morph)] +=
                input.members.size();
    out.of_limit.assign(input.tiling.strokes.size(), 0);
    if (std::string words = too_many_words(input.kinds.all, counts); !words.empty()) {
        out.notices.push_back(std::move(words));
        return out;
    }
    bool unmatched = false;
    for (const auto& numbered : input.members) {
        const int member = numbered.first;
        const std::vector<Part>& parts = numbered.second;
        if (parts.size() != input.pieces.size()) continue; // a part is too far away
        timed(input.timings, "tiles", [&] {
            const Ref<Charts> at_rest = charts(input, places.aspect * input.tiling.look.scale);
            TilesOfKinds tiles = tiles_of_strands(
                input, *at_rest, posed_strands(input, *at_rest, parts), places, out);
            for (std::size_t k = 0; k < tiles.size(); ++k)
                for (std::size_t which = 0; which < places.of[k].size(); ++which) {
                    if (tiles[k][which].empty()) continue;
                    const auto all = make_ref(std::move(tiles[k][which]));
                    const auto here = make_ref(PlacedTiles(all));
                    const TileKind& kind = input.kinds.all[k];
                    const glm::dmat4 unit = unit_of(places.of[k][which], places.aspect);
                    for (const Part& part : kind.parts) {
                        if (part.rest->positions.empty()) continue;
                        const Model of_part = model(kind, part, unit);
                        unmatched |= of_part.unmatched > 0;
                        Lazy<Ref<Mesh>> mesh([tile = of_part.tile, all] {
                            return make_ref(strand_mesh(*tile->mesh, *all));
                        });
                        out.parts.push_back(part_of(tile_set(of_part.tile, here, std::move(mesh)),
                                                    {member, part.key.mesh + kind.first_mesh,
                                                     strand_piece + static_cast<int>(which)}));
                    }
                }
        });
    }
    if (unmatched)
        out.notices.push_back("the two ends of its tile do not match along X, so tiles do not "
                              "close up; set where its cell begins and ends");
    return out;
}

} // namespace trivar
