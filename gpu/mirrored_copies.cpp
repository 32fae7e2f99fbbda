// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/mirrored_copies.h"

#include "core/base/mean_scale.h"
#include "gpu/to_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <epoxy/gl.h>
#include <vector>

namespace trivar::gpu {
namespace {

struct Row {
    std::array<glm::vec4, 3> to_scene; // rows of the matrix
    std::array<glm::vec3, 3> normal_to_scene;
    float value;
    std::uint32_t id;
};

constexpr unsigned value_location = 7;  // mesh.vert
constexpr unsigned matrix_location = 8; // place.glsl, as those that follow
constexpr unsigned normal_location = 11;
constexpr unsigned id_location = 14;
constexpr unsigned tile_location = 13; // tile.glsl

bool all_finite(const glm::dmat4& m)
{
    bool all = true;
    for (int i = 0; i < 4; ++i)
        for (int k = 0; k < 4; ++k) all = all && std::isfinite(m[i][k]);
    return all;
}

Row row_of(const Copy& copy, const ToScene& there)
{
    const glm::mat4 points = glm::transpose(there.points);
    const glm::mat3 normals = glm::transpose(there.normals);
    return {{points[0], points[1], points[2]},
            {normals[0], normals[1], normals[2]},
            copy.value,
            static_cast<std::uint32_t>(copy.id)};
}

} // namespace

void MirroredCopies::feed(const VertexArray& vertices, int first, bool shows_values) const
{
    if (patches) {
        constexpr int step = sizeof(std::uint32_t);
        const std::size_t from =
            static_cast<std::size_t>(first) + (chosen ? level * chosen->capacity : 0);
        vertices.integers(tile_location, chosen ? chosen->rows : rows, 1, step, from * step, 1);
        return;
    }
    constexpr int stride = sizeof(Row);
    const std::size_t from = static_cast<std::size_t>(first) * sizeof(Row);
    for (unsigned i = 0; i < 3; ++i) {
        vertices.attribute(matrix_location + i, rows, 4, stride, from + i * sizeof(glm::vec4), 1);
        vertices.attribute(normal_location + i, rows, 3, stride,
                           from + offsetof(Row, normal_to_scene) + i * sizeof(glm::vec3), 1);
    }
    vertices.integers(id_location, rows, 1, stride, from + offsetof(Row, id), 1);
    if (shows_values)
        vertices.attribute(value_location, rows, 1, stride, from + offsetof(Row, value), 1);
}

void MirroredCopies::draw(unsigned primitive, int index_count, int first_index, int copies,
                          std::size_t command) const
{
    const auto offset = [](std::size_t bytes) { return reinterpret_cast<const void*>(bytes); };
    if (!chosen) {
        const std::size_t from = static_cast<std::size_t>(first_index) * sizeof(std::uint32_t);
        glDrawElementsInstanced(primitive, index_count, GL_UNSIGNED_INT, offset(from), copies);
        return;
    }
    constexpr std::size_t command_bytes = 32; // tiles.comp.glsl
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, chosen->commands.name());
    glDrawElementsIndirect(primitive, GL_UNSIGNED_INT,
                           offset((first_command + command) * command_bytes));
    glBindBuffer(GL_DRAW_INDIRECT_BUFFER, 0);
}

MirroredCopies uploaded(std::span<const std::uint32_t> tiles)
{
    MirroredCopies out;
    rewrite(out, {}, tiles);
    return out;
}

void rewrite(MirroredCopies& copies, std::span<const std::uint32_t> before,
             std::span<const std::uint32_t> tiles)
{
    copies.upright = static_cast<int>(tiles.size());
    std::size_t begin = 0, end = tiles.size();
    if (const std::size_t bytes = tiles.size_bytes(); bytes > copies.rows.bytes()) {
        copies.rows.reserve(bytes + bytes / 2); // room for the next dabs of a brush
    } else {
        begin = static_cast<std::size_t>(std::ranges::mismatch(before, tiles).in2 - tiles.begin());
        while (end > begin && end <= before.size() && before[end - 1] == tiles[end - 1]) --end;
    }
    if (end > begin)
        copies.rows.write_part(begin * sizeof(std::uint32_t),
                               std::as_bytes(tiles.subspan(begin, end - begin)));
}

MirroredCopies uploaded(std::span<const Copy> copies, const CopiesAt& at)
{
    MirroredCopies out;
    out.valued = std::ranges::none_of(copies, [](const Copy& c) { return std::isnan(c.value); });
    std::vector<Row> rows, mirrored;
    rows.reserve(copies.size());
    double scales = 0;
    for (const Copy& copy : copies) {
        if (!all_finite(copy.to_instance)) continue;
        const ToScene there =
            to_scene(at.to_world * copy.to_instance, at.mesh_origin, at.scene_origin_world);
        (there.mirrors ? mirrored : rows).push_back(row_of(copy, there));
        scales += mean_scale(copy.to_instance);
    }
    out.upright = static_cast<int>(rows.size());
    out.mirrored = static_cast<int>(mirrored.size());
    rows.insert(rows.end(), mirrored.begin(), mirrored.end());
    if (!rows.empty()) out.scale = scales / static_cast<double>(rows.size());
    out.rows.write(std::as_bytes(std::span(rows)));
    return out;
}

Box transformed(const Box& box, const glm::dmat4& matrix)
{
    Box out;
    if (box.empty()) return out;
    for (const glm::dvec3& corner : box.corners())
        out.add(glm::dvec3(matrix * glm::dvec4(corner, 1)));
    return out;
}

Box transformed(const Box& box, const glm::dmat4& to_world, std::span<const Copy> copies)
{
    Box out;
    for (const Copy& copy : copies)
        if (all_finite(copy.to_instance)) out.add(transformed(box, to_world * copy.to_instance));
    return out;
}

Box bounding_box(const Mesh& mesh, const glm::dmat4& to_world, std::span<const Copy> copies)
{
    const Box own = bounding_box(mesh);
    Box out;
    for (const Copy& copy : copies) {
        if (!all_finite(copy.to_instance)) continue;
        const glm::dmat4 matrix = to_world * copy.to_instance;
        const Box around = transformed(own, matrix);
        const bool inside = glm::all(glm::greaterThanEqual(around.lo, out.lo)) &&
                            glm::all(glm::lessThanEqual(around.hi, out.hi));
        if (!inside) out.add(bounding_box(mesh, matrix));
    }
    return out;
}

} // namespace trivar::gpu
