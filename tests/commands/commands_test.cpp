// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/group.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/objects/view.h"
#include "core/commands/placement/place.h"
#include "core/document/document_digest.h"
#include "tests/support/scenes/commands.h"

#include <gmock/gmock.h>
#include <set>

namespace trivar {
namespace {

using ::testing::ElementsAre, ::testing::HasSubstr;
using testing::small_document, testing::small_sketch;

AddBox box_of_size(const glm::dvec3& size)
{
    AddBox box;
    box.shape.size = size;
    return box;
}

std::string rejection(const Document& document, const Command& command)
{
    try {
        after(document, command);
    } catch (const Rejected& error) {
        return error.what();
    }
    return "";
}

Document with(Document document, std::initializer_list<Command> commands)
{
    for (const Command& command : commands) document = after(document, command);
    return document;
}

TEST(Ids, AreNeverUsedTwice)
{
    const Document d = with({}, {AddBox{}, AddBox{}, Delete{{2}}, AddBox{}});
    EXPECT_FALSE(d.objects.contains(2));
    EXPECT_TRUE(d.objects.contains(3));
}

TEST(Commands, ChangeOnlyTheObjectsTheyName)
{
    const Document before = small_document();
    const Document result = after(before, SetTransform{2, {.translation = {1, 2, 3}}});
    EXPECT_EQ(result.objects.at(1), before.objects.at(1));
    EXPECT_EQ(result.objects.at(3), before.objects.at(3));
    EXPECT_NE(result.objects.at(2), before.objects.at(2));
}

TEST(Commands, ArrangeGivesEachObjectItsOwnTransformOrNoneAny)
{
    const Document before = small_document();
    const Transform moved{.translation = {1, 2, 3}}, turned{.rotation_deg = {0, 0, 30}};
    const Document result = after(before, Arrange{{2, 1}, {moved, turned}});
    EXPECT_EQ(object(result, 2).transform, moved);
    EXPECT_EQ(object(result, 1).transform, turned);
    EXPECT_EQ(result.objects.at(3), before.objects.at(3));
    EXPECT_THAT(rejection(before, Arrange{{2, 1}, {moved}}), HasSubstr("\"transforms\""));
    EXPECT_THAT(rejection(before, Arrange{{2}, {{.scale = {1, 0, 1}}}}), HasSubstr("\"scale\""));
}

TEST(Commands, LockIsNoPartOfADocumentThatWasNeverLocked)
{
    const Document before = small_document();
    const Document result = after(before, Lock{{4}});
    EXPECT_TRUE(locked(result, 1)) << "what is in a locked group is locked";
    EXPECT_FALSE(locked(result, 2));
    EXPECT_NE(digest(result), digest(before));
    EXPECT_EQ(digest(after(result, Unlock{{4}})), digest(before));
}

TEST(Commands, ShowOnlyHidesAllThatIsNeitherInItNorRoundIt)
{
    Document d = with(small_document(), {Hide{{4}}});
    d = after(d, Show{.objects = {1}, .only = true});
    EXPECT_TRUE(visible(d, 1));
    EXPECT_FALSE(visible(d, 2));
    EXPECT_FALSE(visible(d, 3));
    d = after(d, Show{.objects = {2, 4}, .only = true});
    EXPECT_TRUE(visible(d, 1)) << "what is in a group comes with it";
    EXPECT_TRUE(visible(d, 2));
    EXPECT_FALSE(visible(d, 3));
}

TEST(Commands, ReorderPutsRowsBeforeAnotherAndLaterObjectsLast)
{
    const Document d = with({}, {AddBox{}, AddBox{}, AddBox{}, AddBox{}});
    EXPECT_THAT(in_row_order(d), ElementsAre(1, 2, 3, 4));
    const Document up = after(d, Reorder{.objects = {4, 3}, .before = 1});
    EXPECT_THAT(in_row_order(up), ElementsAre(4, 3, 1, 2));
    const Document last = with(up, {Reorder{.objects = {4}}, AddBox{}, Delete{{1}}});
    EXPECT_THAT(in_row_order(last), ElementsAre(3, 2, 4, 5));
}

TEST(Commands, ReorderIntoAGroupAndOutOfItLeavesObjectsWhereTheyStand)
{
    Document d = with({}, {AddBox{}, AddBox{}, Group{{1}}});
    d = after(d, SetTransform{2, {.translation = {3, 0, 0}}});
    d = after(d, SetTransform{3, {.translation = {0, 5, 0}, .rotation_deg = {0, 0, 90}}});
    const Document in = after(d, Reorder{.objects = {2}, .parent = 3, .before = 1});
    EXPECT_EQ(object(in, 2).parent, 3);
    EXPECT_LT(glm::distance(glm::dvec3(to_world(in, 2)[3]), glm::dvec3(3, 0, 0)), 1e-12);
    EXPECT_THAT(in_row_order(in), ElementsAre(2, 1, 3));
    EXPECT_EQ(object(after(in, Reorder{.objects = {2}}), 2).parent, 0);
    EXPECT_THAT(rejection(in, Reorder{.objects = {3}, .parent = 3}), HasSubstr("in itself"));
    EXPECT_THAT(rejection(in, Reorder{.objects = {2}, .parent = 1}), HasSubstr("not a group"));
    EXPECT_THAT(rejection(in, Reorder{.objects = {3}, .before = 1}), HasSubstr("\"before\""));
}

TEST(Commands, NameTheFieldThatIsWrong)
{
    const Document d = small_document();
    EXPECT_THAT(rejection(d, box_of_size({1, std::nan(""), 1})), HasSubstr("\"size[1]\""));
    EXPECT_THAT(rejection(d, AddSphere{"Ball", {.radius = -1}, {}}), HasSubstr("\"radius\""));
    EXPECT_THAT(rejection(d, Rename{.object = 99, .name = "x"}), HasSubstr("no object 99"));
    EXPECT_THAT(rejection(d, Hide{}), HasSubstr("names no object"));
    EXPECT_THAT(rejection(d, Hide{{1, 1}}), HasSubstr("twice"));
    EXPECT_THAT(rejection(d, SetTransform{1, {.scale = {1, 0, 1}}}), HasSubstr("\"scale\""));
    EXPECT_THAT(rejection(d, SetRender{{.look = "neon"}}), HasSubstr("studio|clay|dark"));
    EXPECT_THAT(rejection(d, Rename{1, "\xC3"}), HasSubstr("UTF-8"));
    EXPECT_THAT(rejection(d, Rename{1, std::string("a\0b", 3)}),
                HasSubstr("holds the control character U+0000"));
    EXPECT_THAT(rejection(d, ForgetView{"back"}), HasSubstr("\"back\""));
}

TEST(Place, FallsOnEveryVisibleObjectThatDoesNotLieOnIt)
{
    Document d = small_document();
    EXPECT_THAT(object(d, 3).stroke->onto, ElementsAre(1, 2));
    d = with(d, {AddBox{}, Hide{{1}}, Place{2, small_sketch(), {}, {}}});
    EXPECT_THAT(object(d, 2).stroke->onto, ElementsAre(5)); // not the pot, which lies on 2
}

TEST(Place, RefusesToLieOnWhatLiesOnIt)
{
    const Document d = small_document();
    EXPECT_THAT(rejection(d, Place{1, small_sketch(), {}, {3}}),
                HasSubstr("object 3 (Pot) lies on object 1 (Table) already"));
    EXPECT_THAT(rejection(d, Place{1, small_sketch(), {}, {1}}), HasSubstr("on itself"));
    const Document stacked = with(d, {AddBox{}, Place{5, small_sketch(), {}, {3}}, Unplace{3}});
    EXPECT_EQ(rejection(stacked, Place{1, small_sketch(), {}, {3}}), "");
    EXPECT_THAT(rejection(with(d, {AddBox{}, Place{5, small_sketch(), {}, {3}}}),
                          Place{1, small_sketch(), {}, {5}}),
                HasSubstr("already"));
}

TEST(Place, OpensUpGroupsAndSaysWhenThereIsNothingToLieOn)
{
    const Document d = with(small_document(), {Place{2, small_sketch(), {}, {4}}});
    EXPECT_THAT(object(d, 2).stroke->onto, ElementsAre(1));
    EXPECT_THAT(rejection(with({}, {AddBox{}}), Place{1, small_sketch(), {}, {}}),
                HasSubstr("nothing visible"));
}

// The bounds are said once; a log that was written with more is read, and says so when it is laid.
TEST(Place, TakesAsManyControlPointsAsCanBeLaidAndReadsMore)
{
    const auto laid = [](int axis, int count) {
        PlacementParameters p;
        p.grid = {4, 4, 4};
        p.grid[axis] = count;
        const std::string line = to_json_line(Place{2, small_sketch(), p, {1}});
        const Document document = after(small_document(), command_from_json_line(line));
        return testing::new_evaluator()(document).objects.at(2)->rejected;
    };
    EXPECT_THAT(commands_markdown(), HasSubstr("| 2 to 400, 400 and 64 |"));
    for (const int axis : {0, 1, 2}) {
        const int most = axis < 2 ? most_along_or_across : most_layers;
        EXPECT_EQ(laid(axis, most), "");
        EXPECT_THAT(laid(axis, most + 1), HasSubstr("must be from 3 to " + std::to_string(most)));
        EXPECT_THAT(laid(axis, 1024), HasSubstr("is 1,024 but must be from 3"));
    }
}

TEST(Place, SaysWhatIsWrongWithAClickAndWithParametersThatDoNotFit)
{
    const Document d = small_document();
    Sketch click = small_sketch();
    click.samples.resize(1);
    EXPECT_THAT(rejection(d, Place{2, click, {}, {1}}), HasSubstr("draw a line"));
    const auto with_parameters = [&](auto&& change) {
        PlacementParameters p;
        change(p);
        return rejection(d, Place{2, small_sketch(), p, {1}});
    };
    EXPECT_THAT(with_parameters([](auto& p) { p.start = 0.6, p.fill = 0.5; }),
                HasSubstr("more than 1"));
    EXPECT_THAT(with_parameters([](auto& p) { p.grid = {1024, 1024, 4}; }), HasSubstr("\"grid\""));
    EXPECT_THAT(with_parameters([](auto& p) { p.orders.z = 6; }), HasSubstr("order 6"));
    EXPECT_THAT(with_parameters([](auto& p) { p.roll_deg = 45; }), HasSubstr("\"roll_deg\""));
    EXPECT_THAT(with_parameters([](auto& p) {
                    p.rise_profile = {{0, 0}, {0.5, 0.7}, {0.8, 0.6}, {1, 1}};
                }),
                HasSubstr("must rise"));
    EXPECT_THAT(with_parameters([](auto& p) {
                    p.height_across = {{0, 1}, {1, 0}};
                }),
                HasSubstr("\"height_across\" has the factor 0"));
    EXPECT_THAT(with_parameters([](auto& p) {
                    p.height_map = {{1, 1}, {1, 1, 1}};
                }),
                HasSubstr("\"height_map\" has rows of 2 and of 3 values"));
    EXPECT_THAT(with_parameters([](auto& p) { p.offset = 2; }), HasSubstr("\"parameters.offset\""));
}

TEST(EditPlacement, TellsHeightMapsApart)
{
    const Document before = small_document();
    PlacementParameters p = object(before, 3).stroke->parameters;
    std::set<std::string> digests{digest(before)};
    for (const auto& map : std::vector<std::vector<std::vector<double>>>{
             {{1, 1}, {1, 1}}, {{1, 1}, {1, 2}}, {{1, 2}, {1, 1}}, {{1, 1, 1}, {1, 1, 1}}}) {
        p.height_map = map;
        const Command edit = EditPlacement{3, p, {}, {}};
        digests.insert(digest(after(before, edit)));
        EXPECT_EQ(command_from_json_line(to_json_line(edit)), edit);
    }
    EXPECT_EQ(digests.size(), 5u);
}

TEST(EditPlacement, KeepsTheStrokeAndTheSupportsUnlessTheyAreGiven)
{
    const Document before = small_document();
    PlacementParameters flat;
    flat.offset = 1;
    const Document d = after(before, EditPlacement{3, flat, {}, {}});
    EXPECT_EQ(object(d, 3).stroke->sketch, object(before, 3).stroke->sketch);
    EXPECT_EQ(object(d, 3).stroke->onto, object(before, 3).stroke->onto);
    EXPECT_EQ(object(d, 3).stroke->parameters, flat);
    EXPECT_THAT(
        object(after(before, EditPlacement{3, flat, {}, std::vector<Id>{2}}), 3).stroke->onto,
        ElementsAre(2));
    EXPECT_THAT(rejection(before, EditPlacement{1, flat, {}, {}}), HasSubstr("not placed"));
}

TEST(Delete, TakesGroupsWithTheirContentsAndLeavesWhatLayOnThemOnTheRest)
{
    const Document d = after(small_document(), Delete{{4}});
    EXPECT_FALSE(d.objects.contains(1));
    EXPECT_FALSE(d.objects.contains(4));
    EXPECT_THAT(object(d, 3).stroke->onto, ElementsAre(2));
}

TEST(Duplicate, KeepsPlacementsAndLetsCopiesLieOnCopies)
{
    const Document d = after(small_document(), Duplicate{{3, 2}, {0, 0, 1}});
    EXPECT_EQ(object(d, 5).name, "Pot 2");
    EXPECT_EQ(object(d, 6).name, "Ball 2");
    EXPECT_THAT(object(d, 5).stroke->onto, ElementsAre(1, 6));
    EXPECT_EQ(object(d, 6).transform.translation, glm::dvec3(0, 0, 1));
    EXPECT_EQ(object(after(d, Duplicate{{5}, {}}), 7).name, "Pot 3");
}

TEST(Duplicate, CopiesGroupsWithTheirContents)
{
    const Document d = after(small_document(), Duplicate{{4}, {1, 0, 0}});
    EXPECT_EQ(object(d, 6).parent, 5);
    EXPECT_EQ(to_world(d, 6), glm::dmat4({1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {1, 0, 0, 1}));
}

TEST(Groups, LeaveTheirMembersWhereTheyAre)
{
    const Transform turned{{1, 2, 3}, {10, 20, 30}, {2, 2, 2}};
    Document d = with({}, {AddBox{"Box", {}, turned}, Group{{1}}, SetTransform{2, turned}});
    const glm::dmat4 before = to_world(d, 1);
    for (const Command& command :
         std::initializer_list<Command>{Group{{2}}, Ungroup{3}, Ungroup{2}}) {
        d = after(d, command);
        for (int column = 0; column < 4; ++column)
            for (int row = 0; row < 4; ++row)
                EXPECT_NEAR(to_world(d, 1)[column][row], before[column][row], 1e-12);
    }
    EXPECT_EQ(object(d, 1).parent, 0);
}

TEST(Groups, HideWhatIsInThem)
{
    const Document d = after(small_document(), Hide{{4}});
    EXPECT_FALSE(visible(d, 1));
    EXPECT_FALSE(object(d, 1).hidden);
}

TEST(Groups, DoNotNestWithoutEnd)
{
    Document d = with({}, {AddBox{}});
    std::string refused;
    for (Id top = 1; top < 200 && refused.empty(); ++top) {
        refused = rejection(d, Group{{top}});
        if (refused.empty()) d = after(d, Group{{top}});
    }
    EXPECT_THAT(refused, HasSubstr("64"));
}

TEST(Transform, TurnsByQuartersExactly)
{
    const Transform quarter{{0, 0, 0}, {0, 0, 90}, {1, 1, 1}};
    EXPECT_EQ(quarter.matrix() * glm::dvec4(1, 2, 3, 1), glm::dvec4(-2, 1, 3, 1));
}

} // namespace
} // namespace trivar
