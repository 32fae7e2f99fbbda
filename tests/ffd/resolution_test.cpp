// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/ffd/resolution.h"
#include "tests/ffd/samples.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;

// A lattice with the axis, of the same or another closure than the others, along u.
Lattice with_axis(const Knots& axis)
{
    Lattice out =
        random_lattice({axis, Knots::uniform(3, 5, -1, 2), Knots::uniform(4, 6, 0, 3)}, 0.4, 5);
    out.rest = some_affine_map();
    return out;
}

double largest_sampled_difference(const Lattice& a, const Lattice& b)
{
    double most = 0;
    for (const double u : inside(a.displacement.axes[0], 41))
        for (const double v : inside(a.displacement.axes[1], 7))
            for (const double w : inside(a.displacement.axes[2], 7))
                most = std::max(most, glm::distance(evaluate(a, {u, v, w}).value,
                                                    evaluate(b, {u, v, w}).value));
    return most;
}

TEST(Resolution, KnotsGoInWithoutMovingAPointOnAxesOfEveryOrderAndKind)
{
    for (const Knots& axis : all_axes()) {
        const Lattice lattice = with_axis(axis);
        const double length = axis.end() - axis.begin();
        AxisKnots knots;
        knots[0] = {axis.begin() + 0.37 * length, axis.begin() + 0.5 * length};
        knots[1] = {-0.3};
        const Lattice finer = refined(lattice, knots);
        EXPECT_EQ(finer.displacement.axes[0].count(), axis.count() + 2);
        const bool mirrored = axis.closure() == Closure::twisted;
        EXPECT_EQ(finer.displacement.axes[1].count(), mirrored ? 7 : 6);
        EXPECT_LT(largest_sampled_difference(lattice, finer), 1e-12);
        EXPECT_LT(largest_difference(lattice, finer), 1e-12);
        EXPECT_GE(largest_difference(lattice, finer),
                  largest_sampled_difference(lattice, finer) / 8);
    }
}

TEST(Resolution, BoundsTheDifferenceFromAbove)
{
    for (const Knots& axis : all_axes()) {
        const Lattice lattice = with_axis(axis);
        const PointMove move{{1, 2, 2}, {0.3, -0.1, 0.2}};
        const Lattice other = moved(lattice, std::span(&move, 1));
        EXPECT_GE(largest_difference(lattice, other), largest_sampled_difference(lattice, other));
        EXPECT_LE(largest_difference(lattice, other), glm::length(move.by) * 1.001);
    }
}

TEST(Resolution, CoarseningSaysHowFarItIsOff)
{
    for (const Knots& axis : all_axes()) {
        const Lattice lattice = with_axis(axis);
        if (axis.count() == axis.order()) continue;
        const CoarserLattice out = coarsened(lattice, 0, axis.count() - 1);
        EXPECT_EQ(out.lattice.displacement.axes[0].count(), axis.count() - 1);
        EXPECT_GE(out.deviation, largest_sampled_difference(lattice, out.lattice));
        EXPECT_LT(out.deviation, 4); // of displacements up to 0.7
    }
}

TEST(Resolution, CoarseningTakesBackWhatWasRefined)
{
    for (const Closure closure : {Closure::open, Closure::periodic, Closure::twisted}) {
        const Knots axis =
            closure == Closure::open ? Knots::uniform(4, 9) : Knots::periodic(4, 9, 0, 1, closure);
        const Lattice lattice = with_axis(axis);
        AxisKnots middles;
        const std::vector<double> breaks = axis.breaks();
        for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
            middles[0].push_back((breaks[i] + breaks[i + 1]) / 2);
        const CoarserLattice out = coarsened(refined(lattice, middles), 0, 9);
        EXPECT_LT(out.deviation, 1e-11);
        EXPECT_LT(largest_difference(lattice, out.lattice), 1e-11);
    }
}

TEST(Resolution, CoarseningKeepsTheLayersAtClampedEnds)
{
    const Lattice lattice = with_axis(Knots::uniform(4, 12));
    const Lattice out = coarsened(lattice, 2, 4).lattice;
    for (int i = 0; i < 12; ++i)
        for (int j = 0; j < 5; ++j)
            EXPECT_LT(glm::distance(control_point(lattice, i, j, 0), control_point(out, i, j, 0)),
                      1e-12);
}

TEST(Resolution, RefusesWhatCannotBe)
{
    const Lattice lattice = with_axis(Knots::uniform(4, 6));
    EXPECT_THROW(coarsened(lattice, 0, 3), Rejected);
    EXPECT_THROW(coarsened(lattice, 0, 6), Rejected);
    AxisKnots outside;
    outside[0] = {1.5};
    EXPECT_THROW(refined(lattice, outside), Rejected);
}

// The most control points of one line along an axis that lie in a sphere.
int most_in_sphere(const Lattice& lattice, int axis, const glm::dvec3& center, double radius)
{
    std::map<std::pair<int, int>, int> lines;
    const auto& axes = lattice.displacement.axes;
    for (int i = 0; i < axes[0].count(); ++i)
        for (int j = 0; j < axes[1].count(); ++j)
            for (int k = 0; k < axes[2].count(); ++k)
                if (glm::distance(control_point(lattice, i, j, k), center) <= radius)
                    ++lines[axis == 0   ? std::pair(j, k)
                            : axis == 1 ? std::pair(i, k)
                                        : std::pair(i, j)];
    int most = 0;
    for (const auto& line : lines) most = std::max(most, line.second);
    return most;
}

TEST(Resolution, PutsExactMirrorImagesInBesideATwistedAxis)
{
    const Lattice band = random_lattice(
        {Knots::periodic(3, 8, 0, 1, Closure::twisted), Knots::uniform(3, 6), Knots::uniform(3, 4)},
        0.01);
    const AxisKnots all = with_images(band, {{{0.1}, {0.3, 0.7000000001, 0.2, 0.2, 0.8}, {0.5}}});
    EXPECT_EQ(all[0], std::vector{0.1});
    ASSERT_EQ(all[1].size(), 6u);
    for (const double t : all[1])
        EXPECT_EQ(std::ranges::count(all[1], 1 - t), t < 0.25 || t > 0.75 ? 2 : 1);
    EXPECT_EQ(all[2], std::vector{0.5});
    EXPECT_LT(largest_difference(band, refined(band, all)), 1e-12);
}

TEST(Resolution, PutsThreePointsAcrossASphere)
{
    Lattice lattice =
        random_lattice({Knots::uniform(4, 8), Knots::uniform(3, 6), Knots::uniform(2, 3)}, 0.01);
    lattice.rest = some_affine_map();
    for (const glm::dvec3 uvw : {glm::dvec3(0.5), glm::dvec3(0.31, 0.72, 0.4)})
        for (const double radius : {0.6, 0.15, 0.04}) {
            const glm::dvec3 center = evaluate(lattice, uvw).value;
            const Lattice finer = refined(lattice, knots_for_sphere(lattice, center, radius));
            for (int axis = 0; axis < 3; ++axis)
                EXPECT_GE(most_in_sphere(finer, axis, center, radius), 3);
            EXPECT_LT(largest_difference(lattice, finer), 1e-12);
        }
    const AxisKnots none = knots_for_sphere(lattice, evaluate(lattice, {0.5, 0.5, 0.5}).value, 5);
    EXPECT_TRUE(none[0].empty() && none[1].empty() && none[2].empty());
}

} // namespace
} // namespace trivar
