// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/proportional.h"

#include "core/placement/box_volume.h"
#include "core/placement/shifting.h"
#include "editor/hands/point_choice.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

TEST(Falloffs, FallFromAllToNothingAndNeverRise)
{
    for (int kind = 0; kind < static_cast<int>(falloff_names.size()); ++kind) {
        const auto at = [&](double x) { return falloff(static_cast<Falloff>(kind), x); };
        EXPECT_EQ(at(0), 1);
        EXPECT_EQ(at(1), 0);
        for (double x = 0; x < 1.2; x += 0.01) EXPECT_GE(at(x), at(x + 0.01));
    }
}

// Where 5 x 5 x 5 points over a cube go by a shift with its neighbours.
Lattice shifted(const PointShift& shift)
{
    const Lattice cube = place_box(glm::dvec3(1), glm::ivec3(5), glm::ivec3(4)).volume;
    return moved(cube, moves_of(cube, with_neighbours(shift, by_distance(cube, shift),
                                                      Falloff::smooth, 0.8)));
}

void expect_mirrored(const Lattice& volume)
{
    for (const glm::ivec3& p : all_points(point_count(volume))) {
        const glm::dvec3 here = control_point(volume, p.x, p.y, p.z),
                         there = control_point(volume, 4 - p.x, p.y, p.z);
        EXPECT_LT(glm::length(there - here * glm::dvec3(-1, 1, 1)), 1e-12);
    }
}

TEST(ProportionalEditing, KeepsBothSidesAlikeWhereItMirrors)
{
    expect_mirrored(shifted({.points = {{3, 2, 4}}, .by = {0.1, 0.05, 0.2}, .mirror_along = true}));
}

TEST(ProportionalEditing, KeepsBothSidesAlikeFromThePointsInTheMiddle)
{
    expect_mirrored(shifted({.points = {{2, 2, 4}}, .by = {0.1, 0.05, 0.2}, .mirror_along = true}));
}

TEST(ProportionalEditing, ReachesNothingBeyondItsRadius)
{
    const Lattice volume = shifted({.points = {{0, 0, 0}}, .by = {0.1, 0, 0}});
    EXPECT_LT(glm::length(control_point(volume, 4, 4, 4) - glm::dvec3(0.5)), 1e-12);
    EXPECT_GT(control_point(volume, 1, 0, 0).x, -0.25);
}

TEST(PointChoice, KnowsRowsPlanesTheNextOnesAndTheirNumbers)
{
    const glm::ivec3 n(4, 5, 6), p(1, 2, 3);
    EXPECT_EQ(row_of(p, 2, n).size(), 6u);
    EXPECT_EQ(plane_of(p, 2, n).size(), 20u);
    const Points all = all_points(n);
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_EQ(number_of(all[i], n), static_cast<int>(i));
        EXPECT_EQ(point_of(static_cast<int>(i), n), all[i]);
    }
    EXPECT_EQ(with_next({p}, n).size(), 7u);
    EXPECT_EQ(with_next({{0, 0, 0}}, n).size(), 4u);
}

} // namespace
} // namespace trivar
