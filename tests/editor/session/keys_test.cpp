// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/keying.h"
#include "core/commands/objects/animate.h"
#include "core/commands/objects/arrange.h"
#include "tests/editor/rig.h"

namespace trivar {
namespace {

using testing::Rig;

double height_of(const Document& document)
{
    return object(document, 1).transform.translation.z;
}

Transform raised(double z)
{
    Transform t;
    t.translation.z = z;
    return t;
}

// A sphere that rises by a metre from frame 1 to 11.
struct Rising : Rig {
    Rising()
    {
        editor.session.run(AddSphere{});
        editor.session.run(Animate{{{1, {{"transform.translation.z", {{1, 0}, {11, 1}}}}}}});
    }
};

TEST(Keys, TheSessionShowsTheValuesOfItsFrame)
{
    Rising rig;
    Session& session = rig.editor.session;
    EXPECT_EQ(height_of(session.document()), 0);
    session.show_frame(6);
    EXPECT_DOUBLE_EQ(height_of(session.document()), 0.5);
    EXPECT_EQ(height_of(session.committed()), 0) << "what was said stays";
    rig.wait();
    EXPECT_NEAR(session.evaluated().objects.at(1)->bounds->center().z, 0.5, 1e-6);
}

TEST(Keys, AChangeOfWhatIsAnimatedIsAKeyAndOneStep)
{
    Rising rig;
    Session& session = rig.editor.session;
    session.show_frame(6);
    for (const double z : {0.7, 2.0, 3.0}) ASSERT_TRUE(session.propose(SetTransform{1, raised(z)}));
    EXPECT_DOUBLE_EQ(height_of(session.document()), 3);
    ASSERT_TRUE(session.commit());
    EXPECT_EQ(track_of(session.committed(), 1, "transform.translation.z")->keys.size(), 3u);
    session.undo();
    EXPECT_DOUBLE_EQ(height_of(session.document()), 0.5);
}

TEST(Keys, AnotherSceneIsShownAtItsFirstFrame)
{
    Rising rig;
    Session& session = rig.editor.session;
    session.show_frame(9);
    session.replace_scene(SceneFile{});
    EXPECT_TRUE(session.document().objects.empty());
    EXPECT_EQ(session.frame(), 1);
}

} // namespace
} // namespace trivar
