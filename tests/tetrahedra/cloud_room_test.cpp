// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tetrahedra/cloud_room.h"

#include "core/base/rejected.h"
#include "core/simplex/simplex_basis.h"
#include "core/tetrahedra/tetrahedra_layers.h"

#include <gtest/gtest.h>
#include <random>

namespace trivar {
namespace {

constexpr int middle_vertex = 13; // the vertex in the middle of a box of 2 x 2 x 2

TetrahedraShape with_cloud(const TetrahedraCloud& cloud, int degree = 2)
{
    TetrahedraShape out{.size = glm::dvec3(2), .boxes = glm::ivec3(2), .degree = degree};
    out.edits.push_back({.cloud = cloud});
    return out;
}

TEST(CloudRoom, IsLeftAroundCloudsThatWereMadeAndAllOfItWhereTheyAreStacked)
{
    const SimplexDomain<3> made = domain_of(with_cloud({}));
    EXPECT_GE(cloud_room(made, cells_round(made, middle_vertex)), 0.2);
    EXPECT_LE(cloud_room(made, cells_round(made, middle_vertex)), 0.9);
    TetrahedraShape stacked = with_cloud({.factor = 0});
    stacked.edits.clear();
    const SimplexMesh<3> mesh = domain_cells(stacked);
    for (const glm::dvec3& v : mesh.vertices)
        stacked.edits.push_back({.cloud = TetrahedraCloud{.at = v, .factor = 0}});
    const SimplexDomain<3> bare = domain_of(stacked);
    EXPECT_EQ(cloud_room(bare, cells_round(bare, middle_vertex)), 1);
}

TEST(CloudRoom, EndsWhereTheAllowedShareOfAMovementEnds)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<double> anywhere(-1, 1);
    for (int n = 0; n < 30; ++n) {
        const int degree = 2 + n % 2, knot = 1 + n % degree;
        const SimplexDomain<3> before = domain_of(with_cloud({}, degree));
        const std::vector<int> cells = cells_round(before, middle_vertex);
        const glm::dvec3 by{anywhere(random), anywhere(random), anywhere(random)};
        const double share = allowed_share(before, cells, middle_vertex, knot, by);
        const auto room_at = [&](double t) {
            SimplexDomain<3> out = before;
            out.knots[static_cast<std::size_t>(middle_vertex * (degree + 1) + knot)] += by * t;
            return cloud_room(out, cells);
        };
        const double least = std::min(least_room, room_at(0));
        for (const double t : {0.25, 0.5, 0.75, 1.0}) EXPECT_GE(room_at(share * t), least - 1e-12);
        if (share < 1) {
            EXPECT_LT(room_at(share * 1.01), least);
        }
    }
}

TEST(CloudRoom, HasTheRegionInWhichAKnotMayBe)
{
    const SimplexDomain<3> domain = domain_of(with_cloud({}));
    const std::vector<int> cells = cells_round(domain, middle_vertex);
    for (int knot = 1; knot <= 2; ++knot) {
        const auto region = knot_region(domain, cells, middle_vertex, knot, 4);
        EXPECT_GE(region.size(), 4U);
        const glm::dvec3 from = domain.knot(middle_vertex, knot);
        for (const auto& face : region) {
            const glm::dvec3 normal = glm::cross(face[1] - face[0], face[2] - face[0]);
            EXPECT_LE(glm::dot(normal, from - face[0]), 1e-9); // it is inside
            for (const glm::dvec3& corner : face) {
                const glm::dvec3 by = (corner - from) * 1.01;
                EXPECT_NEAR(allowed_share(domain, cells, middle_vertex, knot, by), 1 / 1.01, 1e-6);
            }
        }
    }
}

TEST(CloudRoom, RefusesCloudsThatCrossInOneSentence)
{
    EXPECT_NO_THROW(domain_of(with_cloud({.knot = 2, .by = {0.1, 0, 0}})));
    try {
        (void)domain_of(with_cloud({.knot = 2, .by = {1.7, 0.2, 0.1}}));
        FAIL();
    } catch (const Rejected& error) {
        EXPECT_NE(std::string(error.what()).find("cross"), std::string::npos) << error.what();
    }
}

TEST(CloudRoom, MovesTheKnotsThatWereMeantAndLeavesTheSumOfTheFunctions)
{
    const SimplexDomain<3> before = domain_of(with_cloud({}));
    const SimplexDomain<3> after = domain_of(with_cloud({.knot = 1, .by = {0.05, 0, -0.1}}));
    const SimplexDomain<3> wider = domain_of(with_cloud({.factor = 1.5}));
    for (std::size_t i = 0; i < before.knots.size(); ++i) {
        const bool meant = i == 3 * middle_vertex + 1, all = i / 3 == middle_vertex;
        const glm::dvec3 by = meant ? glm::dvec3(0.05, 0, -0.1) : glm::dvec3(0);
        EXPECT_LE(glm::distance(after.knots[i], before.knots[i] + by), 1e-12) << i;
        const glm::dvec3 from = before.vertex(middle_vertex);
        EXPECT_LE(glm::distance(wider.knots[i],
                                all ? from + 1.5 * (before.knots[i] - from) : before.knots[i]),
                  1e-12);
    }
    const SimplexBasis<3> basis(after);
    std::vector<BasisValue<3>> values;
    basis.values_at({0.1, 0.2, -0.05}, false, values);
    double sum = 0;
    for (const auto& each : values) sum += each.value;
    EXPECT_NEAR(sum, 1, 1e-12);
}

TEST(CloudRoom, KeepsKnotsInThePlanesOfCreases)
{
    TetrahedraShape shape = with_cloud({.knot = 2, .by = {0.1, 0.1, 0}});
    TetrahedraCrease crease{.radius = 3, .depth = 1}; // all faces: the knot has no way to go
    crease.places = {{0, 0, 0}};
    shape.edits.push_back({.crease = crease});
    const SimplexDomain<3> domain = domain_of(shape);
    EXPECT_EQ(domain.knot(middle_vertex, 2), domain.vertex(middle_vertex));
}

} // namespace
} // namespace trivar
