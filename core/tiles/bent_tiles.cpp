// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/bent_tiles.h"

#include "core/base/parallel.h"

#include <algorithm>

namespace trivar {
namespace {

glm::vec3 unit_or_up(const glm::dvec3& n)
{
    const double length = glm::length(n);
    return length > 0 ? glm::vec3(n / length) : glm::vec3(0, 0, 1);
}

// Repeats the values, one copy after another.
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

} // namespace

Ref<Mesh> bent_tiles(const Mesh& mesh, const glm::dmat4& to_model, const TileCell& cell,
                     std::span<const PlacedTile> tiles)
{
    const std::size_t count = mesh.vertex_count(), copies = tiles.size();
    const bool mirrored = glm::determinant(glm::dmat3(to_model)) < 0;
    Mesh out;
    out.positions.resize(count * copies);
    if (!mesh.normals.empty()) out.normals.resize(count * copies);
    if (!mesh.tangents.empty()) out.tangents.resize(count * copies);
    out.colors = repeated(mesh.colors, copies);
    for (const auto& set : mesh.uvs) out.uvs.push_back(repeated(set, copies));
    out.points = shifted(mesh.points, copies, point_count(mesh));
    out.corners = shifted(mesh.corners, copies, count);
    const std::vector<std::uint32_t> ends(mesh.face_begin.begin() + 1, mesh.face_begin.end());
    for (const std::uint32_t end : shifted(ends, copies, mesh.corners.size()))
        out.face_begin.push_back(end);
    if (mirrored)
        for (std::size_t f = 0; f + 1 < out.face_begin.size(); ++f)
            std::reverse(out.corners.begin() + out.face_begin[f],
                         out.corners.begin() + out.face_begin[f + 1]);
    out.face_material = repeated(mesh.face_material, copies);
    out.face_group = repeated(mesh.face_group, copies);
    out.group_names = mesh.group_names;

    // In the space of the tile x and y fill the unit square, and z is in lengths of a side.
    std::vector<glm::dvec3> at(count), normals(mesh.normals.size()), tangents(mesh.tangents.size());
    const glm::dmat3 linear(to_model), cofactor = glm::transpose(glm::inverse(linear));
    for (std::size_t v = 0; v < count; ++v) {
        const glm::dvec3 p = glm::dvec3(to_model * glm::dvec4(mesh.positions[v], 1));
        at[v] = (p - cell.middle_of_floor) / cell.side + glm::dvec3(0.5, 0.5, 0);
        if (!normals.empty()) normals[v] = cofactor * glm::dvec3(mesh.normals[v]);
        if (!tangents.empty()) tangents[v] = linear * glm::dvec3(mesh.tangents[v]);
    }
    parallel_blocks(copies, 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            for (std::size_t v = 0; v < count; ++v) {
                const PlacedTile& tile = tiles[k];
                const TilePoint t =
                    tile_point(tile.patch, {at[v].x, at[v].y, tile.height * at[v].z + tile.base});
                const std::size_t to = k * count + v;
                out.positions[to] = glm::vec3(t.p);
                const glm::dvec3 z = tile.height * t.z;
                if (!normals.empty()) {
                    const glm::dvec3& n = normals[v];
                    out.normals[to] =
                        unit_or_up(n.x * glm::cross(t.y, z) + n.y * glm::cross(z, t.x) +
                                   n.z * glm::cross(t.x, t.y));
                }
                if (!tangents.empty()) {
                    const glm::dvec3& a = tangents[v];
                    out.tangents[to] = glm::vec4(unit_or_up(a.x * t.x + a.y * t.y + a.z * z),
                                                 mesh.tangents[v].w * (mirrored ? -1.0f : 1.0f));
                }
            }
    });
    return make_ref(std::move(out));
}

} // namespace trivar
