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

// Returns the height in the cell's model of a metre of a kind.
double z_scale(const TileKind& kind, const glm::dmat4& turned)
{
    double out = 0;
    for (const Part& part : kind.parts)
        out = std::max(out, std::abs((turned * kind.turned * part.to_world)[2].z));
    return out;
}

// Sets the share of each tile that is shown. Tiles grow from the lowest one up.
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

// A Plan says which base is covered by which kinds, the same for all members of a procession.
struct Covers::Plan {
    const CoverInput& input;
    glm::dmat4 turned;            // of the tiles, at quarter turns
    std::vector<CoverCell> cells; // #kinds
    double highest = 0;           // of all kinds, in lengths of a tile
    Ref<CoverLayout> laid = nullptr;
    Ref<Uvs> uvs = nullptr;           // null: nobody asked
    std::vector<char> displaced = {}; // #kinds: it is a picture over the UVs of the base
    Ref<CoverMasks> masked = nullptr;
    std::vector<std::size_t> kinds = {}; // #tiles
};

// A Standing is the covering as one member of the base stands.
struct Covers::Standing {
    const std::vector<Part>& parts; // of the member
    CoveringPose pose;
    GuardedHeights guarded = {};
    Ref<CoveringPose> shared = nullptr;   // the same pose, when it is ready
    std::vector<ChosenTiles> chosen = {}; // #kinds
};

Covers::Plan Covers::cells_of(const CoverInput& input)
{
    const TileLook& look = input.tiling.look;
    Plan plan{input, quarter_turns(look.turn_deg), {}};
    for (const TileKind& kind : input.kinds.all) {
        const Box box = box_of_kind(kind, plan.turned);
        const CoverCell& cell = plan.cells.emplace_back(cover_cell(box, look));
        const double top = kind.over_uvs ? kind.over_uvs->highest * z_scale(kind, plan.turned)
                                         : reach_over(box, kind.parts, plan.turned * kind.turned);
        const double reach = top - (look.base_level == 0 ? 0 : cell.lo.z - box.lo.z);
        plan.highest = std::max(plan.highest, (reach - look.sink * cell.size.z) / cell.size.x);
    }
    return plan;
}

Ref<CoverLayout> Covers::layout(const CoverInput& input, const glm::dvec2& size)
{
    const TileCover& all = input.tiling.cover;
    const TileCover cover{.pattern = all.pattern, .size = all.size, .per_face = all.per_face};
    return layouts_(
        {input.pieces, input.limit.base, cover, size},
        [](const LayoutInput& in, Timings& timings) {
            return timed(timings, "tiles", [&] {
                return make_ref(cover_layout(in.pieces, in.limit, in.cover, in.size));
            });
        },
        input.timings);
}

void Covers::find_uvs(Plan& plan, std::vector<std::string>& notices)
{
    const auto is_displaced = [](const TileKind& kind) { return kind.over_uvs.has_value(); };
    const std::vector<TileKind>& kinds = plan.input.kinds.all;
    if (std::ranges::any_of(kinds, is_displaced)) {
        plan.uvs = uvs_({plan.input.pieces, plan.laid}, [](const UvsInput& in) {
            return make_ref(chart_uvs_of(in.pieces, *in.layout));
        });
        if (!*plan.uvs)
            notices.push_back(fmt::format(
                "what it displaces {}, so the picture lies over each tile; unwrap it first",
                lacks_uvs_words));
    }
    for (const TileKind& kind : kinds)
        plan.displaced.push_back(plan.uvs && *plan.uvs && is_displaced(kind));
}

Ref<Covers::CoverMasks> Covers::masks(const CoverInput& input, const Ref<CoverLayout>& layout)
{
    if (!input.masks.masks) return make_ref(CoverMasks{});
    return masks_(
        {layout, input.masks},
        [](const MaskInput& in, Timings& timings) {
            return timed(timings, "tiles", [&] {
                CoverMasks out;
                if (in.masks.drive(MaskDrives::density) || in.masks.drive(MaskDrives::scale) ||
                    in.masks.drive(MaskDrives::morph))
                    out.tiles = in.masks.at(in.layout->middles);
                if (in.masks.drive(MaskDrives::height))
                    for (const MaskFactors& each : in.masks.at(in.layout->rest))
                        out.heights.push_back(each.height);
                return make_ref(std::move(out));
            });
        },
        input.timings);
}

// Returns the number of tiles of each kind.
std::vector<std::size_t> Covers::choose_kinds(Plan& plan)
{
    const CoverInput& input = plan.input;
    std::vector<std::size_t> counts(plan.cells.size(), 0);
    for (std::size_t k = 0; k < plan.laid->covering->tiles().size(); ++k) {
        plan.kinds.push_back(
            input.kinds.choice.of(seed_of(input.tiling.cover.seed, 0, 0, k),
                                  plan.masked->tiles.empty() ? 1 : plan.masked->tiles[k].morph));
        counts[plan.kinds.back()] += input.members.size();
    }
    return counts;
}

