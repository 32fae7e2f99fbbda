// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/cells_around.h"

#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/meshing/hull_cells.h"
#include "core/simplex/cell_search.h"
#include "tests/meshing/domain_shapes.h"

#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace trivar {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

FilledCells around(const TriangleSurface& model, const CellFilling& filling)
{
    return cells_around(model.positions, model.triangles, filling);
}

CellFilling with_edge(double edge)
{
    return {.grading = {.edge = edge}};
}

std::size_t lost(const std::vector<glm::dvec3>& points, const SimplexMesh<3>& mesh)
{
    const CellSearch search(mesh);
    std::size_t out = 0;
    for (const glm::dvec3& p : points) out += search.cell_at(p) < 0 ? 1 : 0;
    return out;
}

std::vector<glm::dvec3> on_faces(const TriangleSurface& model, std::size_t count)
{
    std::mt19937 random(1);
    std::exponential_distribution<double> share(1);
    std::vector<glm::dvec3> out;
    for (std::size_t n = 0; n < count; ++n) {
        const auto& t = model.triangles[n % model.triangles.size()];
        const glm::dvec3 l(share(random), share(random), share(random));
        glm::dvec3 p(0);
        for (int k = 0; k < 3; ++k)
            p += model.positions[static_cast<std::size_t>(t[static_cast<std::size_t>(k)])] *
                 (l[k] / (l.x + l.y + l.z));
        out.push_back(p);
    }
    return out;
}

TEST(CellsAround, HoldTheModelAndAreWellShaped)
{
    const TriangleSurface models[]{torus(1, 0.4, 48, 24), sphere(12),
                                   box_surface(glm::dvec3(-1, -0.3, -0.05), glm::dvec3(1, 0.3, 0))};
    for (const TriangleSurface& model : models)
        for (const double edge : {0.6, 0.3, 0.13}) {
            const FilledCells out = around(model, with_edge(edge));
            EXPECT_EQ(fault(out.mesh), "") << edge;
            EXPECT_GE(least_dihedral(out.mesh), 0.26);
            EXPECT_EQ(lost(model.positions, out.mesh), 0U);
            EXPECT_EQ(lost(on_faces(model, 5000), out.mesh), 0U);
            EXPECT_GE(out.smooth, 0.5);
            EXPECT_FALSE(out.capped);
        }
}

TEST(CellsAround, SumToOneThoughTheyAreNotConvex)
{
    const FilledCells out = around(torus(1, 0.4, 24, 12), with_edge(0.4));
    for (int degree = 1; degree <= 3; ++degree)
        for (const bool clamped : {false, true})
            EXPECT_LE(sum_error(out.mesh, degree, 2, clamped), 1e-12) << degree << clamped;
}

TEST(CellsAround, LeaveHolesOpenAndFillWhatIsClosed)
{
    // the hole of a torus, whose radius is 0.6
    EXPECT_LT(CellSearch(around(torus(1, 0.4, 48, 24), with_edge(0.2)).mesh).cell_at({0, 0, 0}), 0);
    EXPECT_GE(CellSearch(around(sphere(12), with_edge(0.2)).mesh).cell_at({0, 0, 0}), 0);
    TriangleSurface open = sphere(12); // turned inside out in part, and without a few faces
    for (std::size_t t = 0; t < open.triangles.size(); t += 3)
        std::swap(open.triangles[t][0], open.triangles[t][1]);
    open.triangles.resize(open.triangles.size() - 5);
    const FilledCells out = around(open, with_edge(0.3));
    EXPECT_GE(CellSearch(out.mesh).cell_at({0, 0, 0}), 0);
    EXPECT_EQ(fault(out.mesh), "");
}

TEST(CellsAround, AreFinerWhereAsked)
{
    const TriangleSurface model = sphere(12);
    CellFilling filling = with_edge(0.5);
    const std::size_t coarse = around(model, filling).mesh.cells.size();
    filling.grading.balls = {{{1, 0, 0}, 0.1, 0.05}};
    const FilledCells out = around(model, filling);
    EXPECT_EQ(fault(out.mesh), "");
    EXPECT_GE(least_dihedral(out.mesh), 0.26);
    EXPECT_GT(out.mesh.cells.size(), 2 * coarse);
    EXPECT_LT(out.mesh.cells.size(), 20 * coarse);
    EXPECT_EQ(lost(model.positions, out.mesh), 0U);
    EXPECT_LE(sum_error(out.mesh, 2, 1), 1e-12);
}

