// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/tiles/tile_view.h"

#include <algorithm>
#include <cmath>

namespace trivar::gpu {
namespace {

// The least of a linear function over a box.
double least(const glm::dvec4& plane, const Box& box, double sign)
{
    const glm::dvec3 n = sign * glm::dvec3(plane);
    const glm::dvec3 middle = box.center(), half = box.hi - middle;
    return glm::dot(n, middle) + sign * plane.w - glm::dot(glm::abs(n), half);
}

} // namespace

TileView::TileView(const Camera& camera, const glm::dmat4& to_world, bool steady)
    : perspective_(camera.perspective),
      steady_(steady)
{
    const glm::dmat4 to_view = view_matrix(camera) * to_world;
    const glm::dvec2 size = glm::max(camera.size_px, glm::dvec2(1));
    // Samples are shifted inside the pixel.
    const double tall = perspective_ ? std::tan(camera.fov_y / 2) : camera.height_world / 2;
    const double y = tall * (1 + 2 / size.y), x = tall * size.x / size.y * (1 + 2 / size.x);
    const double by_depth = perspective_ ? 1 : 0, fixed = perspective_ ? 0 : 1;
    const std::array<glm::dvec4, 5> sides{{{-1, 0, -x * by_depth, x * fixed},
                                           {1, 0, -x * by_depth, x * fixed},
                                           {0, -1, -y * by_depth, y * fixed},
                                           {0, 1, -y * by_depth, y * fixed},
                                           {0, 0, -by_depth, fixed}}};
    for (std::size_t i = 0; i < sides.size(); ++i) planes_[i] = sides[i] * to_view;
    depth_ = glm::dvec4(0, 0, -1, 0) * to_view;
    const glm::dmat3 linear(to_world);
    const double scale = to_world == glm::dmat4(1) ? 1
                                                   : std::sqrt(glm::dot(linear[0], linear[0]) +
                                                               glm::dot(linear[1], linear[1]) +
                                                               glm::dot(linear[2], linear[2]));
    pixel_ = tall / size.y / std::max(scale, 1e-300);
}

bool TileView::sees(const Box& box) const
{
    return std::ranges::none_of(
        planes_, [&](const glm::dvec4& plane) { return -least(plane, box, -1) < 0; });
}

double TileView::tolerance(const Box& box) const
{
    return perspective_ ? pixel_ * std::max(least(depth_, box, 1), 0.0) : pixel_;
}

std::size_t level_for(const std::vector<TileLevel>& levels, double stretch, double tolerance,
                      std::optional<std::size_t> last)
{
    const auto coarsest = [&](double within) {
        std::size_t out = 0;
        while (out + 1 < levels.size() && levels[out + 1].error * stretch <= within) ++out;
        return out;
    };
    const std::size_t best = coarsest(tolerance);
    if (!last || best == *last) return best;
    return best > *last ? std::max(coarsest(tolerance / 1.33), *last)
                        : std::min(coarsest(tolerance * 1.33), *last);
}

} // namespace trivar::gpu
