// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/patches/tile_set.h"

#include "core/base/parallel.h"
#include "core/mesh/mesh_copies.h"

#include <algorithm>
#include <set>
#include <utility>

namespace trivar {
namespace {

// The box of all vertices. Tiles whose hull lies inside of what is known already are not bent.
Box box_of(const TileModel& model, std::span<const PlacedTile> tiles,
           std::span<const TileSet::Extent> extents)
{
    Box out;
    std::vector<bool> bent(tiles.size(), false);
    const TileVertices vertices(*model.mesh);
    std::vector<glm::vec3> positions(vertices.count);
    const auto add = [&](std::size_t i) {
        if (bent[i]) return;
        bent[i] = true;
        const TilePowers tile = powers_of(tiles[i]);
        bend_vertices(vertices, tile, glm::vec3(0), {positions.data(), nullptr, nullptr});
        for (const glm::vec3& p : positions) out.add(tile.origin + glm::dvec3(p));
    };
    // Those whose hulls reach out furthest come first: they leave little for others to add.
    for (int axis = 0; axis < 3 && !extents.empty(); ++axis) {
        const auto lo = [axis](const TileSet::Extent& e) { return e.hull.lo[axis]; };
        const auto hi = [axis](const TileSet::Extent& e) { return e.hull.hi[axis]; };
        add(static_cast<std::size_t>(std::ranges::min_element(extents, {}, lo) - extents.begin()));
        add(static_cast<std::size_t>(std::ranges::max_element(extents, {}, hi) - extents.begin()));
    }
    for (std::size_t i = 0; i < tiles.size(); ++i) {
        const bool inside = glm::all(glm::greaterThanEqual(extents[i].hull.lo, out.lo)) &&
                            glm::all(glm::lessThanEqual(extents[i].hull.hi, out.hi));
        if (!inside) add(i);
    }
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

Ref<TileSet> tile_set(const Ref<TileModel>& model, const Ref<std::vector<PlacedTile>>& tiles)
{
    return tile_set(model, tiles, Lazy<Ref<Mesh>>([model, tiles] {
                        return make_ref(bent_tiles(*model->mesh, *tiles));
                    }));
}

Ref<TileSet> tile_set(const Ref<TileModel>& model, const Ref<std::vector<PlacedTile>>& tiles,
                      Lazy<Ref<Mesh>> mesh)
{
    TileSet out{model, tiles, {}, {}, std::move(mesh)};
    out.extents.resize(tiles->size());
    parallel_blocks(tiles->size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            out.extents[i] = {hull_box((*tiles)[i], model->box),
                              stretch_bound((*tiles)[i], model->box)};
    });
    out.box = box_of(*model, *tiles, out.extents);
    return make_ref(std::move(out));
}

Mesh bent_tiles(const Mesh& unit, std::span<const PlacedTile> tiles)
{
    const std::size_t count = unit.vertex_count(), copies = tiles.size();
    Mesh out = copies_of(unit, copies, false);
    tint_copies(out, tiles);
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

void tint_copies(Mesh& copies, std::span<const PlacedTile> tiles)
{
    if (std::ranges::none_of(tiles, is_tinted)) return;
    const std::size_t count = copies.vertex_count() / tiles.size();
    copies.colors.resize(copies.vertex_count(), glm::vec4(1));
    parallel_blocks(tiles.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            for (std::size_t v = i * count; is_tinted(tiles[i]) && v < (i + 1) * count; ++v) {
                glm::vec4& color = copies.colors[v];
                color = {tiles[i].tint *
                             glm::mix(glm::vec3(color), glm::vec3(1), tiles[i].tint_over),
                         color.a};
            }
    });
}

std::vector<glm::dvec3> outer_points(const TileModel& model, std::span<const PlacedTile> tiles)
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
