// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/patches/tile_set.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <set>
#include <utility>

namespace trivar {
namespace {

// The values of each copy behind one another.
template <class T> std::vector<T> repeated(const std::vector<T>& values, std::size_t times)
{
    std::vector<T> out;
    out.reserve(values.size() * times);
    for (std::size_t i = 0; i < times; ++i) out.insert(out.end(), values.begin(), values.end());
    return out;
}

std::vector<std::uint32_t> shifted(const std::vector<std::uint32_t>& values, std::size_t times,
                                   std::size_t step)
{
    std::vector<std::uint32_t> out;
    out.reserve(values.size() * times);
    for (std::size_t i = 0; i < times; ++i)
        for (const std::uint32_t v : values)
            out.push_back(static_cast<std::uint32_t>(v + i * step));
    return out;
}

// Where a direction ends in space: unit, or up where there is none.
glm::vec3 unit_in_cell(const glm::dvec3& direction)
{
    const double length = glm::length(direction);
    return length > 0 ? glm::vec3(direction / length) : glm::vec3(0, 0, 1);
}

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
    Mesh out = mesh;
    out.influences.clear();
    out.morph_targets.clear();
    out.creases.clear();
    const glm::dmat3 linear(to_model);
    const bool mirrors = glm::determinant(linear) < 0;
    // The cofactors, with the sign of the determinant, so that normals look outwards.
    const glm::dmat3 cofactors =
        (mirrors ? -1.0 : 1.0) * glm::dmat3(glm::cross(linear[1], linear[2]),
                                            glm::cross(linear[2], linear[0]),
                                            glm::cross(linear[0], linear[1]));
    for (glm::vec3& p : out.positions) {
        const glm::dvec3 there(to_model * glm::dvec4(p, 1));
        p = (there - cell.middle_of_floor) / cell.side + glm::dvec3(0.5, 0.5, 0);
    }
    for (glm::vec3& n : out.normals) n = unit_in_cell(cofactors * glm::dvec3(n));
    for (glm::vec4& t : out.tangents)
        t = glm::vec4(unit_in_cell(linear * glm::dvec3(t)), mirrors ? -t.w : t.w);
    for (std::size_t f = 0; mirrors && f < out.face_count(); ++f)
        std::reverse(out.corners.begin() + out.face_begin[f],
                     out.corners.begin() + out.face_begin[f + 1]);
    return out;
}

Ref<TileModel> tile_model(Mesh in_unit_cell)
{
    const Box box = bounding_box(in_unit_cell);
    const Ref<Mesh> mesh = make_ref(std::move(in_unit_cell));
    return make_ref(
        TileModel{mesh, box, Lazy<std::vector<TileLevel>>([mesh] { return levels_of(mesh); })});
}

Ref<TileSet> tile_set(const Ref<TileModel>& model, const Ref<std::vector<PlacedTile>>& tiles)
{
    TileSet out{model, tiles, {}, {}, Lazy<Ref<Mesh>>([model, tiles] {
                    return make_ref(bent_tiles(*model->mesh, *tiles));
                })};
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
    Mesh out;
    out.positions.resize(count * copies);
    out.normals.resize(unit.normals.size() * copies);
    out.tangents.resize(unit.tangents.size() * copies);
    out.colors = repeated(unit.colors, copies);
    for (const auto& set : unit.uvs) out.uvs.push_back(repeated(set, copies));
    out.points = shifted(unit.points, copies, point_count(unit));
    out.corners = shifted(unit.corners, copies, count);
    const std::vector<std::uint32_t> ends(unit.face_begin.begin() + 1, unit.face_begin.end());
    for (const std::uint32_t end : shifted(ends, copies, unit.corners.size()))
        out.face_begin.push_back(end);
    out.face_material = repeated(unit.face_material, copies);
    out.face_group = repeated(unit.face_group, copies);
    out.group_names = unit.group_names;
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
