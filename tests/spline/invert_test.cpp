// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spline/invert.h"

#include "core/base/rejected.h"
#include "core/spline/cell_search.h"
#include "core/spline/fit.h"
#include "tests/support/splines.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

using testing::Noise;
using testing::random_volume;

// A bar bent through `angle` radians, 1 wide at its middle radius, its control points shaken.
Trivariate<glm::dvec3> bent_bar(double angle, double noise_share, int order)
{
    const std::array<Knots, 3> axes{Knots::uniform(order, 9), Knots::uniform(order, order + 1),
                                    Knots::uniform(order, order + 1)};
    Trivariate<glm::dvec3> f{axes, {}};
    Noise noise;
    for (int i = 0; i < axes[0].count(); ++i)
        for (int j = 0; j < axes[1].count(); ++j)
            for (int k = 0; k < axes[2].count(); ++k) {
                const double turn = angle * axes[0].greville(i);
                const double radius = 1 + 0.6 * axes[2].greville(k);
                f.points.push_back(glm::dvec3(radius * std::cos(turn), axes[1].greville(j),
                                              radius * std::sin(turn)) +
                                   noise_share * noise.vec3());
            }
    return f;
}

double diagonal(const Trivariate<glm::dvec3>& f)
{
    Box all;
    for (const glm::dvec3& p : f.points) all.add(p);
    return glm::distance(all.lo, all.hi);
}

TEST(Inversion, FindsEveryPointOfAStronglyBentShakenVolume)
{
    for (const int order : {2, 3, 4, 6}) {
        const auto f = bent_bar(4.5, 0.02, order);
        const Inverter inverse(f);
        const double size = diagonal(f);
        Noise noise(7);
        for (int i = 0; i < 10000; ++i) {
            const glm::dvec3 q = noise.vec3() * 0.5 + 0.5;
            const glm::dvec3 p = evaluate(f, q).value;
            const Located at = inverse.locate(p);
            ASSERT_EQ(at.status, Located::Status::found) << order << " " << i;
            ASSERT_LT(glm::distance(evaluate(f, at.uvw).value, p), 1e-10 * size);
            ASSERT_LT(at.residual, 1e-12 * size);
        }
    }
}

TEST(Inversion, FindsPointsOnTheFacesAndCorners)
{
    const auto f = bent_bar(2, 0.02, 3);
    const Inverter inverse(f);
    Noise noise;
    for (int i = 0; i < 300; ++i) {
        glm::dvec3 q = noise.vec3() * 0.5 + 0.5;
        for (int a = 0; a <= i % 3; ++a) q[(i + a) % 3] = i / 3 % 2;
        const glm::dvec3 p = evaluate(f, q).value;
        const Located at = inverse.locate(p);
        ASSERT_EQ(at.status, Located::Status::found);
        EXPECT_LT(glm::distance(evaluate(f, at.uvw).value, p), 1e-11);
    }
}

TEST(Inversion, OfAnAffineVolumeIsTheInverseMap)
{
    const Knots k = Knots::uniform(4, 6);
    Trivariate<glm::dvec3> f{{k, k, k}, {}};
    const glm::dmat3 map(glm::dvec3(3, 0, 1), glm::dvec3(0, 2, 0), glm::dvec3(-1, 0, 1));
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j)
            for (int l = 0; l < 6; ++l)
                f.points.push_back(map * glm::dvec3(k.greville(i), k.greville(j), k.greville(l)));
    const Inverter inverse(f);
    Noise noise;
    for (int i = 0; i < 100; ++i) {
        const glm::dvec3 q = noise.vec3() * 0.5 + 0.5;
        EXPECT_LT(glm::distance(inverse.locate(map * q).uvw, q), 1e-11);
    }
}

