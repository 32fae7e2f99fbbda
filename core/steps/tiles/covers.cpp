// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/steps/tiles/covers.h"

#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/mesh/mesh_materials.h"
#include "core/steps/tiles/cover_layout.h"
#include "core/tiles/cover_heights.h"
#include "core/tiles/tile_motion.h"

#include <algorithm>
#include <fmt/format.h>

namespace trivar {
namespace {

// Largest number of vertices of all tiles together, of about 60 bytes each, and of corners of
// faces.
constexpr std::size_t most_vertices = 16'000'000, most_corners = 6 * most_vertices;
// A tile is drawn from one patch if that is as near to it as this share of its length: a tenth of
// a pixel for a tile that fills half of the window.
constexpr double most_off = 2e-4;
// Tiles that have grown to less than this share of their size are not shown.
constexpr double least_grown = 1e-3;

enum : int { patched_piece = 1, meshed_piece = 2 }; // of a PartKey; 0 are painted tiles

// Heights stand in z = 0 and not on their lowest point.
Box box_of_kind(const TileKind& kind, const glm::dmat4& turned)
{
    Box box = box_at_rest(kind.parts, turned * kind.turned);
    if (kind.from_zero && !box.empty()) {
        box.lo.z = 0;
        box.hi.z = std::max(0.0, box.hi.z);
    }
    return box;
}

// The box of the model that fills a cell. Cells are entered at quarter turns.
CoverCell cover_cell(const Box& box, const TileLook& look)
{
    if (box.empty()) return {};
    const Box cell = unit_cell_in(box, look);
    return {cell.lo, glm::max(cell.size(), glm::dvec3(1e-9)), look.sink, look.scale};
}

glm::dmat4 quarter_turns(double turn_deg)
{
    const int turns = static_cast<int>(std::lround(std::fmod(turn_deg, 360.0) / 90));
    const glm::dvec2 x = quarter_turned({1, 0}, turns & 3), y = quarter_turned({0, 1}, turns & 3);
    return {x.x, x.y, 0, 0, y.x, y.y, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
}

const ChartNet& net_of(const CoverLayout& layout)
{
    return layout.limit ? layout.limit->surface().net() : layout.facets->net();
}

// How high in the cell's model a metre of a kind is.
double z_scale(const TileKind& kind, const glm::dmat4& turned)
{
    double out = 0;
    for (const Part& part : kind.parts)
        out = std::max(out, std::abs((turned * kind.turned * part.to_world)[2].z));
    return out;
}

// How much of it each tile shows. Tiles grow from the lowest one up.
void set_factors(CoveringPose& pose, const CoverLayout& layout, const Tiling& tiling,
                 const std::vector<MaskFactors>& masked)
{
    const TileLook& look = tiling.look;
    const TileCover& cover = tiling.cover;
    if (cover.height_variation == 0 && look.growth >= 1 && look.wave == 0 && masked.empty()) return;
    double lo = 1e300, hi = -1e300;
    for (const SurfacePoint& at : layout.middles)
        lo = std::min(lo, at.p.z), hi = std::max(hi, at.p.z);
    TileLayout in_time;
    in_time.duration_s = 1;
    for (std::size_t k = 0; k < layout.middles.size(); ++k) {
        Tile tile;
        tile.seed = seed_of(cover.seed, 0, 0, k);
        tile.time_s = hi > lo ? (layout.middles[k].p.z - lo) / (hi - lo) : 0;
        const TileMotion motion = motion_of(look, in_time, tile, layout.middles[k].p);
        const double varied =
            1 - cover.height_variation * random_share(tile.seed, random_purpose::cover_height);
        double size = motion.size;
        if (!masked.empty()) size *= is_there(tile.seed, masked[k].density) ? masked[k].scale : 0;
        pose.factors.push_back(size * motion.height * varied);
        pose.scales.push_back(size);
    }
}

// A height on the base's model as it is in the world.
double even_height(const CoverInput& input, const std::vector<Part>& parts,
                   const CoverLayout& layout, double height)
{
    if (layout.rest.empty()) return height;
    const RestToWorld way(parts.front(), input.pieces.front().to_model);
    return height * way.scale(layout.rest.front().p);
}

// The tiles of one kind.
struct ChosenTiles {
    std::vector<std::uint32_t> patched, meshed; // their numbers
    std::vector<PlacedTile> patches;            // #patched
};

// `kinds` and `cells` hold the kind of each tile and the cell of each kind; no two tiles of a kind
// that is `displaced` are alike.
std::vector<ChosenTiles> chosen_tiles(const Covering& covering, const CoveringPose& pose,
                                      const std::vector<std::size_t>& kinds,
                                      const std::vector<CoverCell>& cells,
                                      const std::vector<char>& displaced,
                                      const GuardedHeights& guarded, TileCounts& told)
{
    const std::size_t count = covering.tiles().size();
    std::vector<PatchedTile> all(count);
    parallel_blocks(count, 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            if (pose.scales.empty() || pose.scales[k] >= least_grown)
                all[k] =
                    patched_tile(cells[kinds[k]], covering, pose, static_cast<std::uint32_t>(k));
    });
    std::vector<ChosenTiles> out(cells.size());
    for (std::uint32_t k = 0; k < count; ++k) {
        if (all[k].cells.empty()) continue; // not grown
        const auto on_one_of = [&](const std::vector<char>& of_cells) {
            return !of_cells.empty() &&
                   std::ranges::any_of(all[k].cells, [&](std::uint32_t c) { return of_cells[c]; });
        };
        if (on_one_of(guarded.folded)) {
            ++told.folded;
            continue;
        }
        told.lowered += on_one_of(guarded.lowered);
        if (!guarded.of_limit.empty())
            for (const std::uint32_t c : all[k].cells)
                all[k].tile.of_limit =
                    std::max(all[k].tile.of_limit, static_cast<float>(guarded.of_limit[c]));
        ChosenTiles& of_kind = out[kinds[k]];
        if (all[k].off <= most_off && !displaced[kinds[k]]) {
            of_kind.patched.push_back(k);
            of_kind.patches.push_back(all[k].tile);
        } else
            of_kind.meshed.push_back(k);
    }
    return out;
}

} // namespace

std::string too_many_words(const std::vector<TileKind>& kinds, std::span<const std::size_t> counts)
{
    std::size_t tiles = 0, vertices = 0, corners = 0;
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        tiles += counts[k];
        for (const Part& part : kinds[k].parts) {
            vertices += part.rest->vertex_count() * counts[k];
            corners += part.rest->corners.size() * counts[k];
        }
    }
    if (vertices <= most_vertices && corners <= most_corners) return {};
    const bool by_vertices = vertices > most_vertices;
    return fmt::format(
        "its {} tiles would have {} {}; at most {} are drawn, so {}", with_commas(tiles),
        with_commas(by_vertices ? vertices : corners / 3), by_vertices ? "vertices" : "triangles",
        with_commas(by_vertices ? most_vertices : most_corners / 3), too_heavy_tiles_words);
}

