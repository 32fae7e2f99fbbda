// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/silhouette/border_lines.h"
#include "core/silhouette/polish.h"
#include "core/silhouette/silhouettes.h"
#include "tests/silhouette/scenes.h"

#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <random>

namespace trivar::testing {
namespace {

bool in_a_face(const glm::vec3& a, const glm::vec3& b, const glm::ivec3& size)
{
    for (int k = 0; k < 3; ++k) {
        const auto end = static_cast<float>(size[k] - 1);
        if ((a[k] == 0 && b[k] == 0) || (a[k] == end && b[k] == end)) return true;
    }
    return false;
}

// Every edge is in two triangles, one each way round, or in one and in a face of the grid.
void expect_manifold(const LevelMesh& mesh, const glm::ivec3& size)
{
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    const std::vector<std::uint32_t> corners = mesh.triangles();
    for (std::size_t c = 0; c < corners.size(); ++c) {
        const std::uint32_t a = corners[c], b = corners[c % 3 == 2 ? c - 2 : c + 1];
        ASSERT_NE(a, b);
        ++edges[{a, b}];
    }
    for (const auto& [edge, count] : edges) {
        ASSERT_EQ(count, 1);
        const bool has_other = edges.contains({edge.second, edge.first});
        ASSERT_TRUE(has_other ||
                    in_a_face(mesh.positions[edge.first], mesh.positions[edge.second], size));
    }
}

TEST(LevelMesh, IsAManifoldOnTheSpline)
{
    for (const char* function : {"sphere", "torus", "gauss", "waves", "noise"}) {
        const Sampled scene(function, function == std::string("noise") ? 14 : 32);
        const LevelMesh mesh = scene.level();
        ASSERT_GT(mesh.triangle_count(), 100u) << function;
        expect_manifold(mesh, scene.from.size);
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            const ScalarJet<float> jet = scene.field.at<1>(mesh.positions[v]);
            const float slope =
                glm::length(glm::vec3(jet.gradient[0], jet.gradient[1], jet.gradient[2]));
            ASSERT_LE(std::abs(jet.value - mesh.level), 1e-4f * slope + 1e-5f) << function;
        }
    }
}

TEST(LevelMesh, PointsOutwardFromWhatIsInside)
{
    const Sampled scene("sphere", 24); // greater outside
    const LevelMesh mesh = scene.level();
    const glm::vec3 middle(11.5f);
    const std::vector<std::uint32_t> corners = mesh.triangles();
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
        const glm::vec3 &a = mesh.positions[corners[3 * t]],
                        &b = mesh.positions[corners[3 * t + 1]],
                        &c = mesh.positions[corners[3 * t + 2]];
        const glm::vec3 normal = glm::cross(b - a, c - a);
        if (glm::length(normal) > 1e-3f) {
            ASSERT_LT(glm::dot(normal, a - middle), 0);
        }
    }
}

TEST(LevelMesh, HoldsOnToItsManifoldAtTheLevelOfSamples)
{
    const Sampled scene("noise", 14); // whole numbers
    for (const double level : {3.0, 5.0, 10.0})
        expect_manifold(scene.level(level), scene.from.size);
    EXPECT_EQ(scene.level(99).triangle_count(), 0u);
    EXPECT_EQ(scene.level(-99).triangle_count(), 0u);
}

TEST(LevelMesh, IsQuickToDrag)
{
    const Sampled scene("gauss", 32);
    const LevelMesh exact = scene.level(),
                    quick = level_mesh(scene.field, std::span<const float>(scene.samples),
                                       exact.level, LevelAccuracy::quick);
    ASSERT_EQ(quick.corners, exact.corners);
    double sum = 0;
    for (std::size_t v = 0; v < quick.positions.size(); ++v)
        sum += glm::distance(quick.positions[v], exact.positions[v]);
    EXPECT_LT(sum / static_cast<double>(quick.positions.size()), 0.01);
}

