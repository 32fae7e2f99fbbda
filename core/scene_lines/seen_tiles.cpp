// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/scene_lines/seen_tiles.h"

#include "core/base/mean_scale.h"

#include <algorithm>

namespace trivar {
namespace {

constexpr double least_px = 8; // of a tile in the picture: the lines of a smaller one are dropped

// How large a box is in a picture, pixels; 0 where it is beside it, 1e300 around the eye.
double size_in_picture(const Box& box, const glm::dmat4& to_world, const Camera& camera)
{
    glm::dvec2 lo(1e300), hi(-1e300);
    std::size_t behind = 0;
    for (const glm::dvec3& corner : box.corners()) {
        const PicturePoint seen = project(camera, glm::dvec3(to_world * glm::dvec4(corner, 1)));
        if (camera.perspective && !(seen.depth_world > 0)) {
            ++behind;
            continue;
        }
        lo = glm::min(lo, seen.p_px);
        hi = glm::max(hi, seen.p_px);
    }
    if (behind == 8) return 0;
    if (behind > 0) return 1e300;
    if (hi.x < 0 || hi.y < 0 || lo.x > camera.size_px.x || lo.y > camera.size_px.y) return 0;
    return glm::distance(lo, hi);
}

std::size_t triangles_of(const Mesh& mesh)
{
    return mesh.corners.size() - 2 * mesh.face_count();
}

} // namespace

SeenTiles seen_tiles(const TileSet& set, const glm::dmat4& to_world, const Camera& camera,
                     std::size_t most_triangles)
{
    SeenTiles out{nullptr, 0, 0, set.tiles->size()};
    const double scale = mean_scale(to_world);
    for (const auto& run : set.extents.runs())
        for (const TileSet::Extent& extent : *run) out.tile_size += glm::length(extent.hull.size());
    out.tile_size *= scale / static_cast<double>(std::max<std::size_t>(1, out.all));
    const std::size_t each = std::max<std::size_t>(1, triangles_of(*set.model->mesh));
    if (out.all * each <= most_triangles) {
        out.mesh = *set.mesh;
        out.drawn = out.all;
        return out;
    }
    std::vector<PlacedTile> seen;
    for (std::size_t r = 0; r < set.hulls.size(); ++r) {
        if (size_in_picture(set.hulls[r], to_world, camera) == 0) continue;
        const std::vector<TileSet::Extent>& extents = *set.extents.runs()[r];
        for (std::size_t i = 0; i < extents.size(); ++i)
            if (size_in_picture(extents[i].hull, to_world, camera) >= least_px)
                seen.push_back((*set.tiles->runs()[r])[i]);
    }
    Ref<Mesh> unit = set.model->mesh;
    for (const TileLevel& level : *set.model->levels)
        if (seen.size() * triangles_of(*unit) > most_triangles) unit = level.mesh;
    const std::size_t fits = most_triangles / std::max<std::size_t>(1, triangles_of(*unit));
    const std::size_t step = seen.size() / std::max<std::size_t>(1, fits) + 1;
    std::vector<PlacedTile> drawn;
    for (std::size_t i = 0; i < seen.size(); i += step) drawn.push_back(seen[i]);
    out.drawn = drawn.size();
    out.mesh = make_ref(bent_tiles(*unit, drawn));
    return out;
}

} // namespace trivar
