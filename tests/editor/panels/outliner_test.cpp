// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/session/outline.h"

#include "editor/actions/actions.h"
#include "editor/session/scene_facts.h"
#include "tests/editor/rig.h"
#include "tests/editor/scenes.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::ElementsAre, ::testing::IsEmpty;
using testing::Rig;

std::vector<Id> ids_of(const std::vector<OutlineRow>& rows)
{
    std::vector<Id> ids;
    for (const OutlineRow& row : rows) ids.push_back(row.id);
    return ids;
}

// 1 Table, 2 Chair, 3 Lamp; 4 Room with 1 and 2.
Document room()
{
    Document d;
    for (const char* name : {"Table", "Chair", "Lamp"}) {
        AddBox box;
        box.name = name;
        d = after(d, box);
    }
    return after(d, Group{.objects = {1, 2}, .name = "Room"});
}

TEST(Outline, ShowsGroupsAboveWhatIsInThemAndNothingOfClosedOnes)
{
    EXPECT_THAT(ids_of(outline(room(), "", {})), ElementsAre(3, 4, 1, 2));
    EXPECT_THAT(ids_of(outline(room(), "", {4})), ElementsAre(3, 4));
}

TEST(Outline, FilterKeepsWhatAMatchIsInAndFindsTypes)
{
    EXPECT_THAT(ids_of(outline(room(), "tbl", {4})), ElementsAre(4, 1));
    EXPECT_FALSE(outline(room(), "tbl", {}).front().found);
    EXPECT_THAT(ids_of(outline(room(), "type:group", {})), ElementsAre(4));
    EXPECT_THAT(ids_of(outline(room(), "type:prim l", {})), ElementsAre(3, 4, 1));
    EXPECT_THAT(outline(room(), "type:volume", {}), IsEmpty());
}

TEST(Outline, ADropBetweenRowsOrdersAndOneOntoAGroupGoesIntoIt)
{
    const Document d = room();
    const auto rows = outline(d, "", {}); // 3 4 1 2
    const RowDrop onto = row_drop(d, rows, {3}, 1.5);
    EXPECT_EQ(onto.onto, 1);
    EXPECT_THAT(ids_of(outline(after(d, onto.command), "", {})), ElementsAre(4, 1, 2, 3));
    const RowDrop first_inside = row_drop(d, rows, {3}, 1.9);
    EXPECT_EQ(first_inside.line, 2);
    EXPECT_THAT(ids_of(outline(after(d, first_inside.command), "", {})), ElementsAre(4, 3, 1, 2));
    const RowDrop swapped = row_drop(d, rows, {2}, 2.1);
    EXPECT_THAT(ids_of(outline(after(d, swapped.command), "", {})), ElementsAre(3, 4, 2, 1));
    const RowDrop last = row_drop(d, rows, {1, 3}, 9);
    EXPECT_THAT(ids_of(outline(after(d, last.command), "", {})), ElementsAre(4, 2, 3, 1));
    EXPECT_THAT(row_drop(d, rows, {3}, 0.1).command.objects, IsEmpty()) << "it is there already";
    EXPECT_THAT(row_drop(d, rows, {3}, 0.9).command.objects, IsEmpty());
}

TEST(Outline, ADropThatCannotBeSaysWhy)
{
    const Document d = room();
    const auto rows = outline(d, "", {});
    EXPECT_NE(row_drop(d, rows, {3}, 2.5).refused, "") << "a box holds nothing";
    EXPECT_NE(row_drop(d, rows, {4}, 2.1).refused, "") << "a group is not in itself";
    EXPECT_NE(row_drop(d, rows, {4}, 1.5).refused, "");
}

struct Room : Rig {
    Room()
    {
        for (const char* name : {"A", "B", "C"}) {
            AddBox box;
            box.name = name;
            box.transform.translation = {2.0 * static_cast<double>(steps()) - 2, 0, 0};
            editor.session.run(box);
        }
        editor.session.run(Group{.objects = {3}, .name = "G"});
        editor.session.view.camera.eye = {0, -12, 2};
        editor.session.view.camera.target = {0, 0, 0};
        wait();
    }
    glm::vec2 row(float i) const { return layout().outliner.lo + glm::vec2(90, 72 + 24 * i); }
    glm::vec2 eye(int i) const
    {
        return {layout().outliner.hi.x - 44, row(static_cast<float>(i) + 0.5f).y};
    }
    std::vector<Id> rows() const { return ids_of(outline(editor.session.document(), "", {})); }
    bool hidden(Id id) const { return object(editor.session.committed(), id).hidden; }
};

TEST(OutlinerByHand, DraggingRowsIsOneStepAndEscapeLeavesNone)
{
    Room rig;
    ASSERT_THAT(rig.rows(), ElementsAre(1, 2, 4, 3));
    rig.draw({rig.row(0.5f), rig.row(2.5f)});
    EXPECT_THAT(rig.rows(), ElementsAre(2, 4, 3, 1));
    EXPECT_EQ(object(rig.editor.session.document(), 1).parent, 4);
    EXPECT_EQ(rig.steps(), 5u);
    rig.draw({rig.row(0.5f), rig.row(2.5f)}, false);
    rig.key({ui::key_escape});
    rig.screen.input().push(ui::press(ui::Button::left, false));
    rig.frames();
    EXPECT_EQ(rig.steps(), 5u);
    rig.draw({rig.row(0.5f), rig.row(2.5f)}); // onto a box
    EXPECT_EQ(rig.steps(), 5u);
}

