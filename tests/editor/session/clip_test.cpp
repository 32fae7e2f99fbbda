// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/import.h"
#include "core/commands/objects/play.h"
#include "core/evaluation/evaluate.h"
#include "editor/session/scene_facts.h"
#include "tests/editor/rig.h"
#include "tests/support/fixtures.h"
#include "tests/support/rigged.h"

namespace trivar {
namespace {

using testing::Rig;

// A scene of one model that bends by its clip.
class Clips : public ::testing::Test {
protected:
    Clips() : rig({1024, 900})
    {
        testing::write_file(folder.file("bar.gltf"), testing::gltf_text(testing::rigged_model()));
        SceneFile scene;
        ImportModel import;
        import.file.path = folder.file("bar.gltf");
        scene.run(import);
        rig.editor.session.replace_scene(std::move(scene));
        rig.editor.session.selected = 1;
        rig.wait();
    }
    const Playing& playing() { return object(rig.editor.session.document(), 1).playing; }
    std::string shown() { return digest(rig.editor.session.evaluated()); }
    testing::TemporaryFolder folder;
    Rig rig;
};

TEST_F(Clips, AreShownFrameByFrame)
{
    Session& session = rig.editor.session;
    EXPECT_FALSE(moves_in_time(session.document()));
    ASSERT_TRUE(session.run(PlayClip{{1}, {.clip = "bend"}}));
    EXPECT_TRUE(moves_in_time(session.document()));
    rig.wait();
    const std::string first = shown();
    rig.key({ui::key_right});
    rig.wait();
    EXPECT_EQ(session.frame(), 2);
    EXPECT_NE(shown(), first);
    rig.key({ui::key_left});
    rig.wait();
    EXPECT_EQ(shown(), first);
}

TEST_F(Clips, BeginWhenTimeIsPlayedAndNothingElseMoves)
{
    ASSERT_FALSE(moves_in_time(rig.editor.session.document()));
    rig.move(rig.layout().view.center());
    rig.key({ui::key_space});
    rig.key({ui::key_space}); // and stops
    EXPECT_EQ(playing().clip, "bend");
    const std::size_t steps = rig.steps();
    ASSERT_TRUE(rig.editor.session.run(PlayClip{{1}, {.clip = "swell"}}));
    rig.key({ui::key_space});
    EXPECT_EQ(playing().clip, "swell") << "what was chosen stays";
    EXPECT_EQ(rig.steps(), steps + 1);
}

TEST_F(Clips, AreTakenFromTheInspector)
{
    EXPECT_EQ(rig.editor.session.evaluated().objects.at(1)->clips,
              (std::vector<std::string>{"bend", "swell"}));
    // The section is the first one: the row under its title.
    const ui::Rect panel = rig.layout().inspector;
    rig.click({panel.hi.x - 80, panel.lo.y + 58 + 28 + 14});
    rig.key({ui::key_down});
    rig.key({ui::key_enter});
    rig.wait();
    EXPECT_EQ(playing().clip, "bend");
    EXPECT_EQ(playing().speed, 1);
    rig.editor.session.undo();
    EXPECT_EQ(playing().clip, "");
}

} // namespace
} // namespace trivar
