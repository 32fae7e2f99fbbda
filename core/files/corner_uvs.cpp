// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/corner_uvs.h"

#include <algorithm>
#include <tuple>

namespace trivar {
namespace {

// Copies the values of the old vertices to the new ones.
template <class T> void spread(std::vector<T>& values, const std::vector<std::uint32_t>& old_of)
{
    if (values.empty()) return;
    std::vector<T> spread;
    spread.reserve(old_of.size());
    for (const std::uint32_t v : old_of) spread.push_back(values[v]);
    values = std::move(spread);
}

} // namespace

Mesh with_corner_uvs(const Mesh& mesh, const std::vector<glm::vec2>& uvs)
{
    std::vector<std::uint32_t> order(mesh.corners.size());
    for (std::uint32_t c = 0; c < order.size(); ++c) order[c] = c;
    const auto key = [&](std::uint32_t c) {
        return std::tuple(mesh.corners[c], uvs[c].x, uvs[c].y);
    };
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });

    Mesh result = mesh;
    std::vector<std::uint32_t> old_of;
    std::vector<glm::vec2> set;
    std::size_t i = 0;
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        const std::size_t first = i;
        for (; i < order.size() && mesh.corners[order[i]] == v; ++i) {
            if (i == first || key(order[i]) != key(order[i - 1])) {
                old_of.push_back(v);
                set.push_back(uvs[order[i]]);
            }
            result.corners[order[i]] = static_cast<std::uint32_t>(old_of.size() - 1);
        }
        if (i > first) continue;
        old_of.push_back(v); // a vertex of no face
        set.emplace_back(0);
    }
    spread(result.positions, old_of);
    spread(result.normals, old_of);
    spread(result.colors, old_of);
    result.uvs = {std::move(set)};
    result.points.clear();
    return result;
}

} // namespace trivar
