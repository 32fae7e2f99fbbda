// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/silhouette/visibility.h"
#include "tests/silhouette/scenes.h"

#include <gtest/gtest.h>

namespace trivar::testing {
namespace {

struct Seen : Sampled {
    Seen(const std::string& function, int n) : Sampled(function, n), hulls(field) {}
    LevelBody body(LevelSide side) const
    {
        return {field, hulls, static_cast<float>(from.level), side};
    }
    FieldHulls hulls;
};

// Marches in steps of a fiftieth of a voxel, with double precision.
bool is_behind(const ScalarField<double>& field, const SampledField& from, LevelSide side,
               const SilhouettePoint& point, const glm::dvec3& to_eye)
{
    const bool above = side == LevelSide::above;
    if (above ? point.bend > 0 : point.bend < 0) return true;
    const glm::dvec3 end(field.size() - 1);
    for (double way = 0.1;; way += 0.02) {
        const glm::dvec3 p = glm::dvec3(point.p) + way * to_eye;
        if (glm::any(glm::lessThan(p, glm::dvec3(0))) || glm::any(glm::greaterThan(p, end)))
            return false;
        const double value = field.at<0>(p).value;
        if (above ? value > from.level : value < from.level) return true;
    }
}

// A step across a face of a brick must be a step there, too.
TEST(Visibility, EndsInVolumesOfAnyLength)
{
    const glm::ivec3 size(2, 2, 70'001);
    std::vector<float> samples(4 * 70'001, 0.0f);
    const ScalarField<float> field{std::span<const float>(samples), size};
    const FieldHulls hulls(field);
    for (int i = 0; i < 200; ++i) {
        const glm::vec3 to_eye = glm::normalize(glm::vec3(1e-6f * static_cast<float>(i), 3e-7f, 1));
        EXPECT_FALSE(hides({field, hulls, 1, LevelSide::above}, {0.1f, 0.2f, 0.37f}, to_eye, 1e6f));
    }
}

TEST(Visibility, IsWhatManySmallStepsSay)
{
    SilhouetteFinder find;
    for (const auto& [function, side, step] :
         {std::tuple{"torus", LevelSide::below, 1u}, std::tuple{"gauss", LevelSide::above, 1u},
          std::tuple{"waves", LevelSide::above, 7u}}) {
        std::size_t points = 0, wrong = 0, hidden = 0;
        const Seen scene(function, 48);
        const ScalarField<double> field{std::span<const double>(scene.from.samples),
                                        scene.from.size};
        const LevelMesh mesh = scene.level();
        for (const ViewPoint& view : some_views(scene.from.size, 16)) {
            if (view.at.w != 0) continue;
            const Silhouettes all = find(scene.field, mesh, view);
            const std::vector<char> found = hidden_points(all, view, scene.body(side));
            for (std::size_t i = 0; i < all.points.size(); i += step, ++points) {
                const bool truth = is_behind(field, scene.from, side, all.points[i],
                                             -glm::normalize(glm::dvec3(view.at)));
                wrong += truth != bool{found[i] != 0};
                hidden += truth;
            }
        }
        EXPECT_GT(points, 1500u) << function;
        EXPECT_GT(hidden, points / 10) << function;
        EXPECT_LE(static_cast<double>(wrong), 0.001 * static_cast<double>(points)) << function;
    }
}

TEST(Visibility, OfABallIsAllOfItsCircle)
{
    const Seen scene("sphere", 32);
    SilhouetteFinder find;
    for (const ViewPoint& view : some_views(scene.from.size, 10)) {
        const Silhouettes circle = find(scene.field, scene.level(), view);
        const std::vector<char> hidden = hidden_points(circle, view, scene.body(LevelSide::below));
        EXPECT_EQ(std::ranges::count(hidden, 1), 0);
        const std::vector<char> inside_out =
            hidden_points(circle, view, scene.body(LevelSide::above));
        EXPECT_EQ(std::ranges::count(inside_out, 0), 0);
    }
}

TEST(Visibility, EndsAtTheEye)
{
    const Seen scene("sphere", 32);
    const LevelBody body = scene.body(LevelSide::below);
    const glm::vec3 before(2, 15.5f, 15.5f), along(1, 0, 0);
    EXPECT_TRUE(hides(body, before, along, 100));
    EXPECT_FALSE(hides(body, before, along, 3));
}

// A plate of half a voxel in the last slice hides what is behind it, wherever steps begin.
TEST(Visibility, SeesABodyInTheLastHalfVoxelOfTheGrid)
{
    const glm::ivec3 size(8);
    std::vector<float> samples(512, 0.0f);
    std::fill(samples.end() - 64, samples.end(), 1.0f);
    const ScalarField<float> field(std::span<const float>(samples), size,
                                   FieldSpline::interpolating, FieldOrder::linear);
    const FieldHulls hulls(field);
    const LevelBody body{field, hulls, 0.5f};
    for (const glm::vec3 to_eye : {glm::vec3(0, 0, 1), glm::vec3(0.6f, 0, 0.8f)})
        for (int i = 0; i < 200; ++i)
            EXPECT_TRUE(hides(body, {0.5f, 3.5f, 0.025f * static_cast<float>(i)}, to_eye, 1e30f));
}

} // namespace
} // namespace trivar::testing
