// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/patches/tile_set.h"

#include "core/base/parallel.h"
#include "core/mesh/mesh_copies.h"

#include <algorithm>
#include <set>
#include <unordered_map>
#include <utility>

namespace trivar {
namespace {

bool holds(const Box& outer, const Box& inner)
{
    return glm::all(glm::greaterThanEqual(inner.lo, outer.lo)) &&
           glm::all(glm::lessThanEqual(inner.hi, outer.hi));
}

// The number of the tile whose hull comes first by a number of it.
template <class Key> std::size_t first_by(const TileSet& set, Key&& key)
{
    const auto run =
        static_cast<std::size_t>(std::ranges::min_element(set.hulls, {}, key) - set.hulls.begin());
    const std::vector<TileSet::Extent>& extents = *set.extents.runs()[run];
    const auto in_run = std::ranges::min_element(
        extents, {}, [&](const TileSet::Extent& each) { return key(each.hull); });
    return set.extents.begin_of(run) + static_cast<std::size_t>(in_run - extents.begin());
}

// Returns the box of all vertices. Tiles whose hull lies inside of the box so far are not bent.
Box box_of(const TileSet& set)
{
    Box out;
    if (set.tiles->empty()) return out;
    const TileVertices vertices(*set.model->mesh);
    std::vector<glm::vec3> positions(vertices.count);
    const auto add = [&](std::size_t i) {
        const TilePowers tile = powers_of((*set.tiles)[i]);
        bend_vertices(vertices, tile, glm::vec3(0), {positions.data(), nullptr, nullptr});
        for (const glm::vec3& p : positions) out.add(tile.origin + glm::dvec3(p));
    };
    // Takes the tiles whose hulls reach out furthest first: they leave little for others to add.
    for (int axis = 0; axis < 3; ++axis) {
        add(first_by(set, [axis](const Box& hull) { return hull.lo[axis]; }));
        add(first_by(set, [axis](const Box& hull) { return -hull.hi[axis]; }));
    }
    for (std::size_t r = 0; r < set.hulls.size(); ++r) {
        if (holds(out, set.hulls[r])) continue;
        const std::vector<TileSet::Extent>& extents = *set.extents.runs()[r];
        for (std::size_t k = 0; k < extents.size(); ++k)
            if (!holds(out, extents[k].hull)) add(set.extents.begin_of(r) + k);
    }
    return out;
}

template <class Tiles> void tint_all(Mesh& copies, const Tiles& tiles)
{
    if (std::none_of(tiles.begin(), tiles.end(), is_tinted)) return;
    const std::size_t count = copies.vertex_count() / tiles.size();
    copies.colors.resize(copies.vertex_count(), glm::vec4(1));
    parallel_blocks(tiles.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const PlacedTile& each = tiles[i];
            for (std::size_t v = i * count; is_tinted(each) && v < (i + 1) * count; ++v) {
                glm::vec4& color = copies.colors[v];
                color = {each.tint * glm::mix(glm::vec3(color), glm::vec3(1), each.tint_over),
                         color.a};
            }
        }
    });
}

template <class Tiles> Mesh all_bent(const Mesh& unit, const Tiles& tiles)
{
    const std::size_t count = unit.vertex_count(), copies = tiles.size();
    Mesh out = copies_of(unit, copies, false);
    tint_all(out, tiles);
    const TileVertices vertices(unit);
    parallel_blocks(copies, 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const TilePowers tile = powers_of(tiles[i]);
            const std::size_t to = i * count;
            bend_vertices(vertices, tile, glm::vec3(tile.origin),
                          {out.positions.data() + to,
                           out.normals.empty() ? nullptr : out.normals.data() + to,
                           out.tangents.empty() ? nullptr : out.tangents.data() + to});
        }
    });
    return out;
}

} // namespace

Mesh in_unit_cell(const Mesh& mesh, const glm::dmat4& to_model, const TileCell& cell)
{
    glm::dmat4 to_unit(1.0 / cell.side);
    to_unit[3] = glm::dvec4(glm::dvec3(0.5, 0.5, 0) - cell.middle_of_floor / cell.side, 1);
    return in_unit_cell(mesh, to_unit * to_model);
}

