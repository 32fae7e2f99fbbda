// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/limit/facet_surface.h"
#include "core/mesh/primitives.h"
#include "core/tiles/cover_heights.h"
#include "core/tiles/fold_limit.h"
#include "tests/limit/cages.h"

#include <gmock/gmock.h>

namespace trivar::testing {
namespace {

Covering brick_cover(const ChartSurface& surface, double size)
{
    return Covering(surface, {.pattern = TilePattern::brick, .size = size}, {size, 0.6 * size});
}

CoveringPose still_pose(const Covering& covering, const ChartSurface& surface)
{
    CoveringPose pose{covering.points(surface), {}, std::vector<char>(surface.net().size(), 0)};
    pose.heights = heights_along_rows(covering, pose.points, 1);
    return pose;
}

Mesh flat_tile()
{
    return plane_mesh({1, 1}, {6, 6});
}

constexpr CoverCell tall_cell{{-0.5, -0.5, 0}, {1, 1, 0.4}, 0.25};

TEST(CoverHeights, AreTheLengthsOfCellsAlongTheirRows)
{
    const FacetSurface plane(cage_of(plane_mesh({3, 2}, {3, 2})));
    const Covering covering(plane, {.pattern = TilePattern::grid}, {0.5, 0.25});
    for (const double height : heights_along_rows(covering, covering.points(plane), 2))
        EXPECT_TRUE(height == 0 || std::abs(height - 1) < 1e-12) << height; // 0: no corner
}

TEST(CoverHeights, AreLoweredUntilNoCellFolds)
{
    for (const NamedCage& cage : all_cages()) {
        const LimitSurface surface = limit_of(cage.mesh);
        const Covering covering = brick_cover(surface, 0.2);
        CoveringPose pose = still_pose(covering, surface);
        constexpr double top = 12;
        const GuardedHeights guarded = guarded_heights(covering, pose, top);
        pose.heights = guarded.heights;
        for (std::uint32_t c = 0; c < covering.cell_count(); ++c) {
            if (guarded.folded[c]) continue;
            for (const std::uint32_t node : covering.corners(c))
                EXPECT_LT(top * pose.heights[node], fold_limit(upright_patch(covering, c, pose)))
                    << cage.name;
        }
        const GuardedHeights flat = guarded_heights(covering, pose, 0);
        EXPECT_EQ(flat.heights, pose.heights);
    }
}

// The patches that carry a tile alone give what its cells do, where they say that they do.
TEST(PatchedTiles, AreAsFarFromTheirTilesAsTheySay)
{
    for (const NamedCage& cage : all_cages()) {
        const LimitSurface surface = limit_of(cage.mesh);
        const Covering covering = brick_cover(surface, 0.2);
        const CoveringPose pose = still_pose(covering, surface);
        std::size_t near = 0;
        for (std::uint32_t k = 0; k < covering.tiles().size(); k += 5) {
            const PatchedTile patched = patched_tile(tall_cell, covering, pose, k);
            const Mesh bent =
                covered_tiles(flat_tile(), glm::dmat4(1), tall_cell, covering, pose, {{k}});
            const Mesh unit = transformed(flat_tile(), to_unit_cell(tall_cell));
            const double length = glm::distance(tile_point(patched.tile.patch, {0, 0.5, 0}).p,
                                                tile_point(patched.tile.patch, {1, 0.5, 0}).p);
            double most = 0;
            for (std::size_t v = 0; v < unit.vertex_count(); ++v) {
                const glm::dvec3 at(unit.positions[v]);
                const glm::dvec3 p =
                    tile_point(patched.tile.patch, {at.x, at.y, at.z + patched.tile.base}).p;
                most = std::max(most, glm::distance(p, glm::dvec3(bent.positions[v])));
            }
            EXPECT_LT(most, (3 * patched.off + 1e-5) * length) << cage.name;
            near += patched.off < 2e-4;
            const bool spans = covering.tiles()[k].extent == Covering::Extent::spanning;
            EXPECT_EQ(patched.cells.size(), spans ? 2u : 1u);
        }
        EXPECT_GT(near, 0u) << cage.name;
    }
}

TEST(FoldLimits, TakeASideThatIsASinglePoint)
{
    // Triangles of a cone: each is a patch with a pole.
    const FacetSurface cone(cage_of(sphere_mesh(1, 8, 4)));
    const Covering covering(cone, {.pattern = TilePattern::grid}, {1, 1});
    const CoveringPose pose = still_pose(covering, cone);
    for (std::uint32_t c = 0; c < covering.cell_count(); ++c)
        EXPECT_GT(fold_limit(upright_patch(covering, c, pose)), 0.5);
    EXPECT_EQ(fold_limit(TilePatch{}), 0); // all of it
}

} // namespace
} // namespace trivar::testing
