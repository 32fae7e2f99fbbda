// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/patches/tile_fit.h"

#include "core/mesh/primitives.h"
#include "core/patches/tile_set.h"
#include "tests/patches/patches.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;

// A ball on the floor of the unit cell.
Mesh ball_on_the_floor()
{
    return transformed(sphere_mesh(0.5, 20, 10), glm::translate(glm::dmat4(1), {0.5, 0.5, 0.5}));
}

// The patch that takes the unit square to a parallelogram, with the same normal everywhere.
PlacedTile flat_tile(const glm::dvec3& at, const glm::dvec3& x, const glm::dvec3& y,
                     const glm::dvec3& n, double height)
{
    PlacedTile out;
    for (std::size_t k = 0; k < 16; ++k) {
        out.patch.p[k] =
            at + static_cast<double>(k % 4) / 3 * x + static_cast<double>(k / 4) / 3 * y;
        out.patch.n[k] = n;
    }
    out.height = height;
    out.base = 0.01;
    return out;
}

// A turn that is no symmetry of anything.
glm::dmat3 some_turn()
{
    return glm::dmat3(glm::rotate(glm::dmat4(1), 2.1, glm::dvec3(1, -2, 0.5)));
}

TEST(TileFits, OfATileThatIsNotBentAreExact)
{
    const glm::dmat3 turn = some_turn();
    const Mesh unit = ball_on_the_floor();
    const BentPlaces places =
        bent_places(unit, flat_tile({40, -3, 2}, 0.2 * turn[0], 0.5 * turn[1], turn[2], 0.3));
    const auto parts = fitted_parts(unit, places);
    ASSERT_TRUE(parts);
    EXPECT_LT(glm::distance(parts->scale, glm::dvec3(0.2, 0.5, 0.3)), 1e-9);
    EXPECT_LT(furthest(unit, places, parts->matrix()), 1e-9);
    EXPECT_LT(furthest(unit, places, fitted_matrix(unit, places)), 1e-9);
}

TEST(TileFits, OfAShearedTileNeedAMatrix)
{
    const Mesh unit = ball_on_the_floor();
    const BentPlaces places =
        bent_places(unit, flat_tile({0, 0, 0}, {0.2, 0, 0}, {0.1, 0.2, 0}, {0, 0, 1}, 0.2));
    const auto parts = fitted_parts(unit, places);
    ASSERT_TRUE(parts);
    EXPECT_GT(furthest(unit, places, parts->matrix()), 0.01);
    EXPECT_LT(furthest(unit, places, fitted_matrix(unit, places)), 1e-9);
}

TEST(TileFits, OfAMirroredTileAreNoParts)
{
    const Mesh unit = ball_on_the_floor();
    const BentPlaces places =
        bent_places(unit, flat_tile({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, 1));
    EXPECT_FALSE(fitted_parts(unit, places));
    EXPECT_LT(glm::determinant(glm::dmat3(fitted_matrix(unit, places))), 0);
}

TEST(TileFits, FollowThePatchWhereAMeshHasNoThickness)
{
    const glm::dmat3 turn = some_turn();
    const Mesh unit =
        transformed(plane_mesh({1, 1}, {4, 4}), glm::translate(glm::dmat4(1), {0.5, 0.5, 0}));
    const BentPlaces places =
        bent_places(unit, flat_tile({1, 2, 3}, turn[0], 2.0 * turn[1], turn[2], 0.25));
    const auto parts = fitted_parts(unit, places);
    ASSERT_TRUE(parts);
    EXPECT_LT(furthest(unit, places, parts->matrix()), 1e-9);
    EXPECT_NEAR(parts->scale.z, 0.25, 1e-6);
}

TEST(TileFits, AreNearerThanTheFrameInTheMiddleAndMeasureEveryVertex)
{
    const Mesh unit = ball_on_the_floor();
    for (const PlacedTile& tile : random_tiles(50)) {
        const BentPlaces places = bent_places(unit, tile);
        const auto parts = fitted_parts(unit, places);
        ASSERT_TRUE(parts);
        const TilePoint frame = tile_point(tile.patch, {0.5, 0.5, 0.5 * tile.height + tile.base});
        glm::dmat4 by_frame(glm::dmat3(frame.x, frame.y, tile.height * frame.z));
        by_frame[3] = glm::dvec4(frame.p - glm::dmat3(by_frame) * glm::dvec3(0.5), 1);
        const double off = furthest(unit, places, parts->matrix()),
                     off_matrix = furthest(unit, places, fitted_matrix(unit, places));
        EXPECT_LT(off_matrix, furthest(unit, places, by_frame));
        EXPECT_LT(off, 0.1);
        const Mesh bent = bent_tiles(unit, {&tile, 1});
        double most = 0;
        for (std::size_t v = 0; v < unit.vertex_count(); ++v)
            most = std::max(
                most, glm::distance(glm::dvec3(bent.positions[v]),
                                    glm::dvec3(parts->matrix() *
                                               glm::dvec4(glm::dvec3(unit.positions[v]), 1))));
        EXPECT_NEAR(most, off, 1e-6);
    }
}

} // namespace
} // namespace trivar
