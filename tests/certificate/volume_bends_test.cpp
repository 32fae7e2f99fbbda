// SPDX-License-Identifier: GPL-3.0-or-later
// How much volumes bend, against samples of the map itself.
#include "core/certificate/volume_bends.h"

#include "tests/ffd/samples.h"

#include <gtest/gtest.h>
#include <random>

namespace trivar {
namespace {

class BendsOfVolumes : public ::testing::TestWithParam<int> { // by the order of the axes
protected:
    std::mt19937 dice_{static_cast<unsigned>(GetParam())};
    double share() { return std::uniform_real_distribution<double>(0, 1)(dice_); }
    glm::dvec3 point() { return {share(), share(), share()}; }
    Lattice lattice_ =
        testing::random_lattice({Knots::uniform(GetParam(), 6), Knots::uniform(GetParam(), 5),
                                 Knots::uniform(GetParam(), 7)},
                                0.3, static_cast<unsigned>(GetParam()));
    VolumeBends bends_{lattice_};
    glm::dvec3 at(const glm::dvec3& uvw) const { return evaluate(lattice_, uvw).value; }
};

TEST_P(BendsOfVolumes, BoundHowFarStraightLinesComeToLieFromTheirChords)
{
    double furthest = 0, bound_there = 0;
    for (int round = 0; round < 300; ++round) {
        const glm::dvec3 a = point(), b = glm::mix(a, point(), share());
        Box box;
        box.add(a);
        box.add(b);
        const double bound = bends_.over(box).off_chord(glm::abs(b - a));
        for (int i = 1; i < 16; ++i) {
            const double t = i / 16.0;
            const double off = glm::distance(at(glm::mix(a, b, t)), glm::mix(at(a), at(b), t));
            EXPECT_LE(off, bound + 1e-12) << round;
            if (off > furthest) furthest = off, bound_there = bound;
        }
    }
    EXPECT_GT(furthest, 0.01) << "they bend";
    EXPECT_LT(bound_there, 100 * furthest) << "and it says something";
}

TEST_P(BendsOfVolumes, BoundHowFarTrianglesComeToLieFromThePlaneOfTheirCorners)
{
    for (int round = 0; round < 200; ++round) {
        const glm::dvec3 a = point(), p = 0.3 * (point() - a), q = 0.3 * (point() - a);
        Box box;
        for (const glm::dvec3& corner : {a, a + p, a + q}) box.add(corner);
        const double bound = bends_.over(box).off_triangle(glm::abs(p), glm::abs(q));
        for (int i = 0; i < 10; ++i) {
            double s = share(), t = share();
            if (s + t > 1) s = 1 - s, t = 1 - t;
            const glm::dvec3 flat = (1 - s - t) * at(a) + s * at(a + p) + t * at(a + q);
            EXPECT_LE(glm::distance(at(a + s * p + t * q), flat), bound + 1e-12) << round;
        }
    }
}

TEST_P(BendsOfVolumes, KnowNoDerivativeThatIsGreater)
{
    for (int round = 0; round < 200; ++round) {
        const auto first = evaluate(lattice_, point(), 1).first;
        for (int a = 0; a < 3; ++a)
            EXPECT_LE(glm::length(first[static_cast<std::size_t>(a)]), bends_.slopes()[a] + 1e-12);
    }
}

TEST_P(BendsOfVolumes, AreNoLessOverABoxThanOverAPartOfIt)
{
    for (int round = 0; round < 50; ++round) {
        const glm::dvec3 a = point(), b = point();
        Box outer, inner;
        outer.add(a);
        outer.add(b);
        inner.add(glm::mix(a, b, 0.25));
        inner.add(glm::mix(a, b, 0.75));
        const glm::dvec3 step = inner.size();
        EXPECT_LE(bends_.over(inner).off_chord(step), bends_.over(outer).off_chord(step) + 1e-15);
    }
}

INSTANTIATE_TEST_SUITE_P(Of, BendsOfVolumes, ::testing::Values(2, 3, 4));

} // namespace
} // namespace trivar
