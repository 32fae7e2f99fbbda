// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/mesh_copies.h"

#include <algorithm>

namespace trivar {
namespace {

template <class T>
std::vector<T> behind_one_another(const std::vector<T>& values, std::size_t times)
{
    std::vector<T> out;
    out.reserve(values.size() * times);
    for (std::size_t i = 0; i < times; ++i) out.insert(out.end(), values.begin(), values.end());
    return out;
}

std::vector<std::uint32_t> counted_on(const std::vector<std::uint32_t>& values, std::size_t times,
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

Mesh copies_of(const Mesh& mesh, std::size_t copies, bool mirrored)
{
    const std::size_t count = mesh.vertex_count();
    Mesh out;
    out.positions.resize(count * copies);
    if (!mesh.normals.empty()) out.normals.resize(count * copies);
    if (!mesh.tangents.empty()) out.tangents.resize(count * copies);
    out.colors = behind_one_another(mesh.colors, copies);
    for (const auto& set : mesh.uvs) out.uvs.push_back(behind_one_another(set, copies));
    out.points = counted_on(mesh.points, copies, point_count(mesh));
    out.corners = counted_on(mesh.corners, copies, count);
    const std::vector<std::uint32_t> ends(mesh.face_begin.begin() + 1, mesh.face_begin.end());
    for (const std::uint32_t end : counted_on(ends, copies, mesh.corners.size()))
        out.face_begin.push_back(end);
    if (mirrored)
        for (std::size_t f = 0; f + 1 < out.face_begin.size(); ++f)
            std::reverse(out.corners.begin() + out.face_begin[f],
                         out.corners.begin() + out.face_begin[f + 1]);
    out.face_material = behind_one_another(mesh.face_material, copies);
    out.face_group = behind_one_another(mesh.face_group, copies);
    out.group_names = mesh.group_names;
    return out;
}

} // namespace trivar
