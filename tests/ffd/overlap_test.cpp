// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/guard.h"
#include "core/ffd/overlap.h"
#include "tests/ffd/folds.h"
#include "tests/ffd/samples.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;

// Control points at places told by their Greville abscissae.
template <class Place> Lattice lattice_of(const std::array<Knots, 3>& axes, const Place& place)
{
    Trivariate<glm::dvec3> points{axes, {}};
    for (int i = 0; i < axes[0].count(); ++i)
        for (int j = 0; j < axes[1].count(); ++j)
            for (int k = 0; k < axes[2].count(); ++k)
                points.points.push_back(
                    place(axes[0].greville(i), axes[1].greville(j), axes[2].greville(k)));
    return lattice_through(points);
}

constexpr double pi = 3.141592653589793;

// A strip of width 0.5 and height 0.2 that goes round by an angle while it rises.
Lattice ramp(double angle, double rise, double height, int order = 4)
{
    return lattice_of({Knots::uniform(order, 24), Knots::uniform(3, 3), Knots::uniform(2, 2)},
                      [&](double u, double v, double w) {
                          const double r = 1 + 0.5 * v;
                          return glm::dvec3(r * std::sin(angle * u), -r * std::cos(angle * u),
                                            rise * u + height * w);
                      });
}

void expect_witness(const Lattice& lattice, const Overlap& out)
{
    ASSERT_EQ(out.verdict, Verdict::proven_bad);
    EXPECT_LT(glm::distance(evaluate(lattice, out.one).value, evaluate(lattice, out.other).value),
              1e-10);
    EXPECT_GT(glm::distance(out.one, out.other), 0.05);
}

TEST(Overlap, OfNothingInALatticeAtRest)
{
    const Knots axis = Knots::uniform(4, 7);
    EXPECT_EQ(overlap(lattice_at_rest({axis, axis, axis}, some_affine_map())).verdict,
              Verdict::proven_good);
}

TEST(Overlap, IsFoundWhereABendRunsIntoItself)
{
    for (const int order : {2, 3, 4}) {
        EXPECT_EQ(overlap(ramp(1.8 * pi, 0, 0.2, order)).verdict, Verdict::proven_good);
        const Lattice closed = ramp(2.3 * pi, 0, 0.2, order);
        ASSERT_TRUE(judge(closed).good()); // locally nothing is wrong with it
        expect_witness(closed, overlap(closed));
    }
}

// The thesis says that a surface which does not meet itself, thickened along an axis it is nowhere
// tangent to, makes a volume that does not: a ramp lower than its height does.
TEST(Overlap, IsFoundInARampLowerThanItsHeight)
{
    EXPECT_EQ(overlap(ramp(4 * pi, 2, 0.8)).verdict, Verdict::proven_good);
    const Lattice high = ramp(4 * pi, 2, 1.2);
    ASSERT_TRUE(judge(high).good());
    expect_witness(high, overlap(high));
}

TEST(Overlap, OfARingAcrossItsSeamIsNone)
{
    for (const Closure closure : {Closure::periodic, Closure::twisted}) {
        const double half = closure == Closure::twisted ? 0.5 : 0;
        const Lattice ring = lattice_of(
            {Knots::periodic(3, 16, 0, 1, closure), Knots::uniform(3, 4), Knots::uniform(2, 2)},
            [&](double u, double v, double w) {
                const double turn = 2 * pi * u, lean = half * turn;
                const glm::dvec2 across(v - 0.5, 0.3 * (w - 0.5));
                const glm::dvec2 leaning(across.x * std::cos(lean) - across.y * std::sin(lean),
                                         across.x * std::sin(lean) + across.y * std::cos(lean));
                const double r = 2 + leaning.x;
                return glm::dvec3(r * std::cos(turn), r * std::sin(turn), leaning.y);
            });
        ASSERT_TRUE(judge(ring).good());
        EXPECT_EQ(overlap(ring).verdict, Verdict::proven_good);
    }
}

TEST(Overlap, OfATorusShellIsNoneAndOfTwoRoundsIsAll)
{
    for (const double rounds : {1.0, 2.0}) {
        const Lattice shell =
            lattice_of({Knots::periodic(3, 16), Knots::periodic(3, 10), Knots::uniform(2, 2)},
                       [&](double u, double v, double w) {
                           const double a = 2 * pi * u * rounds, b = 2 * pi * v, r = 0.5 + 0.2 * w;
                           return glm::dvec3((2 + r * std::cos(b)) * std::cos(a),
                                             (2 + r * std::cos(b)) * std::sin(a), r * std::sin(b));
                       });
        ASSERT_TRUE(judge(shell).good());
        const Overlap out = overlap(shell);
        EXPECT_EQ(out.verdict, rounds == 1 ? Verdict::proven_good : Verdict::proven_bad);
    }
}

TEST(Overlap, IsNotDeniedWhereAVolumeFoldsJumpsOrTouchesItself)
{
    Lattice folded = lattice_at_rest(
        {Knots::uniform(3, 6), Knots::uniform(3, 6), Knots::uniform(3, 6)}, glm::dmat4(1));
    folded.displacement.points[folded.displacement.index(2, 3, 3)].x += 0.9;
    EXPECT_NE(overlap(folded).verdict, Verdict::proven_good);
    const Knots torn = Knots::general(3, {0, 0, 0, 0.5, 0.5, 0.5, 1, 1, 1});
    EXPECT_EQ(
        overlap(lattice_at_rest({torn, Knots::uniform(3, 4), Knots::uniform(3, 4)}, glm::dmat4(1)))
            .verdict,
        Verdict::unknown);
    folded.displacement.points[3].y = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(overlap(folded).verdict, Verdict::unknown);
}

TEST(Overlap, IsNeverProvenToBeNoneWhereTheVolumeFolds)
{
    const Knots axis = Knots::uniform(3, 6);
    int good = 0;
    for (unsigned seed = 1; seed <= 10; ++seed) {
        const Lattice lattice = random_lattice({axis, axis, axis}, 0.02 + 0.005 * seed, seed);
        const Verdict verdict = overlap(lattice).verdict;
        EXPECT_TRUE(verdict != Verdict::proven_good || smallest_jacobian(lattice, 5) > 0);
        good += verdict == Verdict::proven_good;
    }
    EXPECT_GT(good, 3);
}

} // namespace
} // namespace trivar
