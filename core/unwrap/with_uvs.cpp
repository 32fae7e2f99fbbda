// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/unwrap/unwrap.h"

#include <numeric>

namespace trivar {
namespace {

// The values of the old vertices at the new ones.
template <class T> void take_from(std::vector<T>& values, const std::vector<std::uint32_t>& old_of)
{
    if (values.empty()) return;
    std::vector<T> taken;
    taken.reserve(old_of.size());
    for (const std::uint32_t v : old_of) taken.push_back(values[v]);
    values = std::move(taken);
}

} // namespace

Mesh with_uvs(const Mesh& mesh, std::span<const glm::vec2> uvs)
{
    // The corners of each vertex in their order
    std::vector<std::uint32_t> begin(mesh.vertex_count() + 1, 0), corners(mesh.corners.size());
    for (const std::uint32_t v : mesh.corners) ++begin[v + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
    for (std::uint32_t c = 0; c < corners.size(); ++c) corners[next[mesh.corners[c]]++] = c;

    Mesh out = mesh;
    std::vector<std::uint32_t> old_of, first_of(mesh.vertex_count());
    std::vector<glm::vec2> set;
    for (std::uint32_t v = 0; v < mesh.vertex_count(); ++v) {
        const std::size_t first = set.size();
        first_of[v] = static_cast<std::uint32_t>(first);
        for (std::uint32_t i = begin[v]; i < begin[v + 1]; ++i) {
            const glm::vec2& uv = uvs[corners[i]];
            std::size_t k = first;
            while (k < set.size() && set[k] != uv) ++k;
            if (k == set.size()) {
                set.push_back(uv);
                old_of.push_back(v);
            }
            out.corners[corners[i]] = static_cast<std::uint32_t>(k);
        }
        if (set.size() > first) continue;
        set.emplace_back(0); // a vertex of no face
        old_of.push_back(v);
    }
    if (out.points.empty()) { // each vertex was its own point
        out.points.resize(mesh.vertex_count());
        std::iota(out.points.begin(), out.points.end(), 0u);
    }
    take_from(out.points, old_of);
    take_from(out.positions, old_of);
    take_from(out.normals, old_of);
    take_from(out.colors, old_of);
    take_from(out.influences, old_of);
    for (Mesh::MorphTarget& target : out.morph_targets) {
        take_from(target.positions, old_of);
        take_from(target.normals, old_of);
        take_from(target.tangents, old_of);
    }
    for (std::vector<glm::vec2>& other : out.uvs) take_from(other, old_of);
    if (out.uvs.empty()) out.uvs.emplace_back();
    out.uvs[0] = std::move(set);
    out.tangents.clear();
    for (Mesh::MorphTarget& target : out.morph_targets) target.tangents.clear();
    for (Mesh::Crease& crease : out.creases) {
        crease.a = first_of[crease.a];
        crease.b = first_of[crease.b];
    }
    return out;
}

} // namespace trivar
