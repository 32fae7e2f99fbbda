// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/evaluation/tiling.h"

#include "core/base/parallel.h"
#include "core/tiles/fold_limit.h"
#include "core/tiles/tile_motion.h"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace trivar {
namespace {

// Largest number of vertices of all tiles together, of about 60 bytes each, and of corners of
// faces.
constexpr std::size_t most_vertices = 16'000'000, most_corners = 6 * most_vertices;
// Tiles of which a border cuts off more than this share of their size are left out.
constexpr double most_cut = 0.2;
// Lowered tiles stay below the proven limit by this factor, for the rounding of positions.
constexpr double below_limit = 0.98;
// Tiles that have grown to less than this share of their size are not shown.
constexpr double smallest = 1e-3;

// Groups the parts of the base by the members of a procession.
std::map<int, std::vector<Part>> by_member(const EvaluatedObject& base)
{
    std::map<int, std::vector<Part>> out;
    for (const Part& part : base.parts) out[part.key.member].push_back(part);
    return out;
}

BasePose pose_of(const TileBase& base, const std::vector<Part>& parts)
{
    BasePose pose;
    pose.points.reserve(base.points().size());
    for (const Part& part : parts) {
        const Mesh& mesh = *part.mesh();
        const std::size_t before = pose.points.size();
        pose.points.resize(before + point_count(mesh));
        for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v)
            pose.points[before + mesh.point(v)] =
                glm::dvec3(part.to_world * glm::dvec4(mesh.positions[v], 1));
    }
    std::vector<glm::uvec3> triangles;
    for (std::uint32_t t = 0; t < base.triangle_count(); ++t) {
        triangles.push_back(base.triangle(t));
        // A mirror on the way to the world turns the faces round, as it does in the picture.
        if (const glm::dmat3 m(parts[base.piece_of(t)].to_world); glm::determinant(m) < 0)
            std::swap(triangles.back().y, triangles.back().z);
    }
    pose.normals = angle_normals(pose.points, triangles);
    return pose;
}

double side_in_world(const TilePatch& patch)
{
    const auto at = [&](double x, double y) { return tile_point(patch, {x, y, 0}).p; };
    return (glm::distance(at(0, 0.5), at(1, 0.5)) + glm::distance(at(0.5, 0), at(0.5, 1))) / 2;
}

// TileCounts are the numbers of tiles that a notice is given of.
struct TileCounts {
    int lowered = 0, folded = 0, at_borders = 0;
};

