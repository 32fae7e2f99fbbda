// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluation/strands.h"

#include "core/base/parallel.h"
#include "core/evaluation/covers.h"
#include "core/mesh/mesh_materials.h"
#include "core/tiles/fold_limit.h"
#include "core/tiles/strand_tile.h"
#include "core/tiles/tile_motion.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

namespace trivar {
namespace {

enum : int { strand_piece = 3 }; // of a PartKey, and the next number for every other tile
// Cells of which a border cuts off more than this share of their width are left out.
constexpr double most_cell_cut = 0.2;
// Lowered tiles stay below the proven limit by this factor, for the rounding of positions.
constexpr double below_proven = 0.98;

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
};
GuardedStrands guarded_strands(const StrandLayout& layout, const PosedStrands& posed,
                               std::vector<double> heights, const std::vector<char>& mirrored,
                               double top, double reach)
{
    constexpr int most_rounds = 6;
    const std::size_t count = layout.cells.size();
    GuardedStrands out{std::move(heights), std::vector<char>(count, 0),
                       std::vector<char>(count, 0)};
    for (int round = 0; round < most_rounds; ++round) {
        std::vector<double> factors(count, 1);
        parallel_blocks(count, 64, [&](std::size_t begin, std::size_t end) {
            for (std::size_t c = begin; c < end; ++c) {
                if (layout.cells[c].gone || out.folded[c]) continue;
                const TilePatch patch =
                    strand_patch(layout, c, posed.nodes, out.heights, mirrored[c] != 0);
                const double limit = fold_limit(reach > 1 ? middle_of(patch, reach) : patch);
                if (!(limit > 0))
                    out.folded[c] = 1;
                else if (top > below_proven * limit)
                    factors[c] = std::max(0.5, below_proven * limit / top);
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

} // namespace

std::vector<StrandPlace> strand_places(const TileKind& kind, const TileLook& look)
{
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
    for (StrandPlace& place : out) { // all on one floor
        place.origin.z = floor;
        place.top = std::max(0.0, turned_box(kind, place.turn, true).hi.z - floor) / length;
    }
    return out;
}

Ref<Strands::Charts> Strands::charts(const StrandInput& input, double width)
{
    return charts_({input.base, input.layout, width}, [&] {
        const std::vector<StrandStation>& stations = input.layout->strands.stations;
        Charts out(stations.size());
        parallel_blocks(out.size(), 64, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                out[i] = station_chart(*input.base, input.limit.base.get(), stations[i],
                                       width * stations[i].width);
        });
        return make_ref(std::move(out));
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
    const TileLook& look = input.tiling.look;
    std::vector<std::vector<StrandPlace>> places; // of the kinds
    double aspect = 1e-6, top = 0, reach = 1;
    for (const TileKind& kind : input.kinds.all)
        for (const StrandPlace& place : places.emplace_back(strand_places(kind, look))) {
            aspect = std::max(aspect, 2 * place.half_width / place.length);
            top = std::max(top, (1 - look.sink) * place.top);
            const Box box = turned_box(kind, place.turn, true);
            if (!box.empty())
                reach = std::max({reach, 1 + 2 * (place.origin.x - box.lo.x) / place.length,
                                  2 * (box.hi.x - place.origin.x) / place.length - 1});
        }
    std::vector<std::size_t> kind_of_cell, counts(places.size(), 0);
    for (const StrandCell& cell : layout.cells) {
        kind_of_cell.push_back(input.kinds.of(cell.seed));
        counts[kind_of_cell.back()] += input.members.size();
    }
    if (std::string words = too_many_words(input.kinds.all, counts); !words.empty()) {
        out.notices.push_back(std::move(words));
        return out;
    }
    const Ref<Charts> charts =
        timed(input.timings, "tiles", [&] { return this->charts(input, aspect * look.scale); });
    const auto cut = [&](const StrandCell& cell) {
        return std::ranges::any_of(
            cell.stations, [&](std::uint32_t s) { return (*charts)[s].cut > most_cell_cut; });
    };
    int unmatched = 0;
    for (const auto& [member, parts] : input.members) {
        if (parts.size() != input.pieces.size()) continue; // a part is too far away
        timed(input.timings, "tiles", [&] {
            const PosedStrands posed = posed_strands(input, *charts, parts);
            std::vector<double> heights = station_heights(layout, posed.nodes);
            for (std::size_t s = 0; s < heights.size(); ++s) {
                const StrandStation& station = layout.stations[s];
                const TileMotion motion =
                    motion_of({.wave = look.wave,
                               .wave_phase = look.wave_phase,
                               .wave_length = look.wave_length,
                               .wave_direction = look.wave_direction},
                              *input.layout, Tile{}, input.base->position(station.at));
                heights[s] *= look.scale * look.height * station.height * motion.height;
            }
            std::vector<char> mirrored;
            for (const StrandCell& cell : layout.cells)
                mirrored.push_back(posed.mirrored[(*charts)[cell.stations[0]].piece]);
            GuardedStrands guarded{heights, std::vector<char>(layout.cells.size(), 0),
                                   std::vector<char>(layout.cells.size(), 0)};
            if (look.guard)
                guarded = guarded_strands(layout, posed, std::move(heights), mirrored, top, reach);
            // By kind, and by which of its places.
            std::vector<std::array<std::vector<PlacedTile>, 2>> tiles(places.size());
            for (std::size_t c = 0; c < layout.cells.size(); ++c) {
                const StrandCell& cell = layout.cells[c];
                if (cell.gone) continue;
                const auto there = grown(cell, look.growth, input.layout->duration_s);
                if (!there) continue;
                if (cut(cell)) {
                    ++out.counts.at_borders;
                    continue;
                }
                if (guarded.folded[c]) {
                    ++out.counts.folded;
                    continue;
                }
                out.counts.lowered += guarded.lowered[c];
                const std::size_t kind = kind_of_cell[c],
                                  which = static_cast<std::size_t>(cell.number & 1) %
                                          places[kind].size();
                PlacedTile tile{
                    strand_patch(layout, c, posed.nodes, guarded.heights, mirrored[c] != 0)};
                if (*there != glm::dvec2(0, 1))
                    tile.patch = part_along_x(tile.patch, there->x, there->y);
                tile.base = -look.sink * places[kind][which].top;
                tiles[kind][which].push_back(tile);
            }
            for (std::size_t k = 0; k < places.size(); ++k)
                for (std::size_t which = 0; which < places[k].size(); ++which) {
                    if (tiles[k][which].empty()) continue;
                    const auto here = make_ref(std::move(tiles[k][which]));
                    const TileKind& kind = input.kinds.all[k];
                    const glm::dmat4 unit = unit_of(places[k][which], aspect);
                    for (const Part& part : kind.parts) {
                        if (part.rest->positions.empty()) continue;
                        const ModelKey key{part.mesh(), unit * kind.turned * part.to_world,
                                           kind.first_material};
                        const Model model = models_(key, [&]() -> Model {
                            StrandTile tile = strand_tile(with_materials_from(
                                in_unit_cell(*key.mesh, key.to_unit), key.first_material));
                            return {tile_model(std::move(tile.mesh), !part.posed), tile.unmatched};
                        });
                        unmatched += model.unmatched;
                        out.parts.push_back(part_of(
                            tile_set(model.tile, here, Lazy<Ref<Mesh>>([tile = model.tile, here] {
                                         return make_ref(strand_mesh(*tile->mesh, *here));
                                     })),
                            {member, part.key.mesh + kind.first_mesh,
                             strand_piece + static_cast<int>(which)}));
                    }
                }
        });
    }
    if (unmatched > 0)
        out.notices.push_back("the two ends of its tile do not match along X, so tiles do not "
                              "close up; set where its cell begins and ends");
    return out;
}

} // namespace trivar
