// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/prolong.h"

#include "tests/support/splines.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

using testing::random_volume, testing::uneven_knots;

// World positions of some hundred points, with u shifted.
void expect_same(const Lattice& a, double at, const Lattice& b, double tolerance)
{
    for (const double v : {0.0, 0.3, 1.0})
        for (const double w : {0.0, 0.7})
            EXPECT_LT(glm::distance(evaluate(a, {at, v, w}).value, evaluate(b, {at, v, w}).value),
                      tolerance);
}

TEST(Prolonged, IsTheSameInsideAndStraightOnOutside)
{
    for (int order = 2; order <= max_order; ++order) {
        const Knots axis = uneven_knots(order), other = Knots::uniform(3, 4);
        const Lattice volume = lattice_through(random_volume({axis, other, other}, 3));
        const Lattice longer = prolonged(volume, 0, -0.4, 2.5);
        for (const double u : {0.0, 0.1, 0.37, 0.55, 0.93, 1.0})
            expect_same(longer, u, volume, 1e-12);
        for (const double u : {-0.4, -0.1, 1.2, 2.5}) {
            const double end = u < 0 ? 0 : 1;
            const auto jet = evaluate(volume, {end, 0.6, 0.4}, 1);
            const glm::dvec3 straight = jet.value + (u - end) * jet.first[0];
            EXPECT_LT(glm::distance(evaluate(longer, {u, 0.6, 0.4}).value, straight), 1e-11);
        }
    }
}

TEST(Prolonged, ByNothingKeepsItsBits)
{
    const Knots axis = uneven_knots(3), other = Knots::uniform(2, 3);
    const Lattice volume = lattice_through(random_volume({axis, other, other}));
    EXPECT_EQ(prolonged(volume, 0, 0, 1), volume);
}

TEST(Prolonged, AlongAllAxesIsOneFunctionHoweverFar)
{
    const Knots knots = uneven_knots(4), other = Knots::uniform(3, 5);
    const Lattice volume = lattice_through(random_volume({other, knots, other}, 9));
    const auto longer = [&](double by) {
        Lattice out = volume;
        for (int axis = 0; axis < 3; ++axis) out = prolonged(out, axis, -by, 1 + by);
        return out;
    };
    const Lattice little = longer(0.5), much = longer(3);
    testing::Noise noise(3);
    for (int n = 0; n < 200; ++n) {
        const glm::dvec3 uvw = 0.5 + noise.vec3();
        EXPECT_LT(glm::distance(evaluate(little, uvw).value, evaluate(much, uvw).value), 1e-11);
    }
    for (int axis = 1; axis < 3; ++axis) {
        glm::dvec3 end(0.3, 0.6, 0.4), beyond = end;
        end[axis] = 1;
        beyond[axis] = 1.4;
        const auto jet = evaluate(volume, end, 1);
        const glm::dvec3 straight = jet.value + 0.4 * jet.first[static_cast<std::size_t>(axis)];
        EXPECT_LT(glm::distance(evaluate(little, beyond).value, straight), 1e-11);
    }
}

TEST(TwiceRound, RepeatsAVolumeWhoseEndsMeet)
{
    const Knots axis = uneven_knots(4), other = Knots::uniform(3, 4);
    Trivariate<glm::dvec3> f = random_volume({axis, other, other}, 5);
    const std::ptrdiff_t size = 16;
    std::copy_n(f.points.begin(), size, f.points.end() - size);
    const Lattice volume = lattice_through(f), twice = twice_round(volume);
    for (const double u : {0.0, 0.2, 0.4, 0.7, 0.99}) {
        expect_same(twice, u, volume, 1e-12);
        EXPECT_LT(glm::distance(evaluate(twice, {u + 1, 0.2, 0.5}).value,
                                evaluate(volume, {u, 0.2, 0.5}).value),
                  1e-12);
    }
}

} // namespace
} // namespace trivar
