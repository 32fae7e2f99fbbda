// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/fold_limit.h"

#include "core/mesh/primitives.h"
#include "tests/tiles/bases.h"
#include "tests/tiles/sampled_limit.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using namespace testing;

TEST(FoldLimits, OfASphereAreInfiniteOutsideAndItsRadiusInside)
{
    const TileBase base = base_of(sphere_mesh(1, 192, 96));
    const BasePose pose = at_rest(base);
    std::mt19937 random(1);
    for (int k = 0; k < 20; ++k) {
        const SurfacePlace at = random_place(base, random);
        TilePatch patch =
            patch_of(base, pose, chart_of(base, {at, random_tangent(base, at, random), 0.2}, 0, 1));
        EXPECT_GT(fold_limit(patch), 100);
        for (std::size_t i = 0; i < 16; ++i) patch.n[i] = -patch.n[i]; // it looks inward
        for (std::size_t j = 0; j < 4; ++j)
            for (std::size_t i = 0; i < 2; ++i) {
                std::swap(patch.p[4 * j + i], patch.p[4 * j + 3 - i]);
                std::swap(patch.n[4 * j + i], patch.n[4 * j + 3 - i]);
            }
        EXPECT_NEAR(fold_limit(patch), 1, 0.03);
    }
}

TEST(FoldLimits, AreNeverPassedByASampleAndSeldomFarBelow)
{
    std::mt19937 random(2);
    std::normal_distribution<double> number;
    int far_below = 0, limited = 0;
    for (int k = 0; k < 2000; ++k) {
        std::array<glm::dvec3, 16> p, n;
        const double bend = 0.6 * (k % 10) / 10;
        for (std::size_t i = 0; i < 16; ++i) {
            const glm::dvec2 q{patch_nodes[i % 4] - 0.5, patch_nodes[i / 4] - 0.5};
            p[i] = {q, bend * (number(random) * q.x * q.x + number(random) * q.y * q.y) +
                           0.05 * bend * number(random)};
            n[i] = glm::normalize(glm::dvec3(bend * (number(random) * 0.1 + 2 * q.x),
                                             bend * (number(random) * 0.1 - 2 * q.y), 1));
        }
        const TilePatch patch{through_nodes(p), through_nodes(n)};
        const double limit = fold_limit(patch), sampled = sampled_limit(patch);
        if (sampled < 5) {
            ++limited;
            EXPECT_LE(limit, sampled * (1 + 1e-9));
            far_below += fold_limit(patch, 100) < 0.9 * sampled;
        }
    }
    EXPECT_GT(limited, 500);
    EXPECT_LT(far_below, limited / 50);
}

} // namespace
} // namespace trivar
