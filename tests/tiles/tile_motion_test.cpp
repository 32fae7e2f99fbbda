// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/primitives.h"
#include "core/tiles/chart.h"
#include "core/tiles/tile_motion.h"
#include "tests/tiles/bases.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using namespace testing;

TileLayout painted_in_two_seconds()
{
    TileLayout layout;
    for (int i = 0; i <= 8; ++i) {
        Tile tile;
        tile.seed = static_cast<std::uint32_t>(i);
        tile.time_s = i / 4.0;
        layout.tiles.push_back(tile);
    }
    layout.duration_s = 2;
    return layout;
}

TEST(TileMotions, TilesGrowInTheOrderInWhichTheyWerePainted)
{
    const TileLayout layout = painted_in_two_seconds();
    TileLook look;
    for (double growth = 0; growth <= 1.0001; growth += 0.05) {
        look.growth = growth;
        double before = 1;
        for (const Tile& tile : layout.tiles) {
            const double size = motion_of(look, layout, tile, {}).size;
            EXPECT_LE(size, before);
            EXPECT_GE(size, 0);
            before = size;
        }
    }
    look.growth = 0;
    for (const Tile& tile : layout.tiles) EXPECT_EQ(motion_of(look, layout, tile, {}).size, 0);
    look.growth = 1;
    for (const Tile& tile : layout.tiles) EXPECT_EQ(motion_of(look, layout, tile, {}).size, 1);
    look.growth = 0.5; // in the middle of the time, and with a short way from none to all
    look.growth_softness = 0.01;
    EXPECT_EQ(motion_of(look, layout, layout.tiles[3], {}).size, 1);
    EXPECT_EQ(motion_of(look, layout, layout.tiles[5], {}).size, 0);
}

TEST(TileMotions, AWaveGoesAlongItsDirectionAndComesBackAfterOneLength)
{
    const TileLayout layout = painted_in_two_seconds();
    TileLook look;
    look.wave = 0.5;
    look.wave_length = 0.8;
    look.wave_direction = {0, 3, 0};
    const auto height = [&](const glm::dvec3& p) {
        return motion_of(look, layout, layout.tiles[0], p).height;
    };
    EXPECT_NEAR(height({0, 0, 0}), 1, 1e-12);
    EXPECT_NEAR(height({0, -0.2, 0}), 1.5, 1e-12);
    EXPECT_NEAR(height({0, 0.2, 0}), 0.5, 1e-12);
    EXPECT_NEAR(height({7, 0.13, -2}), height({0, 0.93, 0}), 1e-12);
    const double there = height({0, 0.13, 0});
    look.wave_phase = 0.25; // a quarter of a turn later it has gone a quarter of a length
    EXPECT_NEAR(height({0, 0.13 + 0.2, 0}), there, 1e-12);
    look.wave = 3;
    EXPECT_GE(height({0, 0.2, 0}), 0);
}

TEST(TileMotions, TheMiddleOfAPatchIsAPieceOfIt)
{
    const TileBase base = base_of(torus_mesh(1, 0.4, {96, 48}));
    Tile tile;
    tile.at = {37, {0.2, 0.3, 0.5}};
    tile.x = {0, 0, 1};
    tile.size = 0.3;
    BasePose pose{base.points(), {}};
    std::vector<glm::uvec3> triangles;
    for (std::uint32_t t = 0; t < base.triangle_count(); ++t) triangles.push_back(base.triangle(t));
    pose.normals = angle_normals(pose.points, triangles);
    const TilePatch patch = patch_of(base, pose, chart_of(base, tile, 0, 1));
    for (const double share : {1.0, 0.7, 0.01}) {
        const TilePatch part = middle_of(patch, share);
        for (double y = 0; y <= 1; y += 0.25)
            for (double x = 0; x <= 1; x += 0.25) {
                const glm::dvec3 z(0, 0, 0.02);
                const TilePoint whole = tile_point(
                    patch, glm::dvec3(0.5 + share * (x - 0.5), 0.5 + share * (y - 0.5), 0) + z);
                const TilePoint piece = tile_point(part, glm::dvec3(x, y, 0) + z);
                EXPECT_LT(glm::distance(whole.p, piece.p), 1e-12);
                EXPECT_LT(glm::distance(share * whole.x, piece.x), 1e-12);
            }
    }
}

} // namespace
} // namespace trivar
