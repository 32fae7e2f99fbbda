// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/limit_chart.h"

#include "tests/limit/cages.h"
#include "tests/tiles/bases.h"

#include <gmock/gmock.h>

namespace trivar::testing {
namespace {

LimitBase limit_base_of(Mesh cage, const glm::dmat4& to_model = glm::dmat4(1))
{
    const std::vector<LimitBase::Piece> pieces{{make_ref(std::move(cage)), to_model}};
    return LimitBase(pieces);
}

TilePatch patch_at_rest(const LimitChart& chart)
{
    std::array<glm::dvec3, 16> p{}, n{};
    for (std::size_t k = 0; k < 16; ++k) {
        p[k] = chart.nodes[k].p;
        n[k] = chart.nodes[k].normal;
    }
    return {through_nodes(p), through_nodes(n)};
}

TEST(LimitBases, FindThePlacesOfPointsOnTheirTriangles)
{
    std::mt19937 random(1);
    for (const NamedCage& cage : all_cages()) {
        SCOPED_TRACE(cage.name);
        const LimitBase base = limit_base_of(cage.mesh);
        for (int k = 0; k < 200; ++k) {
            const SurfacePlace at = random_place(base.triangles(), random);
            const ChartPlace place = base.place(at);
            const glm::dvec3 there = base.surface().position(place);
            // The triangles are an eighth of a chart long.
            EXPECT_LT(glm::distance(there, base.triangles().position(at)), 0.01);
            EXPECT_GT(glm::dot(base.surface().normal(place), base.triangles().normal(at)), 0.5);
        }
    }
}

TEST(LimitBases, OfSeveralPiecesKeepThemApart)
{
    const glm::dmat4 aside = glm::dmat4(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 10, 0, 0, 1);
    const std::vector<LimitBase::Piece> pieces{{make_ref(cube_cage()), glm::dmat4(1)},
                                               {make_ref(tower_cage()), aside},
                                               {make_ref(torus_cage()), aside * aside}};
    const LimitBase base(pieces);
    std::mt19937 random(2);
    for (int k = 0; k < 300; ++k) {
        const SurfacePlace at = random_place(base.triangles(), random);
        const ChartPlace place = base.place(at);
        EXPECT_EQ(base.piece_of(place.chart), base.triangles().piece_of(at.triangle));
        EXPECT_LT(glm::distance(base.surface().position(place), base.triangles().position(at)),
                  0.05);
    }
}

TEST(LimitCharts, AreTheTileItselfOnAPlane)
{
    const LimitBase base = limit_base_of(plane_cage());
    std::mt19937 random(3);
    for (int k = 0; k < 100; ++k) {
        const SurfacePlace at = random_place(base.triangles(), random);
        const glm::dvec3 p = base.triangles().position(at);
        if (std::max(std::abs(p.x), std::abs(p.y)) > 0.7) continue;
        const glm::dvec3 x = random_tangent(base.triangles(), at, random),
                         y = glm::cross(glm::dvec3(0, 0, 1), x);
        const LimitChart chart = limit_chart_of(base, {at, x, 0.4}, 0, 1);
        EXPECT_EQ(chart.cut, 0);
        const TilePatch patch = patch_at_rest(chart);
        for (const glm::dvec3 q : {glm::dvec3(0.1, 0.7, 0.2), {0.9, 0.35, -0.1}, {0.5, 0.5, 1}})
            EXPECT_LT(glm::distance(tile_point(patch, q).p,
                                    p + 0.4 * ((q.x - 0.5) * x + (q.y - 0.5) * y) +
                                        glm::dvec3(0, 0, q.z)),
                      1e-6);
    }
}

TEST(LimitCharts, AreAsLongAsTheirTiles)
{
    const LimitBase base = limit_base_of(torus_cage());
    std::mt19937 random(4);
    for (int k = 0; k < 100; ++k) {
        const SurfacePlace at = random_place(base.triangles(), random);
        const glm::dvec3 x = random_tangent(base.triangles(), at, random);
        constexpr double size = 0.2;
        const LimitChart chart = limit_chart_of(base, {at, x, size}, 0, 1);
        ASSERT_EQ(chart.cut, 0);
        const TilePatch patch = patch_at_rest(chart);
        // Lines through the middle are as long as the tile.
        double length = 0;
        for (int i = 0; i < 64; ++i)
            length += glm::distance(tile_point(patch, {i / 64.0, 0.5, 0}).p,
                                    tile_point(patch, {(i + 1) / 64.0, 0.5, 0}).p);
        EXPECT_NEAR(length, size, 5e-3 * size);
    }
}

TEST(LimitCharts, GoOnStraightBeyondABorderAndSayHowFar)
{
    const LimitBase base = limit_base_of(plane_cage());
    const std::vector<SurfacePoint> near_border{{{0.9, 0.1, 0}, {0, 0, 1}}};
    const SurfacePlace at = *base.triangles().locate(near_border, 0.1).front();
    const LimitChart chart = limit_chart_of(base, {at, {1, 0, 0}, 0.4}, 0, 1);
    EXPECT_NEAR(chart.cut, 0.25 * std::sqrt(2), 1e-5);
    EXPECT_LT(glm::distance(tile_point(patch_at_rest(chart), {1, 0.5, 0}).p, {1.1, 0.1, 0}), 1e-5);
}

TEST(LimitCharts, OfATileThatIsLargerThanTheBaseAreNone)
{
    const LimitBase base = limit_base_of(cube_cage());
    EXPECT_GT(limit_chart_of(base, {SurfacePlace{}, {1, 0, 0}, 1e9}, 0, 1).cut, 1e100);
}

} // namespace
} // namespace trivar::testing
