// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/panels/camera_frame.h"

#include "tests/editor/rig.h"
#include "ui/camera_control.h"

namespace trivar {
namespace {

constexpr double near_px = 1e-3;

// A place in the corner of the picture is seen in the corner of the frame.
void expect_corner(const Camera& kept, glm::dvec2 size_px, const ui::Rect& view)
{
    const ui::Rect frame = picture_frame(kept, size_px, view);
    Document document;
    document.kept_views["picture"] = kept;
    std::optional<FollowedView> through{FollowedView{"picture"}};
    const Camera in_picture = ui::reshaped(kept, size_px),
                 in_view = followed(through, document, {}, glm::dvec2(view.size()), size_px);
    const Ray corner = ray_through(in_picture, {0, 0});
    const glm::dvec2 seen = project(in_view, corner.origin + 3.0 * corner.direction).p_px;
    EXPECT_NEAR(view.lo.x + seen.x, frame.lo.x, near_px);
    EXPECT_NEAR(view.lo.y + seen.y, frame.lo.y, near_px);
    EXPECT_GE(frame.lo.x, view.lo.x - near_px);
    EXPECT_GE(frame.lo.y, view.lo.y - near_px);
}

TEST(CameraFrame, IsWhereTheCornersOfThePictureAreSeen)
{
    Camera kept;
    kept.size_px = {1280, 720};
    for (const bool perspective : {true, false}) {
        kept.perspective = perspective;
        for (const glm::dvec2 size : {glm::dvec2(1920, 1080), {1080, 1080}, {500, 400}})
            for (const glm::vec2 view : {glm::vec2(900, 700), {640, 360}, {1400, 500}})
                expect_corner(kept, size, {{100, 50}, glm::vec2(100, 50) + view});
    }
}

TEST(CameraFrame, HasTheShapeOfThePicture)
{
    Camera kept;
    kept.size_px = {1280, 720};
    const ui::Rect frame = picture_frame(kept, {1920, 1080}, {{0, 0}, {800, 800}});
    EXPECT_NEAR(frame.width(), 800, near_px);
    EXPECT_NEAR(frame.height(), 450, near_px);
}

} // namespace
} // namespace trivar
