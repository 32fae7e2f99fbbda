// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/placement/shifting.h"

#include "core/placement/box_volume.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

// 4 x 4 x 4 points over -1..1 along X, Y and Z.
Lattice cube()
{
    return place_box(glm::dvec3(2), glm::ivec3(4), glm::ivec3(2)).volume;
}

// Where a shift takes a point.
glm::dvec3 goes(const PointShift& shift, const glm::ivec3& p)
{
    const Lattice before = cube();
    const Lattice after = moved(before, moves_of(before, shift));
    return control_point(after, p.x, p.y, p.z);
}

constexpr glm::ivec3 p00(0, 0, 3), p10(3, 0, 3), p11(3, 3, 3), p01(0, 3, 3); // the upper corners

void expect_near(const glm::dvec3& is, const glm::dvec3& wanted)
{
    EXPECT_LT(glm::length(is - wanted), 1e-12) << is.x << ' ' << is.y << ' ' << is.z;
}

TEST(Shifting, MovesEachPointByItsShare)
{
    const PointShift shift{.points = {p00, p10}, .by = {0, 0, 1}, .weights = {1, 0.25}};
    expect_near(goes(shift, p00), {-1, -1, 2});
    expect_near(goes(shift, p10), {1, -1, 1.25});
    expect_near(goes(shift, p11), {1, 1, 1});
}

TEST(Shifting, TurnsPointsAboutTheirMiddle)
{
    const PointShift shift{.points = {p00, p10, p11, p01}, .rotation_deg = {0, 0, 90}};
    expect_near(goes(shift, p00), {1, -1, 1});
    expect_near(goes(shift, p10), {1, 1, 1});
}

TEST(Shifting, TurnsByAShareOfTheAngle)
{
    const PointShift shift{
        .points = {p00, p11, p10}, .weights = {1, 1, 0.5}, .rotation_deg = {0, 0, 90}};
    expect_near(goes(shift, p10), {std::sqrt(2), 0, 1}); // about the middle of the first two
}

TEST(Shifting, ScalesPointsAboutTheirMiddle)
{
    const PointShift shift{.points = {p00, p10, p11, p01}, .factors = {0.5, 2, 7}};
    expect_near(goes(shift, p00), {-0.5, -2, 1});
}

TEST(Shifting, MirrorsAlongEveryAxisThatIsAskedFor)
{
    const PointShift shift{
        .points = {p11}, .by = {1, 2, 3}, .mirror = true, .mirror_along = true, .mirror_up = true};
    for (const double x : {-1, 1})
        for (const double y : {-1, 1})
            for (const double z : {-1, 1}) {
                const glm::ivec3 p(x > 0 ? 3 : 0, y > 0 ? 3 : 0, z > 0 ? 3 : 0);
                expect_near(goes(shift, p), {2 * x, 3 * y, 4 * z});
            }
}

TEST(Shifting, TurnsMirroredPointsTheOtherWay)
{
    const PointShift shift{.points = {p10, p11}, .rotation_deg = {0, 90, 0}, .mirror_along = true};
    const PointShift along{.points = {p10, p11, {3, 0, 2}, {3, 3, 2}},
                           .rotation_deg = {0, 90, 0},
                           .mirror_along = true};
    expect_near(goes(shift, p10), {1, -1, 1}); // they lie on the axis itself
    const glm::dvec3 right = goes(along, p10), left = goes(along, p00);
    EXPECT_GT(glm::length(right - glm::dvec3(1, -1, 1)), 0.1);
    expect_near(left, right * glm::dvec3(-1, 1, 1));
}

} // namespace
} // namespace trivar
