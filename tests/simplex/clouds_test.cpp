// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/clouds.h"

#include "core/base/rejected.h"
#include "core/simplex/box_domain.h"
#include "core/simplex/simplex_basis.h"

#include <gtest/gtest.h>
#include <random>

namespace trivar {
namespace {

// The faces of a box of 2 x 2 x 2 that lie in the plane x = 0.
std::vector<Crease<3>> middle_plane(const SimplexMesh<3>& mesh, int depth)
{
    std::vector<Crease<3>> out;
    for (const auto& cell : mesh.cells)
        for (std::size_t k = 0; k < 4; ++k) {
            Crease<3> crease{{}, depth};
            for (std::size_t i = 0, n = 0; i < 4; ++i)
                if (i != k) crease.face[n++] = cell[i];
            bool in_plane = true;
            for (const int v : crease.face)
                in_plane = in_plane && mesh.vertices[static_cast<std::size_t>(v)].x == 0;
            if (in_plane) out.push_back(crease);
        }
    return out;
}

SimplexBasis<3> creased(int degree, int depth)
{
    const SimplexMesh<3> mesh = box_cells(glm::dvec3(2), glm::ivec3(2));
    return SimplexBasis<3>(
        with_clouds<3>(mesh.vertices, mesh.cells, degree, {}, middle_plane(mesh, depth)));
}

// A function with control values that know nothing of each other, and its derivative along x.
glm::dvec2 sample(const SimplexBasis<3>& basis, const glm::dvec3& p)
{
    std::vector<BasisValue<3>> values;
    basis.values_at(p, true, values);
    glm::dvec2 out(0);
    for (const auto& v : values) out += glm::dvec2(v.value, v.gradient.x) * std::sin(3.0 * v.point);
    return out;
}

// The greatest jumps of value and derivative across x = 0.
glm::dvec2 jump(const SimplexBasis<3>& basis)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> anywhere(-0.9, 0.9);
    glm::dvec2 out(0);
    for (int n = 0; n < 100; ++n) {
        const glm::dvec3 p{1e-9, anywhere(random), anywhere(random)};
        out = glm::max(out, glm::abs(sample(basis, p) - sample(basis, p * glm::dvec3(-1, 1, 1))));
    }
    return out;
}

TEST(Clouds, KeepDerivativesOfDegreeLessOneWithoutCreases)
{
    EXPECT_LE(jump(creased(1, 0)).x, 1e-6);
    EXPECT_LE(jump(creased(2, 0)).x, 1e-6);
    EXPECT_LE(jump(creased(2, 0)).y, 1e-5);
    EXPECT_LE(jump(creased(3, 0)).y, 1e-5);
}

TEST(Clouds, LowerTheContinuityAtCreasesByTheirDepth)
{
    EXPECT_LE(jump(creased(2, 1)).x, 1e-6);
    EXPECT_GE(jump(creased(2, 1)).y, 0.1); // a crease
    EXPECT_GE(jump(creased(2, 2)).x, 0.1); // a cut
    EXPECT_LE(jump(creased(3, 1)).y, 1e-5);
    EXPECT_LE(jump(creased(3, 2)).x, 1e-6);
    EXPECT_GE(jump(creased(3, 2)).y, 0.1);
    EXPECT_GE(jump(creased(3, 3)).x, 0.1);
}

TEST(Clouds, SumToOneOnAndBesideACut)
{
    for (int degree = 1; degree <= 3; ++degree) {
        const SimplexBasis<3> basis = creased(degree, degree);
        std::mt19937 random(6);
        std::uniform_real_distribution<double> anywhere(-1, 1);
        for (int n = 0; n < 500; ++n) {
            glm::dvec3 p{anywhere(random), anywhere(random), anywhere(random)};
            if (n % 3 == 0) p.x = 0;
            if (n % 3 == 1) p = glm::round(p * 2.0) / 2.0;
            std::vector<BasisValue<3>> values;
            basis.values_at(p, false, values);
            double sum = -1;
            for (const auto& v : values) sum += v.value;
            EXPECT_LE(std::abs(sum), 1e-12) << degree << " " << p.x << " " << p.y << " " << p.z;
        }
    }
}

TEST(Clouds, KeepACutShutAtItsRim)
{
    // one half of the plane: y > 0
    const SimplexMesh<3> mesh = box_cells(glm::dvec3(2), glm::ivec3(4));
    std::vector<Crease<3>> half;
    for (const Crease<3>& crease : middle_plane(mesh, 2)) {
        bool above = true;
        for (const int v : crease.face)
            above = above && mesh.vertices[static_cast<std::size_t>(v)].y >= 0;
        if (above) half.push_back(crease);
    }
    const SimplexBasis<3> basis(with_clouds<3>(mesh.vertices, mesh.cells, 2, {}, half));
    const auto jump_at = [&](double y, double z) {
        return std::abs(sample(basis, {1e-9, y, z}).x - sample(basis, {-1e-9, y, z}).x);
    };
    double below = 0, above = 0;
    for (double z = -0.95; z < 1; z += 0.1) {
        for (double y = -0.95; y < 0; y += 0.1) below = std::max(below, jump_at(y, z));
        for (double y = 0.6; y < 1; y += 0.1) above = std::max(above, jump_at(y, z));
    }
    EXPECT_LE(below, 1e-6);
    EXPECT_GE(above, 0.1);
}

TEST(Clouds, ShareControlPointsWhereTheyAreStacked)
{
    const SimplexMesh<3> mesh = box_cells(glm::dvec3(2), glm::ivec3(1));
    const auto points = [&](bool clamped) {
        return SimplexBasis<3>(with_clouds<3>(mesh.vertices, mesh.cells, 2,
                                              {.border = clamped ? CloudBorder::stacked
                                                                 : CloudBorder::outside}))
            .point_count();
    };
    EXPECT_EQ(points(false), 60U); // 10 per cell
    EXPECT_EQ(points(true), 27U);  // one per vertex and edge, as for quadratic Bezier cells
}

TEST(Clouds, RefuseWhatIsNoDomain)
{
    const SimplexMesh<3> box = box_cells(glm::dvec3(2), glm::ivec3(1));
    auto cells = box.cells;
    std::swap(cells[0][0], cells[0][1]);
    EXPECT_THROW(with_clouds<3>(box.vertices, cells, 2), Rejected);
    auto vertices = box.vertices;
    vertices[1] = vertices[0];
    EXPECT_THROW(with_clouds<3>(vertices, box.cells, 2), Rejected);
    vertices[1].x = NAN;
    EXPECT_THROW(with_clouds<3>(vertices, box.cells, 2), Rejected);
    EXPECT_THROW(with_clouds<3>(box.vertices, box.cells, 0), Rejected);
    EXPECT_THROW(with_clouds<3>(box.vertices, box.cells, 7), Rejected);
    cells = box.cells;
    cells.push_back(cells[0]);
    EXPECT_THROW(with_clouds<3>(box.vertices, cells, 2), Rejected);
    cells[6] = {0, 1, 2, 90};
    EXPECT_THROW(with_clouds<3>(box.vertices, cells, 2), Rejected);
}

TEST(Clouds, FindTheOneFaultInAMillionCells)
{
    SimplexMesh<3> mesh = box_cells(glm::dvec3(2), glm::ivec3(55));
    const std::size_t last = mesh.cells.size() - 1;
    const auto fault = [&] {
        try {
            (void)with_clouds<3>(mesh.vertices, mesh.cells, 3);
        } catch (const Rejected& rejected) {
            return std::string(rejected.what());
        }
        return std::string();
    };
    std::swap(mesh.cells[last][0], mesh.cells[last][1]);
    EXPECT_EQ(fault(), "Cell " + std::to_string(last) + " of the domain is flat or inverted.");
    std::swap(mesh.cells[last][0], mesh.cells[last][1]);
    mesh.vertices.push_back(mesh.vertices[0]);
    EXPECT_EQ(fault(), "Two vertices of the domain are at the same place.");
}

} // namespace
} // namespace trivar
