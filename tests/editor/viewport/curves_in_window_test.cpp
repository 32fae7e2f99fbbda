// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/import.h"
#include "tests/editor/rig.h"
#include "tests/support/fixtures.h"

namespace trivar {
namespace {

using testing::Rig;

// A horizontal line (object 1) of two units through the middle of the view.
class CurvesInWindow : public ::testing::Test {
protected:
    CurvesInWindow()
    {
        testing::write_file(folder_.file("line.obj"), "v -1 0 0\nv 0 0 0\nv 1 0 0\nl 1 2 3\n");
        ImportModel import;
        import.file.path = folder_.file("line.obj");
        EXPECT_TRUE(rig.editor.session.run(import));
        look();
        rig.editor.session.selected = 0;
    }
    void look()
    {
        rig.editor.session.view.camera.eye = {0, -6, 0};
        rig.editor.session.view.camera.target = {0, 0, 0};
        rig.wait();
        rig.screen.settle(rig.body(), 400);
    }
    testing::TemporaryFolder folder_;
    Rig rig;
};

TEST_F(CurvesInWindow, AreSelectedByAClickAFewPixelsBesideThem)
{
    const glm::vec2 on = rig.seen_at({0.5, 0, 0});
    rig.click(on + glm::vec2(0, 12));
    EXPECT_EQ(rig.editor.session.selected, 0);
    rig.click(on + glm::vec2(0, 4));
    EXPECT_EQ(rig.editor.session.selected, 1);
}

TEST_F(CurvesInWindow, AreSelectedByABoxThatTheyRunThrough)
{
    rig.draw({rig.seen_at({0.3, 0, 0.4}), rig.seen_at({0.6, 0, -0.4})});
    EXPECT_EQ(rig.editor.session.selected, 1);
}

TEST_F(CurvesInWindow, AreInViewWhenTheSelectionIsFramed)
{
    rig.editor.session.selected = 1;
    rig.editor.session.view.camera.eye = {200, -600, 30};
    action(rig.editor, "Frame selection").run(rig.editor);
    rig.wait();
    const Camera& camera = rig.editor.session.view.camera;
    for (const double x : {-1.0, 1.0}) {
        const glm::dvec2 p = project(camera, {x, 0, 0}).p_px;
        EXPECT_TRUE(p.x > 0 && p.x < camera.size_px.x) << p.x;
    }
    // In the middle of what the hint card leaves of the picture.
    const glm::dvec2 middle = project(camera, glm::dvec3(0)).p_px;
    EXPECT_NEAR(middle.x, camera.size_px.x / 2, 20);
    EXPECT_NEAR(middle.y, (camera.size_px.y - rig.editor.session.view.foot_px) / 2, 20);
}

TEST_F(CurvesInWindow, AreNoObjectThatCannotBeShown)
{
    EXPECT_TRUE(rig.editor.session.evaluated().objects.at(1)->notices.empty());
    EXPECT_FALSE(rig.editor.session.evaluated().objects.at(1)->shows_nothing());
}

} // namespace
} // namespace trivar
