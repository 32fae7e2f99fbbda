// SPDX-License-Identifier: GPL-3.0-or-later
// Curves, surfaces and trivariate functions: value, first and second derivatives.
#include "core/spline/insert.h"
#include "tests/support/splines.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

using testing::all_axes;
using testing::insert_knot;
using testing::inside;
using testing::Noise;
using testing::random_curve;
using testing::random_surface;
using testing::random_volume;

// A value type of somebody else: a place and a temperature.
struct Probe {
    glm::dvec2 place{0};
    double heat = 0;
    friend Probe operator+(Probe a, Probe b) { return {a.place + b.place, a.heat + b.heat}; }
    friend Probe operator*(Probe a, double s) { return {a.place * s, a.heat * s}; }
};

// Central differences over h err by h^2 / 6 times the third derivative, which within a span of
// length 1 or so is below a hundred times the values; knots in between would add their jump.
constexpr double h = 1e-5, difference_error = 2e-6;

// Two axes of every order beside a third one; parameters between knots.
std::vector<std::array<Knots, 3>> boxes()
{
    std::vector<std::array<Knots, 3>> out;
    for (int order = 2; order <= max_order; ++order) {
        out.push_back({Knots::uniform(order, order + 2), Knots::periodic(order, order + 1),
                       Knots::uniform(2 + (order + 1) % 5, 7)});
        out.push_back({Knots::periodic(order, order + 2, 0, 1, Closure::twisted),
                       Knots::uniform(3, 4, 0, 1), Knots::uniform(order, order + 1, 0, 1)});
    }
    return out;
}

TEST(Evaluation, OfACurveMatchesItsDifferences)
{
    for (const Knots& knots : all_axes()) {
        const auto c = random_curve(knots);
        const auto breaks = knots.breaks();
        for (std::size_t b = 0; b + 1 < breaks.size(); ++b) {
            const double length = breaks[b + 1] - breaks[b], t = breaks[b] + 0.37 * length;
            const double step = h * length;
            const auto jet = evaluate(c, t, 2), after = evaluate(c, t + step, 2),
                       before = evaluate(c, t - step, 2);
            EXPECT_LT(length * glm::distance(jet.first, (after.value - before.value) / (2 * step)),
                      difference_error);
            EXPECT_LT(length * length *
                          glm::distance(jet.second, (after.first - before.first) / (2 * step)),
                      difference_error);
        }
    }
}

TEST(Evaluation, OfASurfaceMatchesItsDifferencesRoundTheBandToo)
{
    for (int order = 2; order <= max_order; ++order) {
        const auto s = random_surface({Knots::periodic(order, order + 2, 0, 3, Closure::twisted),
                                       Knots::uniform(order, order + 1, -1, 1)});
        for (const glm::dvec2 p :
             {glm::dvec2(0.71, 0.31), glm::dvec2(3.71, 0.31), glm::dvec2(-0.55, -0.42)}) {
            const auto jet = evaluate(s, p, 2);
            const auto slope = [&](int axis) {
                glm::dvec2 step(0);
                step[axis] = h;
                const auto after = evaluate(s, p + step, 2), before = evaluate(s, p - step, 2);
                return SurfaceJet<glm::dvec3>{(after.value - before.value) / (2 * h),
                                              (after.u - before.u) / (2 * h),
                                              (after.v - before.v) / (2 * h)};
            };
            const auto du = slope(0), dv = slope(1);
            EXPECT_LT(glm::distance(jet.u, du.value), difference_error);
            EXPECT_LT(glm::distance(jet.v, dv.value), difference_error);
            EXPECT_LT(glm::distance(jet.uu, du.u), difference_error);
            EXPECT_LT(glm::distance(jet.uv, du.v), difference_error);
            EXPECT_LT(glm::distance(jet.uv, dv.u), difference_error);
            EXPECT_LT(glm::distance(jet.vv, dv.v), difference_error);
        }
    }
}

TEST(Evaluation, OfAVolumeMatchesItsDifferences)
{
    for (const auto& axes : boxes()) {
        const auto f = random_volume(axes);
        for (const glm::dvec3 p :
             {glm::dvec3(0.413, 0.171, 0.633), glm::dvec3(1.413, 0.171, 0.633)}) {
            const auto jet = evaluate(f, p, 2);
            std::array<Jet<glm::dvec3>, 3> slope;
            for (int axis = 0; axis < 3; ++axis) {
                glm::dvec3 step(0);
                step[axis] = h;
                const auto after = evaluate(f, p + step, 1), before = evaluate(f, p - step, 1);
                auto& s = slope[static_cast<std::size_t>(axis)];
                s.value = (after.value - before.value) / (2 * h);
                for (std::size_t i = 0; i < 3; ++i)
                    s.first[i] = (after.first[i] - before.first[i]) / (2 * h);
            }
            if (p.x > 1 && axes[0].closure() == Closure::open) continue; // clamped: no slope
            const double error = 40 * difference_error; // spans are a seventh of the domain
            for (std::size_t i = 0; i < 3; ++i) {
                EXPECT_LT(glm::distance(jet.first[i], slope[i].value), error);
                EXPECT_LT(glm::distance(jet.second[i], slope[i].first[i]), error);
                EXPECT_LT(glm::distance(jet.second[3 + i], slope[i].first[(i + 1) % 3]), error);
            }
        }
    }
}

