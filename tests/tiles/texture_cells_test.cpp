// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/texture_cells.h"

#include "core/mesh/primitives.h"

#include <gtest/gtest.h>
#include <map>

namespace trivar::testing {
namespace {

TextureSpots spots_of(const Mesh& mesh, int columns, int rows)
{
    return *texture_spots(mesh, glm::dmat4(1), columns, rows, 1'000'000);
}

TEST(TextureCells, HaveOneSpotEachWhereTheTextureIsUsedOnce)
{
    // Edges of this mesh run through the centres of cells, in all directions.
    const Mesh mesh = plane_mesh({3, 2}, {7, 5});
    for (const int columns : {1, 2, 7, 14, 33})
        for (const int rows : {1, 5, 10, 32}) {
            const TextureSpots out = spots_of(mesh, columns, rows);
            EXPECT_EQ(out.spots.size(), static_cast<std::size_t>(columns * rows));
            EXPECT_EQ(out.repeated, 0u);
        }
}

TEST(TextureCells, LieWhereTheirCentreIs)
{
    const TextureSpots out = spots_of(plane_mesh({3, 2}, {7, 5}), 6, 4);
    for (const TextureSpot& each : out.spots) {
        const glm::dvec2 uv = (glm::dvec2(each.cell) + 0.5) / glm::dvec2(6, 4);
        EXPECT_NEAR(each.p.x, 3 * (uv.x - 0.5), 1e-6);
        EXPECT_NEAR(each.p.y, 2 * (uv.y - 0.5), 1e-6);
        EXPECT_NEAR(each.side, 0.5, 1e-6);
        EXPECT_NEAR(each.along_u.x / glm::length(each.along_u), 1, 1e-6);
    }
}

TEST(TextureCells, RepeatBeyondTheSquare)
{
    Mesh mesh = plane_mesh({1, 1}, {3, 3});
    for (glm::vec2& uv : mesh.uvs[0]) uv = uv * 3.0f - 1.0f;
    EXPECT_EQ(spots_of(mesh, 4, 4).spots.size(), 9u * 16u);
}

TEST(TextureCells, GiveEachPartThatSharesThemASpot)
{
    Mesh mesh = plane_mesh({1, 1}, {4, 4});
    for (glm::vec2& uv : mesh.uvs[0]) uv.x = std::abs(uv.x - 0.5f) * 2; // both halves alike
    const TextureSpots out = spots_of(mesh, 6, 6);
    EXPECT_EQ(out.spots.size(), 72u);
    EXPECT_EQ(out.repeated, 36u);
}

TEST(TextureCells, PassOverWhatIsFlatOrNoNumber)
{
    Mesh mesh = plane_mesh({1, 1}, {2, 2});
    mesh.uvs[0][0].x = std::numeric_limits<float>::quiet_NaN();
    const TextureSpots out = spots_of(mesh, 8, 8);
    EXPECT_GT(out.flat, 0u);
    EXPECT_LT(out.spots.size(), 64u);
    for (glm::vec2& uv : mesh.uvs[0]) uv = glm::vec2(0.5f);
    EXPECT_TRUE(spots_of(mesh, 8, 8).spots.empty());
    mesh.uvs.clear();
    EXPECT_FALSE(texture_spots(mesh, glm::dmat4(1), 8, 8, 100));
}

TEST(TextureCells, EndAtTheGreatestNumber)
{
    const auto out = texture_spots(plane_mesh({1, 1}, {2, 2}), glm::dmat4(1), 100, 100, 77);
    EXPECT_EQ(out->spots.size(), 77u);
    EXPECT_TRUE(out->too_many);
}

} // namespace
} // namespace trivar::testing