Ref<CoverLayout> Covers::layout(const CoverInput& input, const glm::dvec2& size)
{
    const TileCover& cover = input.tiling.cover;
    const LayoutKey key{input.pieces, input.limit.base, cover.pattern, size, cover.per_face};
    return layouts_(key, [&] {
        return timed(input.timings, "tiles", [&] {
            return make_ref(cover_layout(input.pieces, input.limit.base, cover, size));
        });
    });
}

Ref<Covers::CoverMasks> Covers::masks(const CoverInput& input, const Ref<CoverLayout>& layout)
{
    const FoundMasks& found = input.masks;
    if (!found.masks) return make_ref(CoverMasks{});
    return masks_({layout, found.masks, found.textured}, [&] {
        return timed(input.timings, "tiles", [&] {
            CoverMasks out;
            if (found.drive(MaskDrives::density) || found.drive(MaskDrives::scale) ||
                found.drive(MaskDrives::morph))
                out.tiles = found.at(layout->middles);
            if (found.drive(MaskDrives::height))
                for (const MaskFactors& each : found.at(layout->rest))
                    out.heights.push_back(each.height);
            return make_ref(std::move(out));
        });
    });
}

CoverParts Covers::operator()(const CoverInput& input)
{
    CoverParts out;
    const TileCover& cover = input.tiling.cover;
    if (cover.pattern == TilePattern::none || cover.pattern == TilePattern::texture) return out;
    if (!input.limit.trouble.empty()) {
        out.notices.push_back(input.limit.trouble);
        return out;
    }
    const TileLook& look = input.tiling.look;
    const glm::dmat4 turned = quarter_turns(look.turn_deg);
    std::vector<CoverCell> cells;
    double highest = 0; // of all kinds, in lengths of a tile
    for (const TileKind& kind : input.kinds.all) {
        const Box box = box_of_kind(kind, turned);
        const CoverCell& cell = cells.emplace_back(cover_cell(box, look));
        const double top = kind.over_uvs ? kind.over_uvs->highest * z_scale(kind, turned)
                                         : reach_over(box, kind.parts, turned * kind.turned);
        const double reach = top - (look.base_level == 0 ? 0 : cell.lo.z - box.lo.z);
        highest = std::max(highest, (reach - look.sink * cell.size.z) / cell.size.x);
    }
    const glm::dvec3& first = cells.front().size;
    const double width = std::clamp(first.y / first.x, 1e-3, 1e3);
    const Ref<CoverLayout> laid = layout(input, {cover.size, width * cover.size});
    if (!laid->covering) {
        out.notices.push_back(laid->trouble);
        return out;
    }
    const Covering& covering = *laid->covering;
    if (laid->crowded)
        out.notices.push_back("its tiles are smaller than their size says: each face of what they "
                              "cover carries one at least");
    const auto is_displaced = [](const TileKind& kind) { return kind.over_uvs.has_value(); };
    Ref<Uvs> uvs;
    if (std::ranges::any_of(input.kinds.all, is_displaced)) {
        uvs = uvs_(laid, [&] { return make_ref(chart_uvs_of(input.pieces, *laid)); });
        if (!*uvs)
            out.notices.push_back(fmt::format(
                "what it displaces {}, so the picture lies over each tile; unwrap it first",
                lacks_uvs_words));
    }
    std::vector<char> displaced;
    for (const TileKind& kind : input.kinds.all)
        displaced.push_back(uvs && *uvs && is_displaced(kind));
    const Ref<CoverMasks> masked = masks(input, laid);
    std::vector<std::size_t> kind_of_tile, counts(cells.size(), 0);
    for (std::size_t k = 0; k < covering.tiles().size(); ++k) {
        kind_of_tile.push_back(input.kinds.of(seed_of(cover.seed, 0, 0, k),
                                              masked->tiles.empty() ? 1 : masked->tiles[k].morph));
        counts[kind_of_tile.back()] += input.members.size();
    }
    if (std::string words = too_many_words(input.kinds.all, counts); !words.empty()) {
        out.notices.push_back(std::move(words));
        return out;
    }
    for (const auto& numbered : input.members) {
        const int member = numbered.first;
        const std::vector<Part>& parts = numbered.second;
        if (parts.size() != input.pieces.size()) continue; // a part is too far away
        timed(input.timings, "tiles", [&] {
            CoveringPose pose = pose_of(*laid, input.pieces, parts);
            pose.heights = heights_along_rows(covering, pose.points, look.height);
            if (cover.even_height)
                std::ranges::fill(pose.heights,
                                  even_height(input, parts, *laid, first.x * look.height));
            for (std::size_t n = 0; n < masked->heights.size(); ++n)
                pose.heights[n] *= masked->heights[n];
            set_factors(pose, *laid, input.tiling, masked->tiles);
            GuardedHeights guarded;
            if (look.guard) {
                const double most =
                    pose.factors.empty() ? 1 : *std::ranges::max_element(pose.factors);
                guarded = guarded_heights(covering, pose, most * highest);
                pose.heights = guarded.heights;
                for (const double each : guarded.of_limit)
                    out.of_limit = std::max(out.of_limit, each);
            }
            std::vector<ChosenTiles> chosen =
                chosen_tiles(covering, pose, kind_of_tile, cells, displaced, guarded, out.counts);
            const auto posed = make_ref(std::move(pose));
            for (std::size_t k = 0; k < cells.size(); ++k) {
                const TileKind& kind = input.kinds.all[k];
                const auto patched = make_ref(std::move(chosen[k].patched));
                const auto patches = make_ref(PlacedTiles(std::move(chosen[k].patches)));
                for (const Part& part : kind.parts) {
                    if (part.rest->positions.empty()) continue;
                    const glm::dmat4 to_model = turned * kind.turned * part.to_world,
                                     to_unit = to_unit_cell(cells[k]) * to_model;
                    PartKey key{member, part.key.mesh + kind.first_mesh, patched_piece};
                    const CoverModel model =
                        models_({part.mesh(), to_unit, kind.first_material}, [&]() -> CoverModel {
                            const auto mesh =
                                make_ref(with_materials_from(*part.mesh(), kind.first_material));
                            return {mesh, tile_model(in_unit_cell(*mesh, to_unit), !part.posed)};
                        });
                    const auto bent = [mesh = model.mesh, to_model, cell = cells[k], laid,
                                       posed](const std::vector<std::uint32_t>& tiles) {
                        return make_ref(
                            covered_tiles(*mesh, to_model, cell, *laid->covering, *posed, tiles));
                    };
                    if (!patched->empty())
                        out.parts.push_back(part_of(
                            tile_set(model.tile, patches,
                                     Lazy<Ref<Mesh>>([bent, patched] { return bent(*patched); })),
                            key));
                    if (chosen[k].meshed.empty()) continue;
                    const Ref<Mesh> rest =
                        displaced[k] ? make_ref(displaced_tiles(
                                           *model.mesh, to_model, cells[k], covering, *posed,
                                           chosen[k].meshed,
                                           {*kind.over_uvs->image, kind.over_uvs->sheet, **uvs,
                                            net_of(*laid), surface_of(*laid, input.pieces, parts)}))
                                     : bent(chosen[k].meshed);
                    key.piece = meshed_piece;
                    out.parts.push_back({.rest = rest, .key = key, .bounds = bounding_box(*rest)});
                }
            }
        });
    }
    return out;
}

} // namespace trivar
