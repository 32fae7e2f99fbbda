// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/split_vertices.h"
#include "core/unwrap/unwrap.h"

namespace trivar {

Mesh with_uvs(const Mesh& mesh, std::span<const glm::vec2> uvs)
{
    Mesh out = mesh;
    out.tangents.clear();
    for (Mesh::MorphTarget& target : out.morph_targets) target.tangents.clear();
    const std::vector<glm::vec2> at_corners(uvs.begin(), uvs.end());
    std::vector<glm::vec2> set = split_vertices(out, at_corners, glm::vec2(0));
    if (out.uvs.empty()) out.uvs.emplace_back();
    out.uvs[0] = std::move(set);
    return out;
}

} // namespace trivar
