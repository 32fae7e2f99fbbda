// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/tiles/sampled_limit.h"

#include <algorithm>
#include <cmath>

namespace trivar::testing {
namespace {

double determinant(const TilePatch& patch, const glm::dvec3& at)
{
    const TilePoint t = tile_point(patch, at);
    return glm::dot(glm::cross(t.x, t.y), t.z);
}

} // namespace

double sampled_limit(const TilePatch& patch)
{
    double least = 1e300;
    for (int i = 0; i <= 32; ++i)
        for (int j = 0; j <= 32; ++j) {
            const auto at = [&](double z) { return determinant(patch, {i / 32.0, j / 32.0, z}); };
            const double a = at(0), b = (at(1) - at(-1)) / 2, c = (at(1) + at(-1)) / 2 - a;
            if (!(a > 0)) return 0;
            const double d = b * b - 4 * a * c;
            if (d < 0) continue;
            for (const double sign : {-1.0, 1.0})
                if (const double root = 2 * a / (-b + sign * std::sqrt(d)); root > 0)
                    least = std::min(least, root);
        }
    return least;
}

TilePatch in_sides(TilePatch patch, double size)
{
    for (glm::dvec3& p : patch.p) p /= size;
    return patch;
}

} // namespace trivar::testing