Mesh in_unit_cell(const Mesh& mesh, const glm::dmat4& to_unit)
{
    Mesh out = transformed(mesh, to_unit);
    out.influences.clear();
    out.morph_targets.clear();
    out.creases.clear();
    return out;
}

Ref<TileModel> tile_model(Mesh in_unit_cell, bool with_levels)
{
    const Box box = bounding_box(in_unit_cell);
    const Ref<Mesh> mesh = make_ref(std::move(in_unit_cell));
    return make_ref(
        TileModel{mesh, box, Lazy<std::vector<TileLevel>>([mesh, with_levels] {
                      return with_levels ? levels_of(mesh) : std::vector<TileLevel>{{mesh, 0}};
                  })});
}

Ref<TileSet> tile_set(const Ref<TileModel>& model, const Ref<PlacedTiles>& tiles,
                      const Ref<TileSet>& before)
{
    return tile_set(model, tiles, Lazy<Ref<Mesh>>([model, tiles] {
                        return make_ref(bent_tiles(*model->mesh, *tiles));
                    }),
                    before);
}

Ref<TileSet> tile_set(const Ref<TileModel>& model, const Ref<PlacedTiles>& tiles,
                      Lazy<Ref<Mesh>> mesh, const Ref<TileSet>& before)
{
    TileSet out{model, tiles, {}, {}, {}, std::move(mesh)};
    using Extents = Runs<TileSet::Extent>::Run;
    const std::vector<PlacedTiles::Run>& runs = tiles->runs();
    std::vector<Extents> extents(runs.size());
    out.hulls.resize(runs.size());
    std::unordered_map<const void*, std::size_t> known;
    if (before && before->model == model)
        for (const PlacedTiles::Run& run : before->tiles->runs()) known[run.get()] = known.size();
    parallel_blocks(runs.size(), 2, [&](std::size_t begin, std::size_t end) {
        for (std::size_t r = begin; r < end; ++r) {
            if (const auto found = known.find(runs[r].get()); found != known.end()) {
                extents[r] = before->extents.runs()[found->second];
                out.hulls[r] = before->hulls[found->second];
                continue;
            }
            std::vector<TileSet::Extent> made(runs[r]->size());
            parallel_blocks(made.size(), 64, [&](std::size_t from, std::size_t to) {
                for (std::size_t i = from; i < to; ++i)
                    made[i] = {hull_box((*runs[r])[i], model->box),
                               stretch_bound((*runs[r])[i], model->box)};
            });
            for (const TileSet::Extent& each : made) out.hulls[r].add(each.hull);
            extents[r] = make_ref(std::move(made));
        }
    });
    for (const Extents& run : extents) out.extents.add(run);
    out.box = box_of(out);
    return make_ref(std::move(out));
}

Mesh bent_tiles(const Mesh& unit, std::span<const PlacedTile> tiles)
{
    return all_bent(unit, tiles);
}

Mesh bent_tiles(const Mesh& unit, const PlacedTiles& tiles)
{
    return all_bent(unit, tiles);
}

void tint_copies(Mesh& copies, std::span<const PlacedTile> tiles)
{
    tint_all(copies, tiles);
}

std::vector<glm::dvec3> outer_points(const TileModel& model, const PlacedTiles& tiles)
{
    const std::vector<glm::vec3>& all = model.mesh->positions;
    std::set<std::size_t> outer;
    for (int way = 0; way < 27 && !all.empty(); ++way) {
        const glm::vec3 along(way % 3 - 1, way / 3 % 3 - 1, way / 9 - 1);
        const auto nearer = [&](const glm::vec3& a, const glm::vec3& b) {
            return glm::dot(a, along) < glm::dot(b, along);
        };
        outer.insert(static_cast<std::size_t>(std::ranges::max_element(all, nearer) - all.begin()));
    }
    std::vector<glm::dvec3> out;
    out.reserve(outer.size() * tiles.size());
    for (const PlacedTile& tile : tiles)
        for (const std::size_t v : outer) {
            const glm::dvec3 p(all[v]);
            out.push_back(tile_point(tile.patch, {p.x, p.y, tile.height * p.z + tile.base}).p);
        }
    return out;
}

} // namespace trivar