TEST(Silhouettes, AreCurvesWithoutBranchesThatEndInTheGridsFaces)
{
    SilhouetteFinder find;
    for (const char* function : {"sphere", "torus", "gauss", "waves", "noise"}) {
        const Sampled scene(function, function == std::string("noise") ? 14 : 32);
        const LevelMesh mesh = scene.level();
        for (const ViewPoint& view : some_views(scene.from.size, 20)) {
            const Silhouettes all = find(scene.field, mesh, view);
            ASSERT_GT(all.points.size(), 0u) << function;
            for (std::size_t c = 0; c < all.count(); ++c) {
                if (all.closed[c]) continue;
                for (const std::size_t i :
                     {std::size_t{all.first[c]}, std::size_t{all.first[c + 1] - 1}}) {
                    const std::uint64_t edge = all.points[i].edge;
                    ASSERT_TRUE(in_a_face(mesh.positions[edge >> 32],
                                          mesh.positions[edge & 0xFFFFFFFF], scene.from.size))
                        << function;
                }
            }
        }
    }
}

TEST(Silhouettes, LieOnTheSplineWhereSightGrazesIt)
{
    SilhouetteFinder find;
    for (const char* function : {"sphere", "torus", "gauss"}) {
        const Sampled scene(function, 48);
        const LevelMesh mesh = scene.level();
        for (const ViewPoint& view : some_views(scene.from.size, 6)) {
            const Silhouettes all = find(scene.field, mesh, view);
            std::size_t polished = 0;
            for (const SilhouettePoint& point : all.points) {
                if (!point.polished) continue;
                ++polished;
                const ScalarJet<float> jet = scene.field.at<1>(point.p);
                const glm::vec3 g(jet.gradient[0], jet.gradient[1], jet.gradient[2]);
                const glm::vec3 sight = glm::normalize(glm::vec3(view.sight(point.p)));
                ASSERT_LE(std::abs(jet.value - mesh.level) / glm::length(g), 1e-4f);
                ASSERT_LE(std::abs(glm::dot(sight, g)) / glm::length(g), 2e-3f) << function;
            }
            EXPECT_GE(polished, all.points.size() * 99 / 100) << function;
        }
    }
}

TEST(Silhouettes, OfABallAreACircle)
{
    const Sampled scene("sphere", 64);
    const LevelMesh mesh = scene.level();
    const double radius = 0.7 / scene.from.spacing;
    const glm::dvec3 middle(31.5), eye = middle + glm::dvec3(100, 20, -30);
    SilhouetteFinder find;
    for (const ViewPoint& view : {ViewPoint{{1, 2, 3, 0}}, ViewPoint{glm::dvec4(eye, 1)}}) {
        const Silhouettes circle = find(scene.field, mesh, view);
        ASSERT_EQ(circle.count(), 1u);
        EXPECT_TRUE(circle.closed[0]);
        for (const SilhouettePoint& point : circle.points) {
            EXPECT_NEAR(glm::distance(glm::dvec3(point.p), middle), radius, 2e-3);
            EXPECT_GT(point.bend, 0); // the ball is where the field is less
        }
    }
}

TEST(Silhouettes, LeaveOutOnlyWhatHasNone)
{
    const Sampled scene("gauss", 40);
    LevelMesh mesh = scene.level();
    SilhouetteFinder find;
    std::vector<Silhouettes> quick;
    const std::vector<ViewPoint> views = some_views(scene.from.size, 10);
    for (const ViewPoint& view : views) quick.push_back(find(scene.field, mesh, view));
    for (LevelMesh::Run& run : mesh.runs) {
        run.least.fill(-1e9f);
        run.greatest.fill(1e9f);
    }
    for (std::size_t i = 0; i < views.size(); ++i) {
        const Silhouettes all = find(scene.field, mesh, views[i]);
        EXPECT_EQ(all.tested, mesh.triangle_count());
        EXPECT_LT(quick[i].tested, all.tested * 3 / 4);
        ASSERT_EQ(quick[i].first, all.first);
        for (std::size_t p = 0; p < all.points.size(); ++p)
            ASSERT_EQ(quick[i].points[p].p, all.points[p].p);
    }
}

