// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/hands/gizmo.h"

#include "editor/hands/hand_motion.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

Camera seen_from(const glm::dvec3& eye)
{
    Camera camera;
    camera.eye = eye;
    camera.target = {0, 0, 0};
    return camera;
}

const HandleShape* shape_of(const std::vector<HandleShape>& shapes, GizmoHandle handle)
{
    for (const HandleShape& shape : shapes)
        if (shape.handle == handle) return &shape;
    return nullptr;
}

TEST(Gizmo, KeepsItsSizeWhereverTheEyeIs)
{
    for (const double distance : {1.0, 10.0, 1000.0}) {
        const Camera camera = seen_from(glm::normalize(glm::dvec3(1, -2, 1)) * distance);
        const auto shapes = gizmo_shapes(MotionKind::move, camera, {}, 1.5);
        const glm::vec2 center = camera.size_px / 2.0;
        float longest = 0;
        for (const HandleShape& shape : shapes)
            for (const glm::vec2& p : shape.area)
                longest = std::max(longest, glm::distance(p, center));
        EXPECT_GT(longest, 90) << distance;
        EXPECT_LT(longest, 90 * 1.5 * 1.3) << distance;
    }
}

TEST(Gizmo, IsTakenHoldOfWhereItIsSeen)
{
    const Camera camera = seen_from({3, -5, 4});
    for (const MotionKind kind : {MotionKind::move, MotionKind::rotate, MotionKind::scale})
        for (const HandleShape& shape : gizmo_shapes(kind, camera, {}, 1)) {
            // The middle of a ring's front may lie under another ring; a quarter of it does not.
            const glm::vec2 at = shape.area.empty()
                                     ? shape.line[shape.line.size() / 5]
                                     : (shape.area[0] + shape.area[1] + shape.area[2]) / 3.0f;
            EXPECT_EQ(handle_at(gizmo_shapes(kind, camera, {}, 1), at, 1), shape.handle);
        }
    EXPECT_EQ(handle_at(gizmo_shapes(MotionKind::move, camera, {}, 1), {5, 5}, 1), GizmoHandle{});
}

TEST(Gizmo, LeavesOutWhatCannotBeSeen)
{
    const auto above = gizmo_shapes(MotionKind::move, seen_from({0.001, 0, 9}), {}, 1);
    EXPECT_FALSE(shape_of(above, {Grip::axis, 2}));
    EXPECT_TRUE(shape_of(above, {Grip::axis, 0}));
    EXPECT_TRUE(shape_of(above, {Grip::plane, 2}));
    EXPECT_FALSE(shape_of(above, {Grip::plane, 0}));
    Camera away = seen_from({0, -5, 0});
    away.target = {0, -10, 0};
    EXPECT_TRUE(gizmo_shapes(MotionKind::move, away, {}, 1).empty()) << "it is behind the eye";
}

TEST(Gizmo, ShowsOnlyTheFrontOfARingUnlessItFacesTheEye)
{
    const auto shapes = gizmo_shapes(MotionKind::rotate, seen_from({0, -9, 0.01}), {}, 1);
    const HandleShape* across = shape_of(shapes, {Grip::ring, 1});
    const HandleShape* upright = shape_of(shapes, {Grip::ring, 2});
    ASSERT_TRUE(across && upright);
    EXPECT_TRUE(across->closed);
    EXPECT_TRUE(across->back.empty());
    EXPECT_FALSE(upright->closed);
    EXPECT_FALSE(upright->back.empty());
}

} // namespace
} // namespace trivar