// Adds the tiles that have room, each as high as it may be, to those of their kind. `kinds` and
// `cells` hold the kind of each tile and the cell of each kind.
void place_tiles(std::vector<std::vector<PlacedTile>>& out, const TileBase& base,
                 const TileLayout& layout, const std::vector<TileChart>& charts,
                 const BasePose& pose, const TileLook& look, const std::vector<std::size_t>& kinds,
                 const std::vector<TileCell>& cells, TileCounts& told)
{
    enum class Fate : char { as_wanted, lowered, folded, at_border, not_grown };
    std::vector<PlacedTile> all(charts.size());
    std::vector<Fate> fates(charts.size(), Fate::as_wanted);
    parallel_blocks(charts.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            if (charts[i].cut > most_cut) {
                fates[i] = Fate::at_border;
                continue;
            }
            PlacedTile& tile = all[i];
            const TileCell& cell = cells[kinds[i]];
            const TileMotion motion =
                motion_of(look, layout, layout.tiles[i], base.position(layout.tiles[i].at));
            if (motion.size < smallest) {
                fates[i] = Fate::not_grown;
                continue;
            }
            tile.patch = patch_of(base, pose, charts[i]);
            if (motion.size < 1) tile.patch = middle_of(tile.patch, motion.size);
            tile.height =
                side_in_world(tile.patch) * layout.tiles[i].height * look.height * motion.height;
            const double top = tile.height * cell.top / cell.side;
            tile.base = -look.sink * top;
            if (!look.guard) continue;
            const double limit = fold_limit(tile.patch);
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

glm::dmat4 mesh_to_model(const EvaluatedObject& base, const Object& object, const Part& part)
{
    if (object.tiles) return part.to_world; // its tiles are no meshes of its model
    for (const Shape::NodeMesh& each : base.shape->meshes) {
        if (each.slot != part.key.mesh) continue;
        const glm::dmat3 turned(object.transform.matrix());
        // A part in a volume was turned inside out before, if its node mirrors it.
        if (part.bent && object.stroke && glm::determinant(turned * glm::dmat3(each.to_model)) < 0)
            return glm::dmat4(glm::inverse(turned));
        return each.to_model;
    }
    return glm::dmat4(1);
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

    Pieces pieces;
    for (const Part& part : members.begin()->second)
        pieces.push_back({input.ray_meshes(part.rest, input.timings),
                          mesh_to_model(*shown, object(input.document, tiling.base), part)});
    const Ref<TileBase> base =
        bases_(pieces, [&] { return std::make_shared<const TileBase>(pieces); });
    const Ref<TileLayout> layout = layouts_({base, tiling.strokes}, [&] {
        return timed(input.timings, "tiles",
                     [&] { return make_ref(layout_of(*base, tiling.strokes, input.progress)); });
    });
    const TileLook& look = tiling.look;
    const auto charts =
        charts_({layout, look.turn_deg, look.scale, {look.slide_x, look.slide_y}}, [&] {
            return timed(input.timings, "tiles", [&] {
                std::vector<TileChart> out(layout->tiles.size());
                parallel_blocks(out.size(), 64, [&](std::size_t begin, std::size_t end) {
                    for (std::size_t i = begin; i < end; ++i)
                        if (const auto tile = slid(*base, layout->tiles[i], look))
                            out[i] = chart_of(*base, *tile, look.turn_deg, look.scale);
                        else
                            out[i].cut = std::numeric_limits<double>::infinity();
                });
                return make_ref(std::move(out));
            });
        });
    const TileKinds of_layer = kinds_of_(*before, input);
    return painted_({before, shown, charts, look, of_layer}, [&] {
        const std::vector<TileKind>& kinds = of_layer.all;
        std::vector<std::vector<Ref<TileModel>>> models(kinds.size());
        std::vector<TileCell> cells;
        for (std::size_t k = 0; k < kinds.size(); ++k) {
            cells.push_back(tile_cell(kinds[k].parts, kinds[k].turned));
            for (std::size_t i = 0; i < kinds[k].parts.size(); ++i)
                models[k].push_back(kinds_of_.model(kinds[k], i, cells[k]));
            // A tile that moves may be higher than at rest.
            for (std::size_t i = 0; i < models[k].size(); ++i)
                if (kinds[k].parts[i].posed || kinds[k].morph != 0)
                    cells[k].top = std::max(cells[k].top, cells[k].side * models[k][i]->box.hi.z);
        }
        std::vector<std::size_t> kind_of_tile;
        for (const Tile& tile : layout->tiles) kind_of_tile.push_back(of_layer.of(tile.seed));
        TileCounts told;
        std::vector<std::vector<PlacedTile>> all(kinds.size());
        for (const auto& [member, parts] : members) {
            if (parts.size() != pieces.size()) continue; // a part is too far away
            timed(input.timings, "tiles", [&] {
                place_tiles(all, *base, *layout, *charts, pose_of(*base, parts), look, kind_of_tile,
                            cells, told);
            });
        }
        std::size_t count = 0, vertices = 0, corners = 0;
        for (std::size_t k = 0; k < kinds.size(); ++k) {
            count += all[k].size();
            for (const Part& part : kinds[k].parts) {
                vertices += part.rest->vertex_count() * all[k].size();
                corners += part.rest->corners.size() * all[k].size();
            }
        }
        if (vertices > most_vertices || corners > most_corners)
            return refused(before,
                           fmt::format("its {} tiles would have {} vertices and {} corners of "
                                       "faces; at most {} and {} are drawn, so simplify the "
                                       "object or paint fewer tiles",
                                       count, vertices, corners, most_vertices, most_corners));
        Stage stage = cleared(*before);
        stage.own_to_world = glm::dmat4(1);
        stage.mixed_materials = materials_of_others(of_layer);
        for (std::size_t k = 0; k < kinds.size(); ++k) {
            if (all[k].empty()) continue;
            const Ref<std::vector<PlacedTile>> places = make_ref(std::move(all[k]));
            for (std::size_t i = 0; i < kinds[k].parts.size(); ++i) {
                const Part& part = kinds[k].parts[i];
                if (part.rest->positions.empty()) continue;
                PartKey key = part.key;
                key.mesh += kinds[k].first_mesh;
                stage.parts.push_back(timed(input.timings, "tiles", [&] {
                    return part_of(tile_set(models[k][i], places), key);
                }));
            }
        }
        if (!of_layer.trouble.empty()) stage.notices.push_back(of_layer.trouble);
        tell(stage, *layout, told);
        return make_ref(std::move(stage));
    });
}

} // namespace trivar
