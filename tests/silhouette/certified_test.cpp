// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/field/bezier_net.h"
#include "core/silhouette/certified.h"
#include "tests/silhouette/scenes.h"
#include "tests/silhouette/true_silhouette.h"

#include <gtest/gtest.h>
#include <random>

namespace trivar::testing {
namespace {

BezierNet random_net(std::minstd_rand& random)
{
    std::uniform_real_distribution<float> share(-1, 1);
    BezierNet out;
    for (Row4<float>& row : out.rows)
        for (int i = 0; i < 4; ++i) row[i] = share(random);
    return out;
}

double value(const BezierNet& net, const glm::dvec3& p)
{
    const auto weights = [](double t) {
        const double s = 1 - t;
        return std::array{s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
    };
    const auto x = weights(p.x), y = weights(p.y), z = weights(p.z);
    double out = 0;
    for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t j = 0; j < 4; ++j)
            for (std::size_t i = 0; i < 4; ++i)
                out += x[i] * y[j] * z[k] * net.rows[j + 4 * k][static_cast<int>(i)];
    return out;
}

TEST(BezierNet, OfACellIsItsSpline)
{
    const Sampled scene("noise", 14);
    std::minstd_rand random(1);
    std::uniform_real_distribution<double> share(0, 1);
    for (int n = 0; n < 100; ++n) {
        const glm::ivec3 cell(random() % 13, random() % 13, random() % 13);
        BezierNet net;
        for (int c = 0; c < 4; ++c)
            for (int b = 0; b < 4; ++b)
                net.rows[static_cast<std::size_t>(b + 4 * c)] =
                    row4(&scene.field.coefficient(cell.x - 1, cell.y - 1 + b, cell.z - 1 + c));
        make_bezier(net);
        const glm::dvec3 p(share(random), share(random), share(random));
        EXPECT_NEAR(value(net, p), scene.field.at<0>(glm::vec3(glm::dvec3(cell) + p)).value, 1e-4);
    }
}

TEST(BezierNet, OfASightIsItsProductWithTheGradient)
{
    std::minstd_rand random(2);
    std::uniform_real_distribution<double> share(0.1, 0.9);
    for (int n = 0; n < 100; ++n) {
        const BezierNet f = random_net(random);
        const glm::dvec3 from(1, -2, 3), p(share(random), share(random), share(random));
        glm::dvec3 gradient;
        for (int k = 0; k < 3; ++k) {
            glm::dvec3 step(0);
            step[k] = 1e-5;
            gradient[k] = (value(f, p + step) - value(f, p - step)) / 2e-5;
        }
        EXPECT_NEAR(value(sight_net(f, glm::vec3(from), Sight::parallel), p),
                    glm::dot(from, gradient), 1e-5);
        EXPECT_NEAR(value(sight_net(f, glm::vec3(from), Sight::from_eye), p),
                    glm::dot(from + p, gradient), 1e-5);
        for (int axis = 0; axis < 3; ++axis) {
            BezierNet lower, upper;
            halve(f, axis, lower, upper);
            glm::dvec3 q = p;
            q[axis] = p[axis] / 2;
            EXPECT_NEAR(value(lower, p), value(f, q), 1e-6);
            q[axis] = (1 + p[axis]) / 2;
            EXPECT_NEAR(value(upper, p), value(f, q), 1e-6);
        }
    }
}

// Where signs at the grid's points miss pieces, the certificate finds them: against places that an
// exhaustive search in double precision finds.
TEST(CertifiedSilhouettes, LackNothingThatIsLargerThanTheirLeaves)
{
    for (const char* function : {"torus", "gauss", "waves"}) {
        const Sampled scene(function, 20);
        const FieldHulls hulls(scene.field);
        const ScalarField<double> field{std::span<const double>(scene.from.samples),
                                        scene.from.size};
        double recall = 0, quick_recall = 0;
        const std::vector<ViewPoint> views = some_views(scene.from.size, 2);
        for (const ViewPoint& view : views) {
            const std::vector<glm::dvec3> truth = true_silhouette(field, scene.from.level, view);
            const CertifiedSilhouettes found = certified_silhouettes(
                scene.field, hulls, static_cast<float>(scene.from.level), view, 3);
            EXPECT_EQ(found.loose_ends, 0u) << function;
            recall += share_near(truth, found.curves, 0.15) / static_cast<double>(views.size());
            quick_recall +=
                share_near(truth,
                           SilhouetteFinder()(scene.field, scene.level(), view, {.spacing = 0.1f}),
                           0.15) /
                static_cast<double>(views.size());
        }
        EXPECT_GE(recall, 0.9995) << function;
        if (function == std::string("waves")) {
            EXPECT_LT(quick_recall, 0.95);
        } else {
            EXPECT_GE(quick_recall, 0.99) << function;
        }
    }
}

TEST(CertifiedSilhouettes, OfABallAreItsCircleFromEverywhere)
{
    const Sampled scene("sphere", 24);
    const FieldHulls hulls(scene.field);
    for (const ViewPoint& view : some_views(scene.from.size, 10)) {
        const CertifiedSilhouettes found = certified_silhouettes(
            scene.field, hulls, static_cast<float>(scene.from.level), view, 2);
        EXPECT_EQ(found.curves.count(), 1u);
        EXPECT_TRUE(found.curves.closed.at(0));
        EXPECT_EQ(found.loose_ends, 0u);
        EXPECT_LT(found.cells, 800u);
        EXPECT_LE(found.open, found.leaves);
    }
}

TEST(CertifiedSilhouettes, AreTheSameForAnyNumberOfThreads)
{
    const Sampled scene("waves", 24);
    const FieldHulls hulls(scene.field);
    const ViewPoint view{{0.3, 0.5, 0.8, 0}};
    const auto level = static_cast<float>(scene.from.level);
    const CertifiedSilhouettes many = certified_silhouettes(scene.field, hulls, level, view, 2);
    const ThreadLimit one(1);
    const CertifiedSilhouettes alone = certified_silhouettes(scene.field, hulls, level, view, 2);
    ASSERT_EQ(many.curves.first, alone.curves.first);
    for (std::size_t p = 0; p < many.curves.points.size(); ++p)
        ASSERT_EQ(many.curves.points[p].p, alone.curves.points[p].p);
}

TEST(CertifiedSilhouettes, AreOfCubicSplines)
{
    const SampledField from = sampled("sphere", 12);
    const std::vector<float> samples = in_single_precision(from.samples);
    const ScalarField<float> quadratic{std::span<const float>(samples), from.size,
                                       FieldSpline::interpolating, FieldOrder::quadratic};
    const FieldHulls hulls(quadratic);
    EXPECT_THROW(certified_silhouettes(quadratic, hulls, 1, ViewPoint{}, 2), Rejected);
    const Sampled scene("sphere", 12);
    EXPECT_THROW(certified_silhouettes(scene.field, hulls, 1, ViewPoint{}, 6), Rejected);
    EXPECT_THROW(certified_silhouettes(scene.field, hulls, 1, ViewPoint{{0, 0, 0, 0}}, 2),
                 Rejected);
}

} // namespace
} // namespace trivar::testing
