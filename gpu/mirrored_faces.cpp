// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/mirrored_faces.h"

#include "core/base/digest.h"
#include "core/base/mistake.h"
#include "core/mesh/closed_body.h"

#include <algorithm>
#include <numeric>

namespace trivar::gpu {
namespace {

// The triangles' corners, those of one material together.
std::vector<std::uint32_t> sorted_corners(const Mesh& mesh, std::vector<MirroredFaces::Part>& parts)
{
    const std::vector<glm::uvec3> all = triangles(mesh);
    std::vector<std::uint32_t> material(all.size(), 0);
    if (!mesh.face_material.empty()) {
        std::size_t next = 0;
        for (std::size_t f = 0; f < mesh.face_count(); ++f) {
            const std::size_t count = mesh.face_begin[f + 1] - mesh.face_begin[f] - 2;
            for (std::size_t i = 0; i < count && next < all.size(); ++i)
                material[next++] = mesh.face_material[f];
        }
        ensure(next == all.size(), "a triangle is of no face");
    }
    std::vector<std::uint32_t> order(all.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](auto a, auto b) { return material[a] < material[b]; });
    std::vector<std::uint32_t> corners;
    corners.reserve(3 * all.size());
    for (const std::uint32_t t : order) {
        if (parts.empty() || parts.back().material != material[t])
            parts.push_back({material[t], static_cast<int>(corners.size()), 0});
        for (int k = 0; k < 3; ++k) corners.push_back(all[t][k]);
        parts.back().count += 3;
    }
    return corners;
}

std::shared_ptr<MirroredFaces> uploaded(const Mesh& mesh)
{
    auto out = std::make_shared<MirroredFaces>();
    const std::vector<std::uint32_t> corners = sorted_corners(mesh, out->parts);
    out->indices.write(std::as_bytes(std::span(corners)));
    return out;
}

std::string digest_of_faces(const Mesh& mesh)
{
    Digest digest;
    for (const auto* each : {&mesh.corners, &mesh.face_material, &mesh.points}) {
        digest.add(each->size());
        digest.add(std::span<const std::uint32_t>(*each));
    }
    return digest.hex();
}

} // namespace

std::shared_ptr<const MirroredFaces> FacesMirror::operator()(const Mesh& mesh)
{
    if (mesh.corners.size() != 3 * mesh.face_count()) return uploaded(mesh);
    std::shared_ptr<const MirroredFaces>& found = shared_[digest_of_faces(mesh)];
    if (!found) {
        const auto fresh = uploaded(mesh);
        fresh->closed = is_closed_body(mesh);
        found = fresh;
    }
    return found;
}

void FacesMirror::drop_dead()
{
    std::erase_if(shared_, [](const auto& item) { return item.second.use_count() <= 1; });
}

} // namespace trivar::gpu
