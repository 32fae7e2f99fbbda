// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/transform_gesture.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

Stand at(Id id, const glm::dvec3& p)
{
    return {id, {.translation = p}, glm::dmat4(1)};
}

TEST(Pivot, IsWhatItsNameSays)
{
    const std::vector<Stand> stands{at(1, {0, 0, 0}), at(2, {2, 0, 0})};
    Box seen;
    seen.add(glm::dvec3(0, 0, 0));
    seen.add(glm::dvec3(10, 4, 2));
    EXPECT_EQ(pivot_of(stands, 2, Pivot::origin, seen), glm::dvec3(1, 0, 0));
    EXPECT_EQ(pivot_of(stands, 2, Pivot::center, seen), glm::dvec3(5, 2, 1));
    EXPECT_EQ(pivot_of(stands, 2, Pivot::center, {}), glm::dvec3(1, 0, 0)) << "nothing is seen";
    EXPECT_EQ(pivot_of(stands, 2, Pivot::active, seen), glm::dvec3(2, 0, 0));
    EXPECT_EQ(pivot_of(stands, 2, Pivot::each, seen), glm::dvec3(2, 0, 0));
}

TEST(Gesture, TurnsEachAboutItsOwnOriginOrAllAboutOnePoint)
{
    for (const Pivot pivot : {Pivot::each, Pivot::center}) {
        TransformChoices choices;
        choices.pivot = pivot;
        TransformGesture gesture(MotionKind::rotate, {at(1, {0, 0, 0}), at(2, {2, 0, 0})}, 2,
                                 choices, Camera{}, {.pivot_world = {1, 0, 0}});
        gesture.choose_axis(2, false);
        for (const char c : std::string("180")) gesture.typed().take(c);
        const std::vector<Transform> after = gesture.transforms();
        EXPECT_EQ(after[0].rotation_deg.z, 180);
        EXPECT_EQ(after[0].translation.x, pivot == Pivot::each ? 0 : 2);
        EXPECT_EQ(after[1].translation.x, pivot == Pivot::each ? 2 : 0);
    }
}

TEST(Gesture, GoesATenthAsFarWhileFine)
{
    const auto moved = [](bool fine) {
        const Camera camera;
        TransformGesture gesture(MotionKind::move, {at(1, {0, 0, 0})}, 1, {}, camera, {});
        gesture.choose_axis(0, false);
        gesture.move_hand(camera, {0, 0}, {.fine = fine});
        gesture.move_hand(camera, {50, 0}, {.fine = fine});
        return gesture.motion().offset.x;
    };
    EXPECT_GT(moved(true), 0);
    EXPECT_LT(moved(true), 0.15 * moved(false));
}

TEST(Gesture, StaysLevelWhereTheSceneIsSeenFromTheTop)
{
    Camera top;
    top.eye = {0, -0.05, 5}; // a view from the top keeps a hair off the vertical
    top.target = {0, 0, 0};
    TransformGesture gesture(MotionKind::move, {at(1, {0, 0, 0})}, 1, {}, top, {});
    gesture.move_hand(top, {0, 0}, {});
    gesture.move_hand(top, {50, 80}, {});
    EXPECT_EQ(gesture.motion().offset.z, 0);
    EXPECT_NE(gesture.motion().offset.y, 0);
}

} // namespace
} // namespace trivar