Covers::Standing Covers::standing(const Plan& plan, const std::vector<Part>& parts)
{
    const Covering& covering = *plan.laid->covering;
    const Tiling& tiling = plan.input.tiling;
    Standing out{parts, pose_of(*plan.laid, plan.input.pieces, parts)};
    CoveringPose& pose = out.pose;
    pose.heights = heights_along_rows(covering, pose.points, tiling.look.height);
    if (tiling.cover.even_height)
        std::ranges::fill(pose.heights,
                          even_height(plan.input, parts, *plan.laid,
                                      plan.cells.front().size.x * tiling.look.height));
    for (std::size_t n = 0; n < plan.masked->heights.size(); ++n)
        pose.heights[n] *= plan.masked->heights[n];
    set_factors(pose, *plan.laid, tiling, plan.masked->tiles);
    if (!tiling.look.guard) return out;
    const double most = pose.factors.empty() ? 1 : *std::ranges::max_element(pose.factors);
    out.guarded = guarded_heights(covering, pose, most * plan.highest);
    pose.heights = out.guarded.heights;
    return out;
}

void Covers::add_kind(const Plan& plan, Standing& there, std::size_t k, int member, CoverParts& out)
{
    const TileKind& kind = plan.input.kinds.all[k];
    const Ref<CoveringPose>& pose = there.shared;
    const auto patched = make_ref(std::move(there.chosen[k].patched));
    const auto patches = make_ref(PlacedTiles(std::move(there.chosen[k].patches)));
    const std::vector<std::uint32_t>& meshed = there.chosen[k].meshed;
    for (const Part& part : kind.parts) {
        if (part.rest->positions.empty()) continue;
        const glm::dmat4 to_model = plan.turned * kind.turned * part.to_world,
                         to_unit = to_unit_cell(plan.cells[k]) * to_model;
        PartKey key{member, part.key.mesh + kind.first_mesh, patched_piece};
        const CoverModel model =
            models_(unit_tile(kind, part, to_unit), [](const UnitTile& in) -> CoverModel {
                const auto mesh = make_ref(with_materials_from(*in.mesh, in.first_material));
                return {mesh, tile_model(in_unit_cell(*mesh, in.to_unit), !in.moves)};
            });
        const auto bent = [mesh = model.mesh, to_model, cell = plan.cells[k], laid = plan.laid,
                           pose](const std::vector<std::uint32_t>& tiles) {
            return make_ref(covered_tiles(*mesh, to_model, cell, *laid->covering, *pose, tiles));
        };
        if (!patched->empty())
            out.parts.push_back(
                part_of(tile_set(model.tile, patches,
                                 Lazy<Ref<Mesh>>([bent, patched] { return bent(*patched); })),
                        key));
        if (meshed.empty()) continue;
        const Ref<Mesh> rest =
            plan.displaced[k]
                ? make_ref(displaced_tiles(
                      *model.mesh, to_model, plan.cells[k], *plan.laid->covering, *pose, meshed,
                      {*kind.over_uvs->image, kind.over_uvs->sheet, **plan.uvs, net_of(*plan.laid),
                       surface_of(*plan.laid, plan.input.pieces, there.parts)}))
                : bent(meshed);
        key.piece = meshed_piece;
        out.parts.push_back({.rest = rest, .key = key, .bounds = bounding_box(*rest)});
    }
}

void Covers::add_member(const Plan& plan, int member, const std::vector<Part>& parts,
                        CoverParts& out)
{
    Standing there = standing(plan, parts);
    for (const double each : there.guarded.of_limit) out.of_limit = std::max(out.of_limit, each);
    there.chosen = chosen_tiles(*plan.laid->covering, there.pose, plan.kinds, plan.cells,
                                plan.displaced, there.guarded, out.counts);
    there.shared = make_ref(std::move(there.pose));
    for (std::size_t k = 0; k < plan.cells.size(); ++k) add_kind(plan, there, k, member, out);
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
    Plan plan = cells_of(input);
    const glm::dvec3& first = plan.cells.front().size;
    const double width = std::clamp(first.y / first.x, 1e-3, 1e3);
    plan.laid = layout(input, {cover.size, width * cover.size});
    if (!plan.laid->covering) {
        out.notices.push_back(plan.laid->trouble);
        return out;
    }
    if (plan.laid->crowded)
        out.notices.push_back("its tiles are smaller than their size says: each face of what they "
                              "cover carries one at least");
    find_uvs(plan, out.notices);
    plan.masked = masks(input, plan.laid);
    const std::vector<std::size_t> counts = choose_kinds(plan);
    if (std::string words = too_many_words(input.kinds.all, counts); !words.empty()) {
        out.notices.push_back(std::move(words));
        return out;
    }
    for (const auto& [member, parts] : input.members)
        if (parts.size() == input.pieces.size()) // else a part is too far away
            timed(input.timings, "tiles", [&, number = member, &of_member = parts] {
                add_member(plan, number, of_member, out);
            });
    return out;
}

} // namespace trivar
