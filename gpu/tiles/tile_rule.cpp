// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/tiles/tile_rule.h"

#include "core/base/mistake.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

namespace trivar::gpu {
namespace {

// The greatest error of a tile of a draft by the bound of its stretch, in half pixels: that is
// about one pixel, for the bound is about twice the true stretch. Pictures that are no drafts show
// every tile as it is.
constexpr double half_pixels_off = 4;

} // namespace

TileRule rule_of(const Camera& camera, const glm::dmat4& to_world, const glm::dvec3& origin,
                 bool draft, const std::vector<TileLevel>& levels)
{
    ensure(levels.size() <= TileRule::most_levels, "a tile has too many levels");
    TileRule out;
    const glm::dmat4 to_view = glm::translate(view_matrix(camera) * to_world, origin);
    const glm::dvec2 size = glm::max(camera.size_px, glm::dvec2(1));
    // Samples are shifted inside the pixel.
    const double tall = camera.perspective ? std::tan(camera.fov_y / 2) : camera.height_world / 2;
    const double y = tall * (1 + 2 / size.y), x = tall * size.x / size.y * (1 + 2 / size.x);
    const double by_depth = camera.perspective ? 1 : 0, fixed = camera.perspective ? 0 : 1;
    const std::array<glm::dvec4, 5> sides{{{-1, 0, -x * by_depth, x * fixed},
                                           {1, 0, -x * by_depth, x * fixed},
                                           {0, -1, -y * by_depth, y * fixed},
                                           {0, 1, -y * by_depth, y * fixed},
                                           {0, 0, -by_depth, fixed}}};
    for (std::size_t i = 0; i < sides.size(); ++i) out.sides[i] = sides[i] * to_view;
    out.depth = glm::dvec4(0, 0, -1, 0) * to_view;
    const glm::dmat3 linear(to_world);
    const double scale = to_world == glm::dmat4(1) ? 1
                                                   : std::sqrt(glm::dot(linear[0], linear[0]) +
                                                               glm::dot(linear[1], linear[1]) +
                                                               glm::dot(linear[2], linear[2]));
    out.tolerance = static_cast<float>(half_pixels_off * tall / size.y / std::max(scale, 1e-300));
    out.perspective = camera.perspective;
    out.steady = draft;
    out.level_count = static_cast<int>(levels.size());
    for (int i = 0; i < out.level_count; ++i)
        out.errors[i / 4][i % 4] = static_cast<float>(levels[static_cast<std::size_t>(i)].error);
    return out;
}

TileRule with_pyramid(const TileRule& rule, glm::ivec2 size_px, const glm::dmat4& world_to_clip,
                      const glm::dmat4& to_world, const glm::dvec3& origin)
{
    TileRule out = rule;
    out.pyramid_px = size_px;
    out.to_clip = glm::translate(world_to_clip * to_world, origin);
    return out;
}

TileHull hull_of(const TileSet::Extent& extent, const glm::dvec3& origin)
{
    constexpr double more = 1.0 / (1 << 20); // some units in the last place of a float
    const glm::dvec3 lo = extent.hull.lo - origin, hi = extent.hull.hi - origin;
    const glm::dvec3 room = more * glm::max(glm::abs(lo), glm::abs(hi));
    return {lo - room, static_cast<float>(extent.stretch), hi + room};
}

} // namespace trivar::gpu
