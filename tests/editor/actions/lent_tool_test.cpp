// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/actions/actions.h"
#include "tests/editor/rig.h"
#include "tests/support/fixtures.h"

namespace trivar {
namespace {

using testing::Rig;

struct Hand : Rig {
    Hand() { two_objects(); }
    std::string tool() { return editor.active_tool().name(); }
};

TEST(LentTool, GoesWithItsKeyWhenSomethingWasDoneWithIt)
{
    Hand hand;
    const std::size_t before = hand.steps();
    hand.move(hand.layout().view.center());
    hand.hold('D');
    EXPECT_EQ(hand.tool(), "Place");
    hand.draw(hand.stroke());
    hand.wait();
    EXPECT_EQ(hand.tool(), "Place");
    hand.hold('D', false);
    EXPECT_EQ(hand.tool(), "Select");
    EXPECT_EQ(hand.steps(), before + 1);
}

TEST(LentTool, FinishesWhatItDoesThoughItsKeyIsUp)
{
    Hand hand;
    hand.move(hand.layout().view.center());
    hand.hold('D');
    hand.draw(hand.stroke(), false);
    hand.hold('D', false);
    EXPECT_EQ(hand.tool(), "Place");
    EXPECT_TRUE(hand.editor.active_tool().busy());
    hand.screen.input().push(ui::press(ui::Button::left, false));
    hand.wait();
    EXPECT_EQ(hand.tool(), "Select");
}

TEST(LentTool, StaysWhenItsKeyIsOnlyTapped)
{
    Hand hand;
    hand.move(hand.layout().view.center());
    hand.hold('D');
    hand.hold('D', false);
    EXPECT_EQ(hand.tool(), "Place");
    hand.draw(hand.stroke());
    hand.wait();
    EXPECT_EQ(hand.tool(), "Place");
}

// A plane, and models to add that are all a small box.
struct WithModels : testing::Rig {
    WithModels()
    {
        AddBox box;
        box.shape.size = {1.2, 0.3, 0.3};
        EXPECT_TRUE(editor.session.run(box));
        wait();
        for (const char* name : {"snake", "terrain"}) {
            editor.files.write_model_to(folder.file(name) + std::string(".glb"));
            wait();
        }
        editor.session.undo();
        editor.files.own_models_folder = folder.path().string();
        wait();
    }
    void add_plane()
    {
        AddPlane plane;
        plane.shape.size = {6, 6};
        ASSERT_TRUE(editor.session.run(plane));
        editor.session.view.camera.eye = {0.5, -6, 4};
        editor.session.view.camera.target = {0, 0, 0};
        wait();
    }
    void add(const char* model)
    {
        action(editor, model).run(editor);
        wait();
    }
    std::string tool() { return editor.active_tool().name(); }
    bool is_laid(Id id) const { return object(editor.session.document(), id).stroke.has_value(); }
    testing::TemporaryFolder folder;
};

TEST(LentTool, PlaceIsThereForOneStrokeWhenAModelIsAddedOverSomething)
{
    WithModels hand;
    hand.add_plane();
    hand.add("Snake");
    EXPECT_EQ(hand.tool(), "Place");
    EXPECT_EQ(hand.editor.session.selected, 2);
    // A stroke that could not be used is no stroke.
    hand.draw({hand.layout().view.center(), hand.layout().view.center()});
    hand.wait();
    EXPECT_EQ(hand.tool(), "Place");
    hand.draw(hand.stroke());
    hand.wait();
    EXPECT_TRUE(hand.is_laid(2));
    EXPECT_EQ(hand.tool(), "Select");
    hand.editor.session.undo();
    hand.wait();
    EXPECT_EQ(hand.tool(), "Select") << "an undo lends nothing again";
}

TEST(LentTool, PlaceLaysTheModelThatWasAddedWhateverWasChosenBefore)
{
    WithModels hand;
    hand.add_plane();
    hand.add("Snake");
    hand.draw(hand.stroke());
    hand.wait();
    hand.add("Snake");
    EXPECT_EQ(hand.editor.session.selected, 3);
    hand.draw(hand.stroke());
    hand.wait();
    EXPECT_TRUE(hand.is_laid(3));
    EXPECT_EQ(hand.tool(), "Select");
}

TEST(LentTool, EscapeLeavesTheModelWhereItStands)
{
    WithModels hand;
    hand.add_plane();
    hand.add("Snake");
    const Transform stood = object(hand.editor.session.document(), 2).transform;
    hand.key({.key = ui::key_escape});
    EXPECT_EQ(hand.tool(), "Select");
    EXPECT_FALSE(hand.is_laid(2));
    EXPECT_EQ(object(hand.editor.session.document(), 2).transform, stood);
    hand.key({'D'});
    hand.draw(hand.stroke());
    hand.wait();
    EXPECT_EQ(hand.tool(), "Place") << "it was chosen now";
}

TEST(LentTool, PlaceIsNotLentForWhatNothingIsUnderOrForWhatOthersAreLaidOn)
{
    WithModels hand;
    hand.add("Snake");
    EXPECT_EQ(hand.tool(), "Select") << "nothing is there";
    hand.add("Terrain");
    EXPECT_EQ(hand.tool(), "Select");
}

TEST(LentTool, PlaceGoesWithTheModelThatItWasLentFor)
{
    WithModels hand;
    hand.add_plane();
    hand.add("Snake");
    ASSERT_EQ(hand.tool(), "Place");
    hand.editor.session.undo();
    hand.wait();
    EXPECT_EQ(hand.tool(), "Select");
}

} // namespace
} // namespace trivar
