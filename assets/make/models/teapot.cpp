// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/models/models.h"

#include "core/mesh/primitives.h"

#include <map>

namespace make {

// The core's primitive, turned Y up: open, as Newell drew it.
Model teapot()
{
    Model m;
    const int china = m.material("china", srgb(0xdfe4e6), .18f);
    const trivar::Mesh source = trivar::teapot_mesh(.79, 10);
    Mesh mesh;
    std::map<std::uint32_t, int> index; // of the core's points, which need not be consecutive
    for (std::uint32_t v = 0; v < source.vertex_count(); ++v) {
        if (!index.try_emplace(source.point(v), int(mesh.points.size())).second) continue;
        const vec3 p = source.positions[v];
        mesh.points.push_back({p.x, p.z, -p.y});
    }
    for (std::size_t f = 0; f < source.face_count(); ++f) {
        Face face{-1, -1, -1, -1};
        std::array<vec2, 4> uv{};
        const std::uint32_t begin = source.face_begin[f], end = source.face_begin[f + 1];
        for (std::uint32_t c = begin; c < end; ++c) {
            const std::uint32_t v = source.corners[c];
            face[c - begin] = index.at(source.point(v));
            uv[c - begin] = source.uvs[0][v];
        }
        mesh.faces.push_back(face);
        mesh.uvs.push_back(uv);
    }
    m.root().parts.push_back(mesh.mat(china));
    return m;
}

} // namespace make
