// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/parted_cells.h"

#include "core/base/rejected.h"
#include "tests/simplex/domain_shapes.h"

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
    EXPECT_EQ(parted_cells(parting).mesh, cells.mesh);
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
