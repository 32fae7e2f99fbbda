// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/simplex/box_grid.h"
#include "core/simplex/simplex_rows.h"
#include "core/tetrahedra/tetrahedra_shaper.h"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <random>

namespace trivar {
namespace {

template <class T> TetrahedraEdit edit(std::optional<T> TetrahedraEdit::*which, const T& value)
{
    TetrahedraEdit out;
    out.*which = value;
    return out;
}
TetrahedraEdit pull(const TetrahedraPull& p)
{
    return edit(&TetrahedraEdit::pull, p);
}

std::vector<glm::vec3> inside(std::size_t count)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<float> anywhere(-1, 1);
    std::vector<glm::vec3> out;
    while (out.size() < count)
        out.emplace_back(anywhere(random), anywhere(random), anywhere(random));
    return out;
}

const TetrahedraShape box{.size = glm::dvec3(2), .boxes = glm::ivec3(2)};
const TetrahedraPull to_the_right{.at = {0.5, 0.2, 0}, .radius = 0.9, .by = {0.3, 0, 0.1}};

TEST(Tetrahedra, LeaveAModelToTheBitAtRest)
{
    TetrahedraShaper shaper;
    const Ref<SimplexVolume> volume = shaper(box).volume;
    const std::vector<glm::vec3> points = inside(100);
    const SimplexRows rows(volume->layers, points, false);
    EXPECT_EQ(rows.displaced(volume->displacements).positions, points);
    EXPECT_EQ(rows.outside(), 0U);
}

TEST(Tetrahedra, GiveBoundPointsWhatEvaluationGives)
{
    TetrahedraShape shape = box;
    shape.edits = {pull(to_the_right)};
    TetrahedraShaper shaper;
    const Ref<SimplexVolume> volume = shaper(shape).volume;
    const std::vector<glm::vec3> points = inside(203);
    const DisplacedPoints bound =
        SimplexRows(volume->layers, points, true).displaced(volume->displacements);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const SimplexPoint exact = evaluate(*volume, points[i], true);
        EXPECT_LE(glm::distance(glm::dvec3(bound.positions[i]), exact.position), 1e-6);
        for (int c = 0; c < 3; ++c)
            EXPECT_LE(glm::distance(glm::dvec3(bound.jacobians[i][c]), exact.jacobian[c]), 1e-5);
    }
}

TEST(Tetrahedra, GiveEqualPointsEqualBitsForAnyNumberOfThreads)
{
    TetrahedraShape shape = box;
    shape.edits = {pull(to_the_right)};
    TetrahedraShaper shaper;
    const Ref<SimplexVolume> volume = shaper(shape).volume;
    std::vector<glm::vec3> points = inside(9000);
    const SimplexRows all(volume->layers, points, false);
    const std::vector<glm::vec3> together = all.displaced(volume->displacements).positions;
    {
        const ThreadLimit one(1);
        EXPECT_EQ(
            SimplexRows(volume->layers, points, false).displaced(volume->displacements).positions,
            together);
    }
    const std::vector<glm::vec3> few(points.begin() + 40, points.begin() + 51);
    const std::vector<glm::vec3> alone =
        SimplexRows(volume->layers, few, false).displaced(volume->displacements).positions;
    EXPECT_TRUE(std::equal(alone.begin(), alone.end(), together.begin() + 40));
}

TEST(Tetrahedra, AreRefinedWithoutAChangeOfShape)
{
    TetrahedraShape shape = box;
    shape.edits = {pull(to_the_right)};
    TetrahedraShaper shaper;
    const Ref<SimplexVolume> before = shaper(shape).volume;
    shape.edits.push_back(
        edit(&TetrahedraEdit::refinement,
             {.places = {{0.5, 0, 0}, {0.5, 0.3, 0}}, .radius = 0.4, .edge = 0.2}));
    const Ref<SimplexVolume> after = shaper(shape).volume;
    ASSERT_EQ(after->layers.size(), 2U);
    for (const glm::vec3& p : inside(50))
        EXPECT_EQ(evaluate(*after, p).position, evaluate(*before, p).position);
    // and a pull of the new layer moves what is near alone
    shape.edits.push_back(pull({.layer = 1, .at = {0.5, 0, 0}, .radius = 0.3, .by = {0, 0, 0.05}}));
    const Ref<SimplexVolume> pulled = shaper(shape).volume;
    EXPECT_GE(glm::distance(evaluate(*pulled, {0.5, 0, 0}).position,
                            evaluate(*after, {0.5, 0, 0}).position),
              0.02);
    EXPECT_EQ(evaluate(*pulled, {-0.7, 0, 0}).position, evaluate(*after, {-0.7, 0, 0}).position);
}

TEST(Tetrahedra, StopBeforeTheyFold)
{
    TetrahedraShape shape = box;
    TetrahedraPull far = to_the_right;
    far.by = {-4, 0, 0};
    shape.edits = {pull(far)};
    TetrahedraShaper shaper;
    const ShapedTetrahedra held = shaper(shape);
    EXPECT_LT(held.outcomes[0].share, 1);
    EXPECT_GT(held.outcomes[0].share, 0);
    const FoldGuard guard(held.volume->layers);
    EXPECT_GE(guard.least(held.volume->displacements), 0.019);
    far.guard = false;
    shape.edits = {pull(far)};
    EXPECT_LT(guard.least(shaper(shape).volume->displacements), 0);
}

