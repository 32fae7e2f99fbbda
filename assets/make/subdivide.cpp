// SPDX-License-Identifier: GPL-3.0-or-later
#include "assets/make/subdivide.h"

#include "core/mesh/subdivide.h"

namespace make {

Mesh catmull_clark(const Mesh& cage, const Sharpness& creases, int levels)
{
    trivar::Mesh in;
    in.positions = cage.points;
    for (const Face& face : cage.faces) {
        const std::vector<std::uint32_t> corners(face.begin(), face.begin() + corner_count(face));
        add_face(in, corners);
    }
    for (const auto& [edge, sharpness] : creases)
        in.creases.push_back({static_cast<std::uint32_t>(edge.first),
                              static_cast<std::uint32_t>(edge.second), sharpness});
    const trivar::Mesh fine = trivar::subdivide(in, levels);

    Mesh out;
    out.material = cage.material;
    out.points = fine.positions;
    for (std::size_t c = 0; c < fine.corners.size(); c += 4) {
        Face& face = out.faces.emplace_back();
        for (std::size_t k = 0; k < 4; ++k) face[k] = static_cast<int>(fine.corners[c + k]);
    }
    return out;
}

} // namespace make
