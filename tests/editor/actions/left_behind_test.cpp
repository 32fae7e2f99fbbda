// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/cutting/incise.h"
#include "core/commands/cutting/split.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/placement/place.h"
#include "core/commands/tiles/mix_tiles.h"
#include "core/commands/tiles/tiles.h"
#include "core/commands/volumes/lattice.h"
#include "editor/actions/left_behind.h"

#include "core/commands/command.h"
#include "editor/actions/actions.h"
#include "tests/editor/laid.h"
#include "tests/editor/notice_buttons.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::ElementsAre, ::testing::IsEmpty;
using testing::press_button;

// On boxes 1 and 2, of which 2 is merely passed, and with a box 4 below, lies 3.
Document laid_on_a_box(bool both_touched)
{
    Document document;
    for (int i = 0; i < 4; ++i) document = after(document, AddBox{});
    Sketch sketch;
    sketch.samples = {{{400, 360}, 0, 1}, {{800, 360}, 1, 1}};
    document = after(document, Place{3, sketch, {}, {1, 2, 4}});
    Attachment attachment;
    for (const Id id : {1, 2})
        attachment.hosts.push_back(attached_host(id, glm::dmat4(1), id == 1 || both_touched));
    attachment.samples = {{.host = 0}, {.host = both_touched ? 1 : -1}};
    return after(document, Attach{3, attachment});
}

LeftBehind left_when_deleted(const Document& document, const std::vector<Id>& ids)
{
    return left_behind(document, after(document, Delete{ids}), [](Id, Id) { return false; });
}
std::vector<std::string> said_when_deleted(const Document& document, const std::vector<Id>& ids)
{
    return left_when_deleted(document, ids).lines;
}

TEST(LeftBehind, IsToldByWhatBecomesOfIt)
{
    const Document one = laid_on_a_box(false), both = laid_on_a_box(true);
    const std::string drawn = "Box goes with nothing now and lies where it was drawn.";
    EXPECT_THAT(said_when_deleted(both, {1}),
                ElementsAre("Box goes with the rest of what carried it."));
    EXPECT_THAT(said_when_deleted(both, {1, 2}), ElementsAre(drawn));
    EXPECT_THAT(said_when_deleted(one, {1}), ElementsAre(drawn))
        << "what it merely passes does not carry it";
    EXPECT_THAT(said_when_deleted(both, {1, 2, 4}),
                ElementsAre("Box has nothing left to lie on and stands straight. Place it anew."));
}

TEST(LeftBehind, IsNothingWhereNothingThatCarriedWent)
{
    const Document one = laid_on_a_box(false), both = laid_on_a_box(true);
    EXPECT_THAT(said_when_deleted(one, {2}), IsEmpty());
    EXPECT_THAT(said_when_deleted(both, {4}), IsEmpty());
    EXPECT_THAT(said_when_deleted(both, {1, 2, 3}), IsEmpty()) << "it went along";
}

// Along the equator of a ball of radius 0.4.
std::vector<SurfacePoint> along_equator()
{
    std::vector<SurfacePoint> out;
    for (int i = 0; i < 5; ++i) {
        const glm::dvec3 n{std::cos(0.2 * i), std::sin(0.2 * i), 0};
        out.push_back({0.4 * n, n});
    }
    return out;
}

TileStroke scales()
{
    TileStroke stroke;
    for (const SurfacePoint& at : along_equator())
        stroke.samples.push_back({at, 0.1 * static_cast<double>(stroke.samples.size()), 1});
    return stroke;
}

// On the ball 1 is painted with box 2, mixed with 3, which turns into 4; what cuts the ball 1 open
// is 5, and what parts 6 is 7.
Document all_kinds()
{
    Document document =
        after(Document{}, AddSphere{.name = "Ball", .shape = {.radius = 0.4}, .transform = {}});
    for (const char* name : {"Scale", "Leaf", "Flower", "Knife", "Wall", "Bar"})
        document = after(document, AddBox{.name = name, .shape = {}, .transform = {}});
    document = after(document, PaintTiles{.object = 2, .base = 1, .stroke = scales()});
    document = after(document, MixTiles{2, 1, {{3, 1}}});
    document = after(document, MorphTiles{2, 4});
    NamedIncision cut;
    cut.cut.stroke = along_equator();
    cut.cut.depth = cut.cut.width = 0.05;
    cut.blade = 5;
    document = after(document, Incise{.object = 1, .incision = cut});
    return after(document, Split{{6}, {.obstacles = {{7}}}});
}

