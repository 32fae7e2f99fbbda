// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/primitives.h"
#include "core/tiles/chart.h"
#include "core/tiles/on_surface.h"
#include "core/tiles/tile_motion.h"
#include "tests/tiles/bases.h"

#include <glm/gtc/constants.hpp>
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

// A conveyor round a torus: the tile after next comes to where one was, and all of them go round.
TEST(TileMotions, TilesOfALineSlideAlongItsStroke)
{
    const TileBase base = base_of(torus_mesh(1, 0.4, {96, 48}));
    const double turn = 2 * glm::pi<double>();
    TileStroke round;
    round.brush = TileBrush::line;
    round.size = 0.1;
    round.turn_variation_deg = 30;
    for (int i = 0; i <= 200; ++i) {
        const double a = turn * i / 200, r = 1.2, z = std::sqrt(0.16 - 0.04);
        const glm::dvec3 p(r * std::cos(a), r * std::sin(a), z);
        const glm::dvec3 n(0.5 * std::cos(a), 0.5 * std::sin(a), z / 0.4);
        round.samples.push_back({{p, glm::normalize(n)}, i / 200.0});
    }
    TileStroke half = round;
    half.samples.resize(101);
    const auto laid = [&](const TileStroke& stroke) { return layout_of(base, {make_ref(stroke)}); };
    const TileLayout all = laid(round), some = laid(half);
    ASSERT_EQ(all.tracks.size(), 1u);
    EXPECT_TRUE(all.tracks.front().closed);
    EXPECT_FALSE(some.tracks.front().closed);
    const auto slid_by = [&](const TileLayout& layout, double sides) {
        TileLook look;
        look.slide_along = sides;
        return slid_layout(base, layout, look);
    };
    const TileLayout two = slid_by(all, 2),
                     home = slid_by(all, all.tracks.front().lengths.back() / 0.1);
    for (std::size_t i = 0; i < all.tiles.size(); ++i) {
        const Tile &from = all.tiles[i], &to = two.tiles[i];
        const glm::dvec3 p = base.position(to.at);
        EXPECT_NEAR(glm::length(glm::dvec2(p)), 1.2, 2e-3) << "it stays on the circle";
        if (i + 2 < all.tiles.size()) {
            EXPECT_LT(glm::distance(p, base.position(all.tiles[i + 2].at)), 1e-6);
        }
        const auto own_angle = [&](const Tile& tile) {
            const glm::dvec3 q = base.position(tile.at), n = base.normal(tile.at);
            return angle_about(direction_on({-q.y, q.x, 0}, n), tile.x, n);
        };
        EXPECT_NEAR(own_angle(from), own_angle(to), 0.05);
        EXPECT_LT(glm::distance(base.position(home.tiles[i].at), base.position(from.at)), 1e-6);
    }
    int gone = 0;
    for (const Tile& tile : slid_by(some, 10).tiles) gone += !std::isfinite(tile.size);
    EXPECT_EQ(gone, 10) << "that many leave the end of a stroke that is open";
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
