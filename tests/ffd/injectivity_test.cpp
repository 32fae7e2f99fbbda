// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/spline/fit.h"
#include "tests/ffd/folds.h"
#include "tests/ffd/samples.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;

std::array<Knots, 3> axes(int order, int count)
{
    const Knots knots = Knots::uniform(order, count);
    return {knots, knots, knots};
}

// The box bent round an axis with curvature kappa at w = 1/2; det J = 1 - kappa (w - 1/2).
Lattice cylinder_bend(double kappa)
{
    const std::array<Knots, 3> a{Knots::uniform(4, 24), Knots::uniform(2, 2), Knots::uniform(2, 2)};
    std::vector<glm::dvec3> values;
    for (int i = 0; i < 24; ++i)
        for (int j = 0; j < 2; ++j)
            for (int k = 0; k < 2; ++k) {
                const double u = a[0].greville(i), r = 1 / kappa - (k - 0.5);
                values.emplace_back(r * std::sin(kappa * u), j,
                                    1 / kappa - r * std::cos(kappa * u));
            }
    return lattice_through(interpolate(a, values));
}

TEST(Injectivity, KnowsTheJacobianOfACylinderBend)
{
    const double kappa = 1.6;
    const Lattice lattice = cylinder_bend(kappa);
    for (const double u : {0.05, 0.31, 0.77})
        for (const double w : {0.0, 0.4, 1.0}) {
            const Jet<glm::dvec3> f = evaluate(lattice, {u, 0.3, w}, 1);
            const double det = glm::determinant(glm::dmat3(f.first[0], f.first[1], f.first[2]));
            EXPECT_NEAR(det, 1 - kappa * (w - 0.5), 1e-4); // interpolation error of the slope
        }
    EXPECT_NEAR(smallest_jacobian(lattice, 3), 1 - kappa / 2, 1e-4);
    EXPECT_EQ(verdict_of(lattice), Verdict::proven_good);
}

TEST(Injectivity, FindsTheFoldOfABendTighterThanItsHeight)
{
    const Lattice lattice = cylinder_bend(2.5); // folds where w > 1/2 + 1/2.5 = 0.9
    EXPECT_NEAR(smallest_jacobian(lattice, 3), 1 - 2.5 / 2, 1e-3);
    EXPECT_EQ(verdict_of(lattice), Verdict::proven_bad);
}

TEST(Injectivity, ProvesALatticeAtRestGoodAlsoWhenItMirrors)
{
    glm::dmat4 mirror = some_affine_map();
    mirror[0] = -mirror[0];
    for (const glm::dmat4& rest : {some_affine_map(), mirror})
        for (const int order : {2, 3, 4, 6}) {
            EXPECT_EQ(verdict_of(lattice_at_rest(axes(order, 7), rest)), Verdict::proven_good);
        }
}

// A certificate must never be contradicted by a sample.
TEST(Injectivity, NeverProvesWhatSamplesRefute)
{
    int good = 0, bad = 0;
    for (unsigned seed = 1; seed <= 12; ++seed)
        for (const double size : {0.03, 0.08, 0.3}) {
            const Lattice lattice =
                random_lattice(axes(3 + static_cast<int>(seed % 2), 6), size, seed);
            const Verdict verdict = verdict_of(lattice);
            const bool proven = verdict == Verdict::proven_good;
            EXPECT_TRUE(!proven || smallest_jacobian(lattice, 6) > 0);
            good += proven;
            bad += verdict == Verdict::proven_bad;
        }
    EXPECT_GT(good, 5);
    EXPECT_GT(bad, 5);
}

TEST(Injectivity, DoesNotClaimToKnowACollapsedLattice)
{
    Lattice lattice = lattice_at_rest(axes(3, 4), glm::dmat4(1));
    for (int j = 0; j < 4; ++j)
        for (int k = 0; k < 4; ++k) // the face u = 0 becomes a line
            lattice.displacement.points[lattice.displacement.index(0, j, k)].y =
                -lattice.displacement.axes[1].greville(j);
    EXPECT_EQ(verdict_of(lattice), Verdict::unknown);
    lattice.displacement.points[5].x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(verdict_of(lattice), Verdict::unknown);
}

TEST(Injectivity, ChecksARingAcrossItsSeam)
{
    const double pi = 3.141592653589793;
    const std::array<Knots, 3> a{Knots::periodic(3, 12), Knots::uniform(2, 2),
                                 Knots::uniform(2, 2)};
    Trivariate<glm::dvec3> points{a, {}};
    for (int i = 0; i < 12; ++i)
        for (int j = 0; j < 2; ++j)
            for (int k = 0; k < 2; ++k)
                points.points.emplace_back((2.0 - k) * std::cos(pi * i / 6),
                                           (2.0 - k) * std::sin(pi * i / 6), j);
    Lattice ring = lattice_through(points);
    EXPECT_EQ(verdict_of(ring), Verdict::proven_good);
    ring.displacement.points[ring.displacement.index(11, 0, 0)] *= -0.2;
    EXPECT_EQ(verdict_of(ring), Verdict::proven_bad);
}

} // namespace
} // namespace trivar