TEST(OutlinerByHand, RowsComeWhileOneIsHeldAtAnEdge)
{
    Rig rig;
    rig.editor.session.replace_scene(testing::scene_of_1000_objects());
    rig.wait();
    const auto before = ids_of(outline(rig.editor.session.document(), "", {}));
    const ui::Rect r = rig.layout().outliner;
    const glm::vec2 first = r.lo + glm::vec2(60, 72 + 12);
    rig.screen.input().push(ui::move_to(first));
    rig.screen.input().push(ui::press(ui::Button::left));
    rig.frames(3);
    rig.move(first + glm::vec2(0, 8));
    rig.move({first.x, r.hi.y - 4});
    rig.frames(60);
    EXPECT_TRUE(rig.editor.outliner.scrolling);
    rig.screen.input().push(ui::press(ui::Button::left, false));
    rig.frames(4);
    EXPECT_FALSE(rig.editor.outliner.scrolling);
    const auto after = ids_of(outline(rig.editor.session.document(), "", {}));
    const auto seen = static_cast<std::ptrdiff_t>((r.height() - 72) / 24);
    EXPECT_GT(std::ranges::find(after, before.front()) - after.begin(), seen + 2)
        << "farther down than rows were seen";
}

TEST(OutlinerByHand, PaintingDownTheEyesIsOneStep)
{
    Room rig;
    rig.draw({rig.eye(0), rig.eye(2)});
    EXPECT_TRUE(rig.hidden(1) && rig.hidden(2) && rig.hidden(4));
    EXPECT_FALSE(rig.hidden(3)) << "it keeps its own eye";
    EXPECT_EQ(rig.steps(), 5u);
    rig.draw({rig.eye(0), rig.eye(1)}, false);
    EXPECT_TRUE(rig.editor.session.proposing());
    rig.key({ui::key_escape});
    rig.screen.input().push(ui::press(ui::Button::left, false));
    rig.frames();
    EXPECT_EQ(rig.steps(), 5u);
    EXPECT_TRUE(rig.hidden(1));
}

TEST(OutlinerByHand, AltOnAnEyeShowsOnlyThatOneAndThenAllAgain)
{
    Room rig;
    rig.hold(ui::key_left_alt);
    rig.click(rig.eye(1));
    EXPECT_TRUE(rig.hidden(1) && !rig.hidden(2) && rig.hidden(4));
    EXPECT_EQ(rig.steps(), 5u);
    rig.click(rig.eye(1));
    EXPECT_FALSE(rig.hidden(1) || rig.hidden(2) || rig.hidden(4));
    rig.hold(ui::key_left_alt, false);
}

TEST(OutlinerByHand, ArrowsGoFromRowToRowAndEnterRenames)
{
    Room rig;
    rig.click(rig.row(0.5f));
    rig.key({ui::key_down});
    rig.key({ui::key_down});
    EXPECT_EQ(rig.editor.session.selected, 4);
    rig.key({ui::key_left});
    EXPECT_TRUE(rig.editor.outliner.closed.contains(4));
    rig.key({ui::key_right});
    rig.key({ui::key_right});
    EXPECT_EQ(rig.editor.session.selected, 3);
    rig.key({ui::key_left});
    EXPECT_EQ(rig.editor.session.selected, 4);
    rig.key({ui::key_enter});
    rig.type("Z");
    rig.key({ui::key_enter});
    EXPECT_EQ(name_of(rig.editor.session.document(), 4), "Z");
}

TEST(OutlinerByHand, TheEnterThatEndsAMoveRenamesNothing)
{
    Room rig;
    rig.click(rig.row(0.5f));
    rig.move(rig.layout().view.center());
    rig.key({'G'});
    rig.type("1");
    rig.key({ui::key_enter});
    EXPECT_EQ(rig.steps(), 5u);
    EXPECT_EQ(rig.editor.outliner.renaming, 0);
}

TEST(OutlinerByHand, CtrlFGoesToTheFilterAndEscapeClearsIt)
{
    Room rig;
    rig.key({.key = 'F', .ctrl = true});
    rig.type("b");
    EXPECT_EQ(rig.editor.outliner.filter, "b");
    rig.key({ui::key_escape});
    EXPECT_EQ(rig.editor.outliner.filter, "");
}

TEST(OutlinerByHand, WhatIsLockedIsNotPickedNorMovedNorDeleted)
{
    Room rig;
    rig.editor.session.run(Lock{{1}});
    rig.wait();
    rig.click(rig.seen_at({-2, -0.5, 0}));
    EXPECT_EQ(rig.editor.session.selected, 0);
    rig.key({'A'});
    EXPECT_FALSE(rig.editor.session.selected.contains(1));
    rig.editor.session.selected = 1;
    rig.key({'G'});
    EXPECT_FALSE(rig.editor.active_tool().busy());
    rig.key({ui::key_delete});
    EXPECT_TRUE(rig.editor.session.document().objects.contains(1));
    EXPECT_EQ(rig.steps(), 5u);
}

} // namespace
} // namespace trivar