TEST(Tetrahedra, StopBeforeTheyFoldWithMoreCellsThanAreSampledFiveTimes)
{
    TetrahedraShape shape = box;
    TetrahedraPull far = to_the_right;
    far.by = {-4, 0, 0};
    shape.edits = {pull(far)};
    for (const int boxes : {15, 26}) { // 20,250 and 105,456 cells
        shape.boxes = glm::ivec3(boxes);
        TetrahedraShaper shaper;
        const ShapedTetrahedra held = shaper(shape);
        EXPECT_LT(held.outcomes[0].share, 1);
        EXPECT_GT(held.outcomes[0].share, 0);
        const FoldGuard guard(held.volume->layers);
        EXPECT_GE(guard.sample_count(), 20000U);
        EXPECT_LE(guard.sample_count(), 100000U);
        EXPECT_GE(guard.least(held.volume->displacements), 0.019);
    }
}

TEST(Tetrahedra, PullOneSideOfACut)
{
    TetrahedraShape shape = box;
    std::vector<glm::dvec3> places; // all faces in the plane x = 0
    for (const double y : {-1, 0})
        for (const double z : {-1, 0})
            for (const double t : {1.0 / 3, 2.0 / 3}) places.push_back({0, y + t, z + 1 - t});
    shape.edits = {edit(&TetrahedraEdit::crease, {.places = places, .radius = 0.05, .depth = 2}),
                   pull({.at = {0.4, 0, 0}, .radius = 1.5, .by = {0.3, 0, 0}})};
    TetrahedraShaper shaper;
    const Ref<SimplexVolume> volume = shaper(shape).volume;
    EXPECT_EQ(volume->layers[0]->domain().cuts.size(), 8U);
    EXPECT_GE(evaluate(*volume, {0.001, 0, 0}).position.x, 0.1);
    EXPECT_EQ(evaluate(*volume, {-0.001, 0, 0}).position.x, -0.001);
}

TEST(Tetrahedra, BendAsABox)
{
    TetrahedraShape shape = box;
    shape.edits = {edit(&TetrahedraEdit::warp, {.axis = VolumeAxis::up, .bend_deg = 40})};
    TetrahedraShaper shaper;
    const Ref<SimplexVolume> volume = shaper(shape).volume;
    EXPECT_LE(glm::distance(evaluate(*volume, {0, 0, -1}).position, glm::dvec3(0, 0, -1)), 0.05);
    EXPECT_GE(std::abs(evaluate(*volume, {0, 0, 1}).position.x), 0.3);
}

TEST(Tetrahedra, FindThePointThatTheyTookAway)
{
    TetrahedraShape shape = box;
    shape.edits = {pull(to_the_right)};
    TetrahedraShaper shaper;
    const Ref<SimplexVolume> volume = shaper(shape).volume;
    for (const glm::vec3& p : inside(50)) {
        const std::optional<glm::dvec3> back =
            inverse(*volume, evaluate(*volume, p).position, 1e-9);
        ASSERT_TRUE(back);
        EXPECT_LE(glm::distance(*back, glm::dvec3(p)), 1e-7);
    }
}

TEST(Tetrahedra, LeaveAHundredThousandPointsFarOutsideWhereTheyAre)
{
    TetrahedraShape shape = box;
    shape.edits = {pull(to_the_right)};
    TetrahedraShaper shaper;
    const Ref<SimplexVolume> volume = shaper(shape).volume;
    std::vector<glm::vec3> points = inside(100000);
    for (std::size_t i = 0; i < points.size(); ++i) points[i] += i % 2 == 0 ? 3.0f : 1e30f;
    points[1].x = NAN;
    const SimplexRows rows(volume->layers, points, false);
    EXPECT_EQ(rows.outside(), points.size());
    const std::vector<glm::vec3> out = rows.displaced(volume->displacements).positions;
    EXPECT_EQ(std::memcmp(out.data(), points.data(), points.size() * sizeof points[0]), 0);
}

TEST(Tetrahedra, AreNotSearchedWhereTheyLieOverEachOtherEnMasse)
{
    EXPECT_THROW(BoxGrid<3>(std::vector<CellBox<3>>(4000, {glm::dvec3(0), glm::dvec3(1)})),
                 Rejected);
    // Ever smaller boxes toward a corner, as of a graded domain, are no trouble.
    std::vector<CellBox<3>> graded;
    for (int n = 0; n < 100000; ++n) {
        const double at = std::pow(1e-3, (n % 1000) / 1000.0);
        graded.push_back({glm::dvec3(at), glm::dvec3(at * 1.1)});
    }
    EXPECT_FALSE(BoxGrid<3>(graded).boxes_at(glm::dvec3(0.5)).empty());
}

TEST(Tetrahedra, RefuseWhatIsNoVolume)
{
    TetrahedraShaper shaper;
    TetrahedraShape shape = box;
    shape.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    shape.cells = {{0, 1, 2, 3}};
    EXPECT_THROW(shaper(shape), Rejected); // flat
    shape.cells = {{0, 1, 2, 9}};
    EXPECT_THROW(shaper(shape), Rejected);
    shape = box;
    shape.boxes = glm::ivec3(100);
    EXPECT_THROW(shaper(shape), Rejected);
    shape = box;
    shape.edits = {
        edit(&TetrahedraEdit::refinement, {.places = {{0, 0, 0}}, .radius = 1, .edge = 1e-4})};
    EXPECT_THROW(shaper(shape), Rejected);
}

} // namespace
} // namespace trivar
