// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/animate.h"
#include "core/commands/objects/view.h"
#include "editor/session/followed_view.h"

#include "core/commands/keying.h"
#include "editor/actions/key_actions.h"
#include "tests/editor/rig.h"

namespace trivar {
namespace {

using testing::Rig;

// A view of pictures that moves along X from frame 1 to 101.
struct Filmed : Rig {
    Filmed()
    {
        two_objects();
        editor.session.run(KeepView{"picture", editor.session.view.camera});
        editor.session.run(Animate{{{0,
                                     {{"camera.picture.eye.x",
                                       {{.frame = 1, .value = 0, .tween = Tween::linear},
                                        {.frame = 101, .value = 5}}}}}}});
        action(editor, "Render camera").run(editor);
        wait();
    }
    double x() const { return editor.session.view.camera.eye.x; }
    void show(int frame)
    {
        editor.session.show_frame(frame);
        frames(2);
    }
};

TEST(FollowedView, GoesWithTheFrames)
{
    Filmed rig;
    EXPECT_EQ(rig.x(), 0);
    rig.show(51);
    EXPECT_DOUBLE_EQ(rig.x(), 2.5);
    rig.show(101);
    EXPECT_DOUBLE_EQ(rig.x(), 5);
}

TEST(FollowedView, StaysWhereAHandPutsTheCamera)
{
    Filmed rig;
    rig.editor.session.view.camera.eye.y -= 1;
    rig.frames(2);
    EXPECT_FALSE(rig.editor.session.view.follows);
    rig.show(51);
    EXPECT_EQ(rig.x(), 0);
    action(rig.editor, "Render camera").run(rig.editor);
    rig.frames(2);
    EXPECT_DOUBLE_EQ(rig.x(), 2.5);
}

TEST(FollowedView, AKeyOfItIsWhatTheWindowShows)
{
    Filmed rig;
    rig.editor.session.selected = 0;
    rig.show(51);
    rig.editor.session.view.camera.eye = {1, -7, 4};
    rig.move(rig.layout().view.center());
    rig.key({'I'});
    const Track* x = track_of(rig.editor.session.document(), 0, "camera.picture.eye.x");
    ASSERT_TRUE(x);
    EXPECT_EQ(value_at(*x, 51), 1);
    EXPECT_EQ(x->keys.size(), 3u);
    EXPECT_TRUE(track_of(rig.editor.session.document(), 0, "camera.picture.eye.y"));
}

TEST(FollowedView, ForgetsAViewThatIsGone)
{
    std::optional<FollowedView> view = FollowedView{"gone"};
    const Camera camera;
    EXPECT_EQ(followed(view, {}, camera, camera.size_px), camera);
    EXPECT_FALSE(view);
}

} // namespace
} // namespace trivar