TEST(Inversion, SaysHowFarAPointOutsideIs)
{
    const Knots k = Knots::uniform(3, 4);
    Trivariate<glm::dvec3> cube{{k, k, k}, {}};
    for (int i = 0; i < 64; ++i)
        cube.points.emplace_back(k.greville(i / 16), k.greville(i / 4 % 4), k.greville(i % 4));
    const Inverter inverse(cube);
    Noise noise;
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 p = 3.0 * noise.vec3() + 0.5;
        const glm::dvec3 foot = glm::clamp(p, glm::dvec3(0), glm::dvec3(1));
        const Located at = inverse.locate(p);
        EXPECT_NEAR(at.residual, glm::distance(p, foot), 1e-9);
        EXPECT_EQ(at.status, p == foot ? Located::Status::found : Located::Status::outside);
        EXPECT_LT(glm::distance(at.uvw, foot), 1e-6);
    }
}

TEST(Inversion, OfABentBarFindsTheNearestPointOfItsHollow)
{
    const auto f = bent_bar(2.5, 0, 4);
    const Inverter inverse(f);
    const glm::dvec3 p(0.2, 0.5, 0.3);
    const Located at = inverse.locate(p);
    EXPECT_EQ(at.status, Located::Status::outside);
    double least = 1e300;
    for (int i = 0; i <= 40; ++i)
        for (int j = 0; j <= 40; ++j)
            for (int k = 0; k <= 10; ++k)
                least = std::min(
                    least, glm::distance(p, evaluate(f, {i / 40.0, j / 40.0, k / 10.0}).value));
    EXPECT_LE(at.residual, least + 1e-12);
    EXPECT_GT(at.residual, least - 0.02);
}

// A sheet folded over itself along u: x = (2u - 1)^2 has two preimages for every x > 0.
TEST(Inversion, ReportsAllPreimagesOfAFold)
{
    const Knots u = Knots::uniform(3, 5), k = Knots::uniform(2, 2);
    std::vector<glm::dvec3> values;
    for (const double s : greville_sites(u))
        for (const double t : {0.0, 1.0})
            for (const double w : {0.0, 1.0}) values.emplace_back((2 * s - 1) * (2 * s - 1), t, w);
    const Inverter inverse(interpolate({u, k, k}, values));
    const auto both = inverse.locate_all({0.36, 0.5, 0.25});
    ASSERT_EQ(both.size(), 2u);
    EXPECT_NEAR(both[0].uvw.x, 0.2, 1e-10);
    EXPECT_NEAR(both[1].uvw.x, 0.8, 1e-10);
    EXPECT_NEAR(inverse.locate({0.36, 0.5, 0.25}, glm::dvec3(0.7, 0.5, 0.5)).uvw.x, 0.8, 1e-10);
    EXPECT_NEAR(inverse.locate({0.36, 0.5, 0.25}, glm::dvec3(0.3, 0.5, 0.5)).uvw.x, 0.2, 1e-10);
    EXPECT_EQ(inverse.locate_all({0.0, 0.5, 0.25}).size(), 1u) << "on the fold itself";
    EXPECT_TRUE(inverse.locate_all({-0.1, 0.5, 0.25}).empty());
}

TEST(Inversion, CountsTheSeamOfARingOnce)
{
    const Knots round = Knots::periodic(4, 12), k = Knots::uniform(2, 2);
    Trivariate<glm::dvec3> ring{{round, k, k}, {}};
    for (int i = 0; i < 12; ++i)
        for (int j = 0; j < 2; ++j)
            for (int l = 0; l < 2; ++l) {
                const double turn = 2 * 3.14159265358979 * round.greville(i), r = 2 + j;
                ring.points.emplace_back(r * std::cos(turn), r * std::sin(turn), l);
            }
    const Inverter inverse(ring);
    const glm::dvec3 p = evaluate(ring, {0, 0.4, 0.6}).value;
    const auto found = inverse.locate_all(p);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_LT(glm::distance(evaluate(ring, found[0].uvw).value, p), 1e-11);
}

