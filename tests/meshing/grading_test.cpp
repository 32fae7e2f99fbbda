// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/grading.h"

#include "core/base/rejected.h"
#include "core/meshing/bcc_cells.h"
#include "core/simplex/box_domain.h"
#include "tests/meshing/domain_shapes.h"

#include <gtest/gtest.h>
#include <limits>

namespace trivar {
namespace {

SimplexMesh<3> cubes()
{
    return box_cells(glm::dvec3(2), glm::ivec3(4));
}

// The longest edge of all that reach into a ball, or of all that stay that far from it.
double longest_edge(const SimplexMesh<3>& mesh, const glm::dvec3& center, double radius, bool in)
{
    double out = 0;
    for (const auto& cell : mesh.cells)
        for (const int a : cell)
            for (const int b : cell) {
                const glm::dvec3 &p = mesh.vertices[static_cast<std::size_t>(a)],
                                 &q = mesh.vertices[static_cast<std::size_t>(b)];
                const double t =
                    a == b ? 0
                           : glm::clamp(glm::dot(center - p, q - p) / glm::dot(q - p, q - p), 0.0,
                                        1.0);
                if ((glm::distance(center, p + (q - p) * t) < radius) == in)
                    out = std::max(out, glm::distance(p, q));
            }
    return out;
}

TEST(Grading, MakesEdgesInABallAsShortAsAsked)
{
    for (const double edge : {0.3, 0.1, 0.04})
        for (const SimplexMesh<3>& mesh :
             {cubes(), bcc_cells({glm::dvec3(-1), glm::dvec3(1)}, 0.5)}) {
            const glm::dvec3 center(0.3, 0.2, -0.1);
            const GradedCells out = refined(mesh, {.balls = {{center, 0.2, edge}}});
            EXPECT_FALSE(out.capped);
            EXPECT_LE(longest_edge(out.mesh, center, 0.2, true), 1.2 * edge);
            EXPECT_GE(longest_edge(out.mesh, center, 0.2, true), 0.5 * edge);
            EXPECT_EQ(fault(out.mesh), "");
            EXPECT_NEAR(volume(out.mesh), volume(mesh), 1e-9);
        }
}

TEST(Grading, LeavesCellsFarAwayCoarse)
{
    const GradedCells out =
        refined(box_cells(glm::dvec3(8), glm::ivec3(8)), {.balls = {{glm::dvec3(-3), 0.2, 0.05}}});
    EXPECT_GE(longest_edge(out.mesh, glm::dvec3(-3), 5, false), std::sqrt(3.0) - 1e-9);
    EXPECT_LE(out.mesh.cells.size(), 60'000U); // all as fine: 25 million
}

TEST(Grading, KeepsOldVerticesAndGoodAngles)
{
    const SimplexMesh<3> mesh = cubes();
    const GradedCells out = refined(mesh, {.balls = {{glm::dvec3(0.1), 0.1, 0.02}}});
    ASSERT_GT(out.mesh.vertices.size(), mesh.vertices.size());
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        EXPECT_EQ(out.mesh.vertices[v], mesh.vertices[v]);
    EXPECT_GE(least_dihedral(out.mesh), 45 * one_degree - 1e-9);
    EXPECT_EQ(refined(mesh, {}).mesh, mesh); // nothing is asked
}

TEST(Grading, KeepsWhatAnyCellsHadOfAnglesInPart)
{
    // six times halved, and not cubes
    const SimplexMesh<3> mesh = box_cells({3, 1, 0.7}, {2, 1, 1});
    const GradedCells out = refined(mesh, {.edge = 0.12});
    EXPECT_EQ(fault(out.mesh), "");
    EXPECT_GE(least_dihedral(out.mesh), 0.5 * least_dihedral(mesh));
}

TEST(Grading, SumsToOne)
{
    const GradedCells out = refined(cubes(), {.balls = {{glm::dvec3(0.5), 0.1, 0.1}}});
    for (int n = 1; n <= 3; ++n) EXPECT_LE(sum_error(out.mesh, n, 1), 1e-12) << n;
}

TEST(Grading, StopsAtTheLimitOfCells)
{
    const GradedCells out = refined(cubes(), {.edge = 0.01, .cell_limit = 5000});
    EXPECT_TRUE(out.capped);
    EXPECT_GE(out.mesh.cells.size(), 5000U);
    EXPECT_LE(out.mesh.cells.size(), 5100U);
    EXPECT_EQ(fault(out.mesh), "");
}

TEST(Grading, RefusesWhatIsNoGradingOrNoMesh)
{
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const auto refuses = [](const FineBall& ball) {
        EXPECT_THROW(refined(cubes(), {.balls = {ball}}), Rejected);
    };
    refuses({glm::dvec3(nan), 1, 0.1});
    refuses({glm::dvec3(0), -1, 0.1});
    refuses({glm::dvec3(0), 1, 0});
    refuses({glm::dvec3(0), 1, nan});
    refuses({glm::dvec3(0), 1, 1e-9});
    EXPECT_THROW(refined(cubes(), {.edge = nan}), Rejected);
    EXPECT_THROW(refined(cubes(), {.growth = 0}), Rejected);
    SimplexMesh<3> inverted = cubes();
    std::swap(inverted.cells[7][0], inverted.cells[7][1]);
    EXPECT_THROW(refined(inverted, {}), Rejected);
    SimplexMesh<3> twice = cubes();
    twice.cells.push_back(twice.cells[5]);
    twice.cells.push_back(twice.cells[5]);
    EXPECT_THROW(refined(twice, {}), Rejected);
    SimplexMesh<3> stranger = cubes();
    stranger.cells[3][2] = 1000;
    EXPECT_THROW(refined(stranger, {}), Rejected);
    EXPECT_EQ(refined({}, {.edge = 1}).mesh, SimplexMesh<3>{});
}

} // namespace
} // namespace trivar
