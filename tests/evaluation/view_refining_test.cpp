// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/document_digest.h"
#include "core/evaluation/view_refining.h"
#include "core/refinement/refine.h"
#include "tests/support/scenes/commands.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace trivar {
namespace {

using testing::small_document;

constexpr Id seen_pot = 3;

Evaluation evaluated_pot()
{
    Evaluator evaluator(std::make_shared<const AssetStore>("/nowhere"));
    return evaluator(small_document());
}

Camera camera_towards(const Box& box, const glm::dvec3& from)
{
    Camera camera;
    camera.target = box.center();
    camera.eye = camera.target + from * glm::length(box.size());
    return camera;
}

bool in_picture(const Camera& camera, const PicturePoint& p)
{
    return p.depth_world > 0 && p.p_px.x >= 0 && p.p_px.y >= 0 && p.p_px.x <= camera.size_px.x &&
           p.p_px.y <= camera.size_px.y;
}

// The furthest, in pixels, that a point of the flat triangles is seen from where it should be.
double furthest_seen(const EvaluatedObject& object, const Camera& camera, int steps = 5)
{
    double most = 0;
    for (const Part& part : object.parts)
        for (const glm::uvec3& t : triangles(*part.rest))
            for (int i = 0; i <= steps; ++i)
                for (int j = 0; i + j <= steps; ++j) {
                    const double a = double(i) / steps, b = double(j) / steps, c = 1 - a - b;
                    const auto mixed = [&](const Mesh& mesh) {
                        return a * glm::dvec3(mesh.positions[t.x]) +
                               b * glm::dvec3(mesh.positions[t.y]) +
                               c * glm::dvec3(mesh.positions[t.z]);
                    };
                    const PicturePoint drawn = project(camera, mixed(*part.mesh())),
                                       truth = project(camera, deform(mixed(*part.rest),
                                                                      part.bent->embedding,
                                                                      *part.bent->volume)
                                                                   .position_world);
                    if (in_picture(camera, drawn) || in_picture(camera, truth))
                        most = std::max(most, glm::distance(drawn.p_px, truth.p_px));
                }
    return most;
}

TEST(ViewRefining, KeepsWhatIsSeenWithinItsPixels)
{
    const Evaluation scene = evaluated_pot();
    const Box box = *scene.objects.at(seen_pot)->bounds;
    ViewRefining refining;
    for (const glm::dvec3 from : {glm::dvec3(0.3, -0.7, 0.4), {-1, -2, 0.5}, {4, 4, 4}})
        for (const bool perspective : {true, false})
            for (const double px : {2.0, 0.5}) {
                Camera camera = camera_towards(box, from);
                camera.perspective = perspective;
                camera.height_world = glm::length(box.size());
                const SeenEffects seen = refining(scene, camera, px);
                EXPECT_EQ(seen.open, 0u)
                    << from.y << ' ' << perspective << ' ' << px << ' ' << seen.triangles << ' '
                    << view_tolerance(camera, box, px) << ' '
                    << seen.evaluated.objects.at(seen_pot)->refined->bound << ' '
                    << seen.evaluated.objects.at(seen_pot)->refined->not_certified();
                EXPECT_LE(furthest_seen(*seen.evaluated.objects.at(seen_pot), camera), px);
            }
}

TEST(ViewRefining, SplitsMoreTheNearerAndNothingThatIsOutOfSight)
{
    const Evaluation scene = evaluated_pot();
    const Box box = *scene.objects.at(seen_pot)->bounds;
    ViewRefining refining;
    const auto count = [&](const Camera& camera) { return refining(scene, camera, 1).triangles; };
    Camera away = camera_towards(box, {0, -3, 1});
    away.target = away.eye + (away.eye - away.target);
    const SeenEffects unseen = refining(scene, away, 1);
    EXPECT_EQ(unseen.evaluated.objects.at(seen_pot), scene.objects.at(seen_pot));
    EXPECT_EQ(unseen.open, 0u);
    const std::size_t far = count(camera_towards(box, {0, -40, 10})),
                      near = count(camera_towards(box, {0, -1, 0.3}));
    EXPECT_GE(far, unseen.triangles);
    EXPECT_GT(near, 2 * far);
}

TEST(ViewRefining, DoesNothingAnewForACameraThatHardlyMoves)
{
    const Evaluation scene = evaluated_pot();
    const Box box = *scene.objects.at(seen_pot)->bounds;
    ViewRefining refining;
    Camera camera = camera_towards(box, {0, -2, 0.5});
    const auto seen = [&] { return refining(scene, camera, 1).evaluated.objects.at(seen_pot); };
    std::set<Ref<EvaluatedObject>> distinct;
    for (int i = 0; i < 100; ++i) {
        camera.eye += glm::dvec3(1e-4, 1e-4, 0);
        camera.target += glm::dvec3(1e-3, 0, 1e-4);
        distinct.insert(seen());
    }
    EXPECT_LE(distinct.size(), 2u);
}

TEST(ViewRefining, SaysWhatABudgetLeavesOverAndWhatSinglePrecisionDoes)
{
    const Evaluation scene = evaluated_pot();
    const Box box = *scene.objects.at(seen_pot)->bounds;
    const Camera near = camera_towards(box, {0, -0.7, 0.2});
    const std::size_t before =
        ViewRefining()(scene, camera_towards(box, {0, -1e4, 0}), 1).triangles;
    const SeenEffects poor = ViewRefining()(scene, near, 0.01, {}, 2 * before);
    EXPECT_GT(poor.open, 0u);
    EXPECT_LE(poor.triangles, 2 * before);
    const SeenEffects fine = ViewRefining()(scene, near, 1e-7, {}, 2 * before);
    EXPECT_GT(fine.open, 0u);
}

TEST(ViewRefining, LeavesTheEffectsOfTheDocumentAsTheyAre)
{
    const Evaluation scene = evaluated_pot();
    const std::string before = digest(scene);
    ViewRefining refining;
    const SeenEffects seen =
        refining(scene, camera_towards(*scene.objects.at(seen_pot)->bounds, {0, -1, 0.3}), 0.5);
    EXPECT_EQ(digest(scene), before);
    EXPECT_NE(seen.evaluated.objects.at(seen_pot), scene.objects.at(seen_pot));
    for (const Id other : {1, 2})
        EXPECT_EQ(seen.evaluated.objects.at(other), scene.objects.at(other));
}

TEST(ViewTolerance, IsThatOfTheNearestPointThatIsSeen)
{
    Camera camera;
    camera.eye = {0, -10, 0};
    camera.target = {0, 0, 0};
    Box box;
    box.add(glm::dvec3(-1));
    box.add(glm::dvec3(1));
    const double t = view_tolerance(camera, box, 1), pixel = pixel_size_world(camera, 9);
    EXPECT_LE(t, pixel);
    EXPECT_GE(t, 0.6 * pixel);
    EXPECT_NEAR(view_tolerance(camera, box, 2), 2 * t, 1e-12);
    camera.target = {0, -20, 0};
    EXPECT_EQ(view_tolerance(camera, box, 1), std::numeric_limits<double>::infinity());
    EXPECT_EQ(view_tolerance(camera, Box(), 1), std::numeric_limits<double>::infinity());
    camera.eye = {0, 0, 0}; // inside
    EXPECT_GT(view_tolerance(camera, box, 1), 0);
}

} // namespace
} // namespace trivar
