// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/tools/place_round.h"

#include "editor/actions/actions.h"
#include "editor/actions/placement_actions.h"
#include "tests/editor/rig.h"

namespace trivar {
namespace {

// A plane, a box, and a column.
struct RoundRig : testing::Rig {
    RoundRig()
    {
        two_objects();
        AddCylinder column;
        column.shape.height = 2;
        EXPECT_TRUE(editor.session.run(column));
        wait();
    }
    const std::optional<PlacementStep>& step(Id id) const
    {
        return object(editor.session.document(), id).stroke;
    }
    bool can() { return is_enabled(editor, action(editor, place_round_action)); }
    void run()
    {
        action(editor, place_round_action).run(editor);
        wait();
    }
};

TEST(PlaceRoundAction, LaysTheSelectedModelRoundTheOtherInOneStep)
{
    RoundRig rig;
    EXPECT_EQ(action(rig.editor, place_round_action).menu, "Add");
    for (const std::vector<Id>& selected : {std::vector<Id>{2, 3}, {3, 2}, {2}}) {
        rig.editor.session.selected.set(selected);
        rig.frames();
        ASSERT_TRUE(rig.can());
        const std::size_t steps = rig.steps();
        rig.run();
        EXPECT_EQ(rig.steps(), steps + 1);
        ASSERT_TRUE(rig.step(2) && rig.step(2)->round);
        EXPECT_EQ(rig.step(2)->onto, std::vector<Id>{3});
        ASSERT_TRUE(rig.editor.session.evaluated().objects.at(2)->placement);
        EXPECT_FALSE(rig.step(3));
        EXPECT_EQ(rig.editor.session.selected, 2);
        rig.editor.session.undo();
        rig.wait();
        EXPECT_FALSE(rig.step(2));
    }
}

TEST(PlaceRoundAction, NeedsABodyAndSaysWhyItCannotBe)
{
    RoundRig rig;
    rig.editor.session.selected.set({1, 2});
    EXPECT_FALSE(rig.can()) << "neither is round";
    ASSERT_TRUE(rig.editor.session.run(AddSphere{}));
    rig.wait();
    rig.editor.session.selected.set({2});
    EXPECT_FALSE(rig.can()) << "there are two bodies to go round";
    EXPECT_EQ(bodies_to_go_round(rig.editor.session, 2), (std::vector<Id>{3, 4}));
    EXPECT_EQ(bodies_to_go_round(rig.editor.session, 3), (std::vector<Id>{4}));
    // Far too wide for what it would go round: nothing changes.
    PlacementParameters wide;
    wide.width = 50;
    ASSERT_TRUE(rig.editor.session.run(PlaceRound{2, 3, 0, {}}));
    rig.wait();
    ASSERT_TRUE(rig.editor.session.run(EditPlacement{2, wide, {}, {}}));
    rig.wait();
    const std::size_t steps = rig.steps();
    lay_round(rig.editor.session, {2, 4});
    rig.wait();
    EXPECT_EQ(rig.steps(), steps);
    EXPECT_EQ(rig.editor.session.notices.all().back().title, "Nothing was placed");
}

} // namespace
} // namespace trivar