TEST(Inversion, ReachesBothSidesOfATear)
{
    const Knots torn = Knots::general(2, {0, 0, 0.5, 0.5, 1, 1}), k = Knots::uniform(2, 2);
    Trivariate<glm::dvec3> f{{torn, k, k}, {}};
    for (const double x : {0.0, 1.0, 2.0, 3.0})
        for (int j = 0; j < 2; ++j)
            for (int l = 0; l < 2; ++l) f.points.emplace_back(x, j, l);
    const Inverter inverse(f);
    EXPECT_NEAR(inverse.locate({0.5, 0.5, 0.5}).uvw.x, 0.25, 1e-12);
    EXPECT_NEAR(inverse.locate({2.5, 0.5, 0.5}).uvw.x, 0.75, 1e-12);
    EXPECT_EQ(inverse.locate({1, 0.5, 0.5}).status, Located::Status::found);
    EXPECT_EQ(inverse.locate({1.5, 0.5, 0.5}).status, Located::Status::outside);
    EXPECT_NEAR(inverse.locate({1.4, 0.5, 0.5}).residual, 0.4, 1e-9);
}

TEST(Inversion, OfCollapsedVolumesAndBadPointsIsAStatusNotACrash)
{
    const Knots k = Knots::uniform(3, 3);
    const Trivariate<glm::dvec3> point{{k, k, k}, std::vector<glm::dvec3>(27, glm::dvec3(1))};
    const Inverter inverse(point);
    EXPECT_EQ(inverse.locate({2, 1, 1}).status, Located::Status::outside);
    EXPECT_NEAR(inverse.locate({2, 1, 1}).residual, 1, 1e-12);
    EXPECT_EQ(inverse.locate(glm::dvec3(1)).status, Located::Status::found);
    EXPECT_EQ(inverse.locate(glm::dvec3(std::nan(""))).status, Located::Status::not_converged);
    auto broken = point;
    broken.points[3].y = std::nan("");
    EXPECT_THROW(Inverter{broken}, Rejected);
    broken.points.pop_back();
    EXPECT_THROW(Inverter{broken}, Rejected);
}

TEST(BezierCells, HoldTheirPieceInTheirBoxAndAgreeWithTheMap)
{
    const auto f =
        random_volume({testing::uneven_knots(3), Knots::periodic(4, 5), Knots::uniform(6, 7)});
    Noise noise;
    for (const BezierCell& cell : bezier_cells(f)) {
        const Box box = bounds(cell);
        const BezierCell part = part_of(cell, {0.2, 0.5, 0}, {0.7, 1, 0.3});
        for (int i = 0; i < 20; ++i) {
            const glm::dvec3 x = noise.vec3() * 0.5 + 0.5;
            const glm::dvec3 uvw = glm::mix(cell.lo, cell.hi, x);
            const CellValue c = evaluate(cell, x);
            const auto jet = evaluate(f, uvw, 1);
            EXPECT_LT(glm::distance(c.value, jet.value), 1e-13);
            EXPECT_LT(box.distance(c.value), 1e-14);
            for (int a = 0; a < 3; ++a)
                EXPECT_LT(glm::distance(c.jacobian[a] / (cell.hi - cell.lo)[a],
                                        jet.first[static_cast<std::size_t>(a)]),
                          1e-11);
            EXPECT_LT(glm::distance(evaluate(part, x).value,
                                    evaluate(f, glm::mix(part.lo, part.hi, x)).value),
                      1e-13);
        }
    }
}

TEST(BoxTree, FindsWhatASearchOfAllBoxesFinds)
{
    Noise noise;
    std::vector<Box> boxes(200);
    for (Box& b : boxes) {
        const glm::dvec3 p = 5.0 * noise.vec3();
        b.add(p);
        b.add(p + noise.vec3());
    }
    const BoxTree tree(boxes);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 p = 6.0 * noise.vec3();
        double least = 1e300;
        std::vector<int> near;
        for (std::size_t b = 0; b < boxes.size(); ++b) {
            least = std::min(least, boxes[b].distance(p));
            if (boxes[b].distance(p) <= 1) near.push_back(static_cast<int>(b));
        }
        EXPECT_EQ(tree.distance(p), least);
        EXPECT_EQ(tree.near(p, 1), near);
    }
    EXPECT_TRUE(BoxTree(std::vector<Box>{}).near({0, 0, 0}, 1).empty());
}

} // namespace
} // namespace trivar