TEST(LeftBehind, NamesEveryKindOfDependence)
{
    const Document document = all_kinds();
    const auto said = [&](Id id) { return said_when_deleted(document, {id}); };
    EXPECT_THAT(said(1), ElementsAre("Scale is no longer painted on Ball."));
    EXPECT_THAT(said(3), ElementsAre("Scale is no longer mixed with Leaf."));
    EXPECT_THAT(said(4), ElementsAre("Scale is no longer turned into Flower."));
    EXPECT_THAT(said(5), ElementsAre("Ball is no longer opened by Knife."));
    EXPECT_THAT(said(7), ElementsAre("Wall is no longer split by Bar."));
    EXPECT_THAT(said(6), IsEmpty());
    const LeftBehind both = left_when_deleted(document, {1, 7});
    EXPECT_THAT(both.dependents, ElementsAre(2, 6));
    EXPECT_THAT(both.gone, ElementsAre(1, 7));
}

TEST(LeftBehind, SaysWhatGoesWithALattice)
{
    Document document = after(after(Document{}, AddBox{}), AddLattice{.objects = {1}});
    EXPECT_THAT(said_when_deleted(document, {2}), ElementsAre("Box went with the lattice."));
    EXPECT_THAT(said_when_deleted(document, {1}), IsEmpty());
}

TEST(LeftBehind, IsBoundToAnotherObjectBesideTheDeletion)
{
    testing::Rig rig;
    Session& session = rig.editor.session;
    session.run(AddSphere{.name = "Ball", .shape = {.radius = 0.4}, .transform = {}});
    session.run(AddBox{.name = "Scale", .shape = {.size = {0.1, 0.1, 0.1}}, .transform = {}});
    session.run(AddSphere{.name = "Other", .shape = {.radius = 0.4}, .transform = {}});
    session.run(PaintTiles{.object = 2, .base = 1, .stroke = scales()});
    session.run(AddBox{.name = "Wall", .shape = {}, .transform = {}});
    session.run(Split{{4}, {.obstacles = {{1}}}});
    session.selected = 1;
    action(rig.editor, "Delete").run(rig.editor);
    rig.wait();
    EXPECT_FALSE(object(session.committed(), 4).splitting);
    press_button(rig.editor, "Bind to...");
    rig.frames(3);
    const BindChoice& choice = rig.editor.memory.of<BindChoice>();
    EXPECT_THAT(can_be_bound_to(rig.editor, choice.dependents), ElementsAre(3));
    bind_to(rig.editor, choice, 3);
    rig.wait();
    EXPECT_FALSE(session.committed().objects.contains(1));
    EXPECT_EQ(object(session.committed(), 2).tiles->base, 3);
    ASSERT_TRUE(object(session.committed(), 4).splitting);
    EXPECT_EQ(object(session.committed(), 4).splitting->obstacles.front().object, 3);
    EXPECT_FALSE(session.evaluated().objects.at(2)->shows_nothing());
}

TEST(LeftBehind, IsBoundAfterOtherStepsWhereItLiesOnNothing)
{
    testing::Rig rig;
    Session& session = rig.editor.session;
    session.run(AddSphere{.name = "Ball", .shape = {.radius = 0.4}, .transform = {}});
    session.run(AddBox{.name = "Scale", .shape = {.size = {0.1, 0.1, 0.1}}, .transform = {}});
    session.run(PaintTiles{.object = 2, .base = 1, .stroke = scales()});
    session.run(AddBox{.name = "Wall", .shape = {}, .transform = {}});
    session.run(Split{{3}, {.obstacles = {{1}}}});
    session.selected = 1;
    action(rig.editor, "Delete").run(rig.editor);
    session.run(AddSphere{.name = "Other", .shape = {.radius = 0.4}, .transform = {}});
    press_button(rig.editor, "Undo");
    EXPECT_TRUE(session.committed().objects.contains(4)) << "no step is lost";
    bind_to(rig.editor, rig.editor.memory.of<BindChoice>(), 4);
    EXPECT_EQ(object(session.committed(), 2).tiles->base, 4);
}

TEST(LeftBehind, IsSaidInTheWindowInOneStep)
{
    testing::LaidRig rig;
    ASSERT_TRUE(rig.step().attach);
    rig.editor.session.selected = 1;
    rig.editor.session.notices.clear();
    const std::size_t steps = rig.steps();
    action(rig.editor, "Delete").run(rig.editor);
    rig.wait();
    ASSERT_EQ(rig.editor.session.notices.all().size(), 1u);
    EXPECT_EQ(rig.editor.session.notices.all().front().title, "Deleted");
    EXPECT_EQ(rig.editor.session.notices.all().front().body,
              "Box has nothing left to lie on and stands straight. Place it anew.");
    EXPECT_EQ(rig.steps(), steps + 1);
    rig.editor.session.undo();
    rig.wait();
    EXPECT_TRUE(rig.step().attach);
    EXPECT_TRUE(rig.is_laid());
}

} // namespace
} // namespace trivar