TEST(Evaluation, OfControlPointsAtGrevilleIsTheIdentity)
{
    for (const auto& axes : boxes()) {
        if (axes[0].closure() != Closure::open) continue;
        const std::array<Knots, 3> open{axes[0], opened(axes[1]), axes[2]};
        Trivariate<glm::dvec3> f{open, {}};
        for (int i = 0; i < open[0].count(); ++i)
            for (int j = 0; j < open[1].count(); ++j)
                for (int k = 0; k < open[2].count(); ++k)
                    f.points.emplace_back(open[0].greville(i), open[1].greville(j),
                                          open[2].greville(k));
        Noise noise;
        for (int i = 0; i < 200; ++i) {
            const glm::dvec3 p = noise.vec3() * 0.5 + 0.5;
            // order^3 products are summed, each rounded.
            EXPECT_LT(glm::distance(evaluate(f, p).value, p), 4e-15);
        }
    }
}

TEST(Evaluation, CommutesWithAffineMaps)
{
    const glm::dmat3 turn(glm::dvec3(1, 2, 0), glm::dvec3(-1, 0.5, 3), glm::dvec3(0, 1, 1));
    const glm::dvec3 shift(5, -7, 2);
    for (const auto& axes : boxes()) {
        const auto f = random_volume(axes);
        auto g = f;
        for (glm::dvec3& p : g.points) p = turn * p + shift;
        Noise noise;
        for (int i = 0; i < 50; ++i) {
            const glm::dvec3 p = noise.vec3() * 0.5 + 0.5;
            EXPECT_LT(glm::distance(turn * evaluate(f, p).value + shift, evaluate(g, p).value),
                      1e-13);
        }
    }
}

TEST(Evaluation, AtTheCornersOfAClampedVolumeIsTheCornerPoint)
{
    for (int order = 2; order <= max_order; ++order) {
        const Knots k = Knots::uniform(order, order + 1);
        const auto f = random_volume({k, k, k});
        EXPECT_EQ(evaluate(f, {0, 0, 0}).value, f.points.front());
        EXPECT_EQ(evaluate(f, {1, 1, 1}).value, f.points.back());
        EXPECT_EQ(evaluate(f, {1, 0, 1}).value, f.point(order, 0, order));
        EXPECT_EQ(evaluate(f, {7, -3, 2}).value, f.point(order, 0, order)) << "clamped outside";
    }
}

TEST(Evaluation, RoundAPeriodicAxisComesBackWithItsDerivatives)
{
    for (int order = 3; order <= max_order; ++order) {
        const auto c = random_curve(Knots::periodic(order, order + 1));
        const auto start = evaluate(c, 0, 2), before = evaluate(c, 1 - 1e-15, 2);
        EXPECT_EQ(evaluate(c, 1).value, start.value);
        EXPECT_LT(glm::distance(start.value, before.value), 1e-13);
        EXPECT_LT(glm::distance(start.first, before.first), 1e-11);
        const double curvature_jump = glm::distance(start.second, before.second);
        EXPECT_TRUE(order == 3 || curvature_jump < 1e-10) << "order 3 is C^1 only";
        EXPECT_LT(glm::distance(evaluate(c, 0.3).value, evaluate(c, -1.7).value), 1e-14);
    }
}

TEST(Evaluation, RoundATwistedAxisComesBackMirrored)
{
    for (const auto& axes : boxes()) {
        if (axes[0].closure() != Closure::twisted) continue;
        const auto f = random_volume(axes);
        Noise noise;
        for (int i = 0; i < 50; ++i) {
            const glm::dvec3 p = noise.vec3() * 0.5 + 0.5;
            const auto here = evaluate(f, {p.x, 1 - p.y, 1 - p.z}, 1);
            const auto round = evaluate(f, {p.x + 1, p.y, p.z}, 1);
            EXPECT_LT(glm::distance(here.value, round.value), 1e-13);
            EXPECT_LT(glm::distance(here.first[0], round.first[0]), 1e-11);
            EXPECT_LT(glm::distance(here.first[1], -round.first[1]), 1e-11);
            EXPECT_LT(glm::distance(here.first[2], -round.first[2]), 1e-11);
            const auto twice = evaluate(f, {p.x - 2, p.y, p.z}).value;
            EXPECT_LT(glm::distance(twice, evaluate(f, p).value), 1e-13);
        }
        const auto seam = evaluate(f, {1 - 1e-15, 0.2, 0.7}, 1);
        EXPECT_LT(glm::distance(seam.value, evaluate(f, {0, 0.8, 0.3}).value), 1e-12);
    }
}

TEST(Evaluation, TakesAnyTypeThatAddsAndScales)
{
    const Knots k = Knots::uniform(4, 5);
    Curve<Probe> c{k, {}};
    for (int i = 0; i < 5; ++i)
        c.points.push_back({glm::dvec2(k.greville(i), 1), 2 * k.greville(i)});
    EXPECT_NEAR(evaluate(c, 0.3).value.heat, 0.6, 1e-15);
    EXPECT_NEAR(evaluate(insert_knot(c, 0.4), 0.3).value.place.x, 0.3, 1e-15);
    const Surface<Probe> s{{k, k}, std::vector<Probe>(25, {glm::dvec2(1), 4})};
    EXPECT_NEAR(evaluate(s, {0.2, 0.9}, 2).value.heat, 4, 1e-14);
    const Trivariate<Probe> f{{k, k, k}, std::vector<Probe>(125, {glm::dvec2(1), 4})};
    EXPECT_NEAR(evaluate(f, {0.2, 0.9, 0.5}, 2).value.place.y, 1, 1e-14);
}

TEST(Evaluation, ANumberlessControlPointPoisonsOnlyItsSupport)
{
    auto c = random_curve(Knots::uniform(3, 10));
    c.points[5] = glm::dvec3(std::nan(""));
    for (const double t : inside(c.knots, 101)) {
        const bool hit = t >= c.knots.values()[5] && t < c.knots.values()[8];
        EXPECT_EQ(std::isnan(evaluate(c, t).value.x), hit) << t;
    }
}

} // namespace
} // namespace trivar