TEST(CellsAround, TakeModelsThatAreNoSolids)
{
    const TriangleSurface models[]{
        {{{1, 2, 3}}, {}},                                                        // a point
        {{{0, 0, 0}, {1, 0, 0}}, {}},                                             // two
        {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{{0, 1, 2}}}},                       // without area
        {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{{0, 1, 2}, {1, 3, 2}}}}, // flat
        {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {{{0, 1, 2}}}},
        {{{1e9, 1e9, 1e9}, {1e9 + 1, 1e9, 1e9}, {1e9, 1e9 + 1, 1e9}}, {{{0, 1, 2}}}}};
    for (const TriangleSurface& model : models) {
        const FilledCells out = around(model, {.grading = {.edge = 0}});
        EXPECT_EQ(fault(out.mesh), "");
        EXPECT_EQ(lost(model.positions, out.mesh), 0U);
    }
}

TEST(CellsAround, AreAsManyAsAllowedAndSaySo)
{
    CellFilling filling = with_edge(0.01);
    filling.grading.cell_limit = 10'000;
    const FilledCells out = around(sphere(12), filling);
    EXPECT_TRUE(out.capped);
    EXPECT_GT(out.edge, 0.01);
    EXPECT_LE(out.mesh.cells.size(), 10'000U);
    EXPECT_GE(out.mesh.cells.size(), 1'000U);
}

TEST(CellsAround, AreTheSameOnOneThread)
{
    const FilledCells many = around(sphere(12), with_edge(0.3));
    const ThreadLimit limit(1);
    EXPECT_EQ(many.mesh, around(sphere(12), with_edge(0.3)).mesh);
}

TEST(CellsAround, RefuseWhatIsNoModel)
{
    EXPECT_THROW(around({}, {}), Rejected);
    EXPECT_THROW(around({{{not_a_number, 0, 0}}, {}}, {}), Rejected);
    EXPECT_THROW(around({{{0, 0, 0}}, {{{0, 0, 1}}}}, {}), Rejected);
    for (const double edge : {-1.0, not_a_number, std::numeric_limits<double>::infinity()})
        EXPECT_THROW(around(sphere(4), with_edge(edge)), Rejected) << edge;
    EXPECT_THROW(around(sphere(4), {.margin = -1}), Rejected);
    EXPECT_THROW(around(sphere(4), {.least_angle = 1}), Rejected);
    EXPECT_THROW(hull_cells({}, {}), Rejected);
    EXPECT_THROW(hull_cells(std::vector<glm::dvec3>{{not_a_number, 0, 0}}, {}), Rejected);
}

TEST(HullCells, HoldAllBetweenThePoints)
{
    const TriangleSurface model = torus(1, 0.4, 24, 12);
    const FilledCells out = hull_cells(model.positions, with_edge(0.25));
    EXPECT_EQ(fault(out.mesh), "");
    EXPECT_GE(least_dihedral(out.mesh), 0.26);
    EXPECT_EQ(lost(model.positions, out.mesh), 0U);
    EXPECT_GE(CellSearch(out.mesh).cell_at({0, 0, 0}), 0);
    EXPECT_LE(sum_error(out.mesh, 2, 1), 1e-12);
    // with a margin of 0.5
    const FilledCells wide =
        hull_cells(model.positions, {.grading = {.edge = 0.25}, .margin = 0.5});
    std::vector<glm::dvec3> grown;
    for (const glm::dvec3& p : model.positions)
        for (const double by : {-0.5, 0.5}) grown.push_back(p + glm::dvec3(0, 0, by));
    EXPECT_EQ(lost(grown, wide.mesh), 0U);
}

TEST(HullCells, TakePointsInOnePlaneOrLine)
{
    const std::vector<std::vector<glm::dvec3>> all{
        {{2, 3, 4}},
        {{0, 0, 0}, {1, 1, 1}, {3, 3, 3}},
        {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.5, 0.2, 0}}};
    for (const auto& points : all) {
        const FilledCells out = hull_cells(points, {});
        EXPECT_EQ(fault(out.mesh), "");
        EXPECT_EQ(lost(points, out.mesh), 0U);
    }
}

} // namespace
} // namespace trivar