TEST(Silhouettes, AreTheSameForAnyNumberOfThreads)
{
    const Sampled scene("waves", 40);
    const ViewPoint view{{0.3, 0.5, 0.8, 0}};
    SilhouetteFinder find;
    const Silhouettes many = find(scene.field, scene.level(), view);
    const ThreadLimit one(1);
    const Silhouettes alone = find(scene.field, scene.level(), view);
    ASSERT_EQ(many.first, alone.first);
    for (std::size_t p = 0; p < many.points.size(); ++p)
        ASSERT_EQ(many.points[p].p, alone.points[p].p);
}

TEST(Silhouettes, NeedAView)
{
    const Sampled scene("sphere", 16);
    SilhouetteFinder find;
    EXPECT_THROW(find(scene.field, scene.level(), ViewPoint{{0, 0, 0, 0}}), Rejected);
    EXPECT_THROW(find(scene.field, scene.level(), ViewPoint{{NAN, 0, 1, 0}}), Rejected);
}

// The distance to the true silhouette falls with the third power of the spacing and more, and in
// the image with the fourth.
TEST(Silhouettes, ComeNearToThoseOfTheFunctionWithItsOrder)
{
    const glm::dvec3 sight = glm::normalize(glm::dvec3(0.3, 0.5, 0.81));
    std::vector<double> in_space, in_image;
    for (const int n : {33, 65, 129}) {
        const SampledField from = sampled("sphere", n);
        const std::vector<float> rough = in_single_precision(from.samples);
        const ScalarField<double> field{std::span<const double>(from.samples), from.size};
        const ScalarField<float> single{std::span<const float>(rough), from.size};
        const LevelMesh mesh =
            level_mesh(single, std::span<const float>(rough), static_cast<float>(from.level));
        SilhouetteFinder find;
        const ViewPoint view{glm::dvec4(sight, 0)};
        double space = 0, image = 0;
        for (const SilhouettePoint& point : find(single, mesh, view).points) {
            glm::dvec3 p(point.p);
            ScalarJet<double> jet;
            ASSERT_TRUE(polish(field, from.level, view, p, jet, 1e-12));
            const glm::dvec3 q = from.spacing * p - 1.2;
            const double along = glm::dot(q, sight), across = glm::length(q - along * sight);
            space = std::max(space, std::hypot(along, across - 0.7));
            image = std::max(image, std::abs(across - 0.7));
        }
        in_space.push_back(space);
        in_image.push_back(image);
    }
    EXPECT_GE(std::log2(in_space[0] / in_space[2]) / 2, 2.8);
    EXPECT_GE(std::log2(in_image[0] / in_image[2]) / 2, 3.7);
}

// Waves go through all faces of the grid, a ball through none.
TEST(BorderLines, AreLoopsInTheFacesOfTheGrid)
{
    const Sampled ball("sphere", 24);
    EXPECT_EQ(border_lines(ball.field, ball.level()).count(), 0u);
    for (const char* function : {"waves", "noise"}) {
        const Sampled scene(function, 20);
        const LevelMesh mesh = scene.level();
        const Silhouettes lines = border_lines(scene.field, mesh, 0);
        ASSERT_GT(lines.count(), 0u);
        for (std::size_t c = 0; c < lines.count(); ++c) {
            EXPECT_TRUE(lines.closed[c]);
            EXPECT_GE(lines.first[c + 1] - lines.first[c], 3u);
        }
        for (const SilhouettePoint& point : lines.points)
            EXPECT_TRUE(in_a_face(point.p, point.p, scene.from.size));
        std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
        const std::vector<std::uint32_t> corners = mesh.triangles();
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const std::uint32_t a = corners[k], b = corners[k % 3 == 2 ? k - 2 : k + 1];
            ++edges[std::minmax(a, b)];
        }
        const auto alone =
            std::ranges::count_if(edges, [](const auto& e) { return e.second == 1; });
        EXPECT_EQ(static_cast<std::size_t>(alone), lines.points.size()) << function;
    }
}

} // namespace
} // namespace trivar::testing
