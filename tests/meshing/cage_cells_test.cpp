// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/cage_cells.h"

#include "core/base/rejected.h"
#include "tests/meshing/domain_shapes.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <limits>

namespace trivar {
namespace {

CageCells in(const TriangleSurface& cage, const Grading& grading)
{
    return cage_cells(cage.positions, cage.triangles, grading);
}

double inside(const TriangleSurface& cage)
{
    double out = 0;
    for (const auto& t : cage.triangles) {
        const auto at = [&](std::size_t k) {
            return cage.positions[static_cast<std::size_t>(t[k])];
        };
        out += glm::dot(at(0), glm::cross(at(1), at(2))) / 6;
    }
    return std::abs(out);
}

// An L of three cubes.
TriangleSurface bracket()
{
    TriangleSurface out;
    for (const double z : {0.0, 1.0})
        for (const glm::dvec2 p : {glm::dvec2(0, 0), {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}})
            out.positions.emplace_back(p, z);
    for (int i = 0; i < 6; ++i) {
        const int j = (i + 1) % 6;
        out.triangles.push_back({i, j, j + 6});
        out.triangles.push_back({i, j + 6, i + 6});
    }
    for (const std::array<int, 3> t :
         {std::array<int, 3>{0, 2, 1}, {0, 3, 2}, {0, 4, 3}, {0, 5, 4}}) {
        out.triangles.push_back(t);
        out.triangles.push_back({t[0] + 6, t[2] + 6, t[1] + 6});
    }
    return out;
}

TEST(CageCells, FillACageExactly)
{
    const TriangleSurface cages[]{box_surface({-1, -0.5, 0}, {1, 0.5, 0.4}), bracket(),
                                  torus(1, 0.4, 8, 5)};
    for (const TriangleSurface& cage : cages)
        for (const double edge : {1.0, 0.3}) {
            const CageCells out = in(cage, {.edge = edge});
            EXPECT_EQ(fault(out.mesh), "");
            EXPECT_TRUE(out.exact);
            EXPECT_FALSE(out.capped);
            EXPECT_NEAR(volume(out.mesh), inside(cage), 1e-9);
            EXPECT_GE(least_dihedral(out.mesh), 2.4 * one_degree);
            for (const glm::dvec3& v : cage.positions)
                EXPECT_EQ(std::count(out.mesh.vertices.begin(), out.mesh.vertices.end(), v), 1);
            EXPECT_LE(sum_error(out.mesh, 2, 1), 1e-12);
            EXPECT_LE(out.edge, edge);
            if (least_dihedral(out.mesh) > 3 * one_degree) { // so that no other edge is tried
                EXPECT_EQ(in(cage, {.edge = out.edge}).mesh, out.mesh);
            }
        }
}

TEST(CageCells, AreFinerWhereAsked)
{
    const TriangleSurface cage = box_surface(glm::dvec3(-1), glm::dvec3(1));
    const CageCells coarse = in(cage, {.edge = 0.8});
    const CageCells out = in(cage, {.edge = 0.8, .balls = {{glm::dvec3(1), 0.2, 0.1}}});
    EXPECT_EQ(fault(out.mesh), "");
    EXPECT_TRUE(out.exact);
    EXPECT_GE(least_dihedral(out.mesh), 8 * one_degree);
    EXPECT_GT(out.mesh.cells.size(), 2 * coarse.mesh.cells.size());
    EXPECT_LT(out.mesh.cells.size(), 100 * coarse.mesh.cells.size());
}

TEST(CageCells, AreTheSameEachTimeAndFromEitherSide)
{
    TriangleSurface cage = bracket();
    const CageCells out = in(cage, {.edge = 0.4});
    EXPECT_EQ(out.mesh, in(cage, {.edge = 0.4}).mesh);
    for (auto& t : cage.triangles) std::swap(t[0], t[1]);
    EXPECT_NEAR(volume(in(cage, {.edge = 0.4}).mesh), 3, 1e-9);
}

TEST(CageCells, RefuseWhatIsNoCage)
{
    const TriangleSurface good = box_surface(glm::dvec3(-1), glm::dvec3(1));
    const auto refuses = [](const TriangleSurface& cage) {
        EXPECT_THROW(in(cage, {.edge = 0.5}), Rejected);
    };
    refuses({});
    TriangleSurface bad = good;
    bad.triangles.pop_back(); // open
    refuses(bad);
    bad = good;
    bad.positions[3].y = std::numeric_limits<double>::quiet_NaN();
    refuses(bad);
    bad = good;
    bad.triangles[0][0] = 8;
    refuses(bad);
    bad = good;
    bad.positions[0] = {0, 0, 3}; // crosses itself
    refuses(bad);
    bad = good;
    for (glm::dvec3& p : bad.positions) p.z = 0; // flat
    refuses(bad);
    bad = good;
    bad.triangles.push_back(bad.triangles[0]); // a face twice
    refuses(bad);
    bad.triangles.assign(1'000'000, good.triangles[0]);
    refuses(bad);
    EXPECT_THROW(in(good, {.edge = 0}).mesh.cells.at(1'000'000),
                 std::out_of_range); // by default few
    EXPECT_THROW(in(good, {.edge = -1}), Rejected);
}

// The first cells have a sliver, and shorter edges make more cells than the limit.
TEST(CageCells, AreTheFirstOnesWhereRounderOnesAreTooMany)
{
    TriangleSurface cage;
    cage.positions = {{-0.19855, -0.12159, -0.24265}, {0.13933, -0.22894, -0.19146},
                      {-0.15736, 0.29633, -0.14492},  {0.17357, 0.15480, -0.27063},
                      {-0.11646, -0.24248, 0.30371},  {0.16641, -0.24599, 0.27955},
                      {-0.12525, 0.20237, 0.13913},   {0.08291, 0.25405, 0.20241}};
    cage.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    const CageCells out = in(cage, {.edge = 0.01, .cell_limit = 2000});
    EXPECT_EQ(fault(out.mesh), "");
    EXPECT_TRUE(out.exact);
}

TEST(CageCells, AreAsManyAsAllowedAndSaySo)
{
    const CageCells out =
        in(box_surface(glm::dvec3(-1), glm::dvec3(1)), {.edge = 0.05, .cell_limit = 5000});
    EXPECT_TRUE(out.capped);
    EXPECT_GT(out.edge, 0.05);
    EXPECT_LE(out.mesh.cells.size(), 10'000U);
}

} // namespace
} // namespace trivar
