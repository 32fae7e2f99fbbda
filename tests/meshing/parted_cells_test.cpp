// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/meshing/parted_cells.h"

#include "core/base/rejected.h"
#include "core/meshing/boundary_fit.h"
#include "tests/meshing/domain_shapes.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

CellParting ball_in_box(double edge)
{
    return {.box = {glm::dvec3(-1, -1.2, -1), glm::dvec3(1, 1, 1.1)},
            .inside = [](const glm::dvec3& p) { return glm::length(p) < 0.6; },
            .edge = edge,
            .boundary_edge = edge / 2};
}

TEST(PartedCells, FillTheBoxAndFollowTheBoundary)
{
    const CellParting parting = ball_in_box(0.5);
    const PartedCells cells = parted_cells(parting);
    EXPECT_EQ(fault(cells.mesh), "");
    EXPECT_GT(least_dihedral(cells.mesh), 3 * one_degree);
    const glm::dvec3 size = parting.box.size();
    EXPECT_NEAR(volume(cells.mesh), size.x * size.y * size.z, 1e-9);
    const std::vector<Crease<3>> cuts = cuts_between(cells, 2);
    EXPECT_GT(cuts.size(), 50U);
    for (const Crease<3>& cut : cuts)
        for (const int v : cut.face)
            EXPECT_NEAR(glm::length(cells.mesh.vertices[static_cast<std::size_t>(v)]), 0.6, 1e-3);
}

TEST(PartedCells, FillTheBoxToItsEdgesWhereTheBoundaryMeetsThem)
{
    CellParting parting = ball_in_box(0.4);
    parting.inside = [](const glm::dvec3& p) { // leaves through a face and over an edge
        return glm::length(glm::dvec2(p.x - 0.6 * p.y, p.z - 0.2)) < 0.5;
    };
    const PartedCells cells = parted_cells(parting);
    EXPECT_EQ(fault(cells.mesh), "");
    const glm::dvec3 size = parting.box.size();
    EXPECT_NEAR(volume(cells.mesh), size.x * size.y * size.z, 1e-9);
    EXPECT_GT(cuts_between(cells, 2).size(), 50U);
}

TEST(PartedCells, AreTheSameWhereverTheyLieInMemory)
{
    const CellParting parting = ball_in_box(0.35);
    const PartedCells cells = parted_cells(parting);
    std::vector<std::vector<char>> holes; // so that the next run gets other addresses
    for (std::size_t i = 0; i < 5000; ++i) holes.emplace_back(17 * i % 700 + 1);
    for (std::size_t i = 0; i < holes.size(); i += 3) holes[i] = {};
    EXPECT_EQ(parted_cells(parting).mesh, cells.mesh);
}

double inner_volume(const PartedCells& cells)
{
    SimplexMesh<3> inner{cells.mesh.vertices, {}};
    for (std::size_t c = 0; c < cells.inside.size(); ++c)
        if (cells.inside[c]) inner.cells.push_back(cells.mesh.cells[c]);
    return volume(inner);
}

TEST(PartedCells, HaveFacesOnBothSidesOfTheBoundaryOnceTheseAreFitted)
{
    const CellParting parting = ball_in_box(0.5);
    const PartedCells cells = parted_cells(parting),
                      fitted = with_fitted_faces(cells, parting.inside);
    const double ball = 4.18879 * 0.216;
    EXPECT_LT(inner_volume(cells), 0.97 * ball);
    EXPECT_NEAR(inner_volume(fitted), ball, 0.012 * ball);
    EXPECT_EQ(fault(fitted.mesh), "");
    EXPECT_NEAR(volume(fitted.mesh), volume(cells.mesh), 1e-9);
}

TEST(PartedCells, NeedABoundaryAndLengths)
{
    CellParting parting = ball_in_box(0.5);
    parting.inside = [](const glm::dvec3&) { return false; };
    EXPECT_THROW(parted_cells(parting), Rejected);
    EXPECT_THROW(parted_cells(ball_in_box(0)), Rejected);
    parting = ball_in_box(0.5);
    parting.boundary_edge = 1;
    EXPECT_THROW(parted_cells(parting), Rejected);
    parting = ball_in_box(0.1);
    parting.cell_limit = 1000;
    EXPECT_THROW(parted_cells(parting), Rejected);
    parting.box = {};
    EXPECT_THROW(parted_cells(parting), Rejected);
}

} // namespace
} // namespace trivar
