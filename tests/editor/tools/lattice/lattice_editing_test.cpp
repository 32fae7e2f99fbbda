// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/keying.h"
#include "core/commands/placement/place.h"
#include "core/commands/volumes/lattice.h"
#include "core/commands/volumes/warp.h"
#include "core/placement/placement.h"
#include "editor/hands/parts_tool.h"
#include "tests/editor/rig.h"

namespace trivar {
namespace {

// A ball in a lattice of 4 x 4 x 4 points (object 2), seen from the front, with the Lattice tool.
struct BoxRig : testing::Rig {
    explicit BoxRig(const Transform& transform = {}) : Rig({1100, 800})
    {
        EXPECT_TRUE(editor.session.run(AddSphere{.shape = {.radius = 0.4}}));
        EXPECT_TRUE(editor.session.run(AddLattice{.objects = {1}, .transform = transform}));
        editor.session.selected = 2;
        editor.session.view.camera.eye = {0.4, -5, 1.5};
        editor.session.view.camera.target = {0, 0, 0};
        key({'V'});
        wait();
    }
    glm::dvec3 point(const glm::ivec3& p) const
    {
        return control_point(editor.session.evaluated().objects.at(2)->placement->volume, p.x, p.y,
                             p.z);
    }
    std::size_t shaped() const { return object(editor.session.document(), 2).shaping.size(); }
    const PointShift& last() const
    {
        return *object(editor.session.document(), 2).shaping.back()->shift;
    }
    void double_click(const glm::ivec3& p)
    {
        const glm::vec2 at = seen_at(point(p));
        screen.input().push(ui::move_to(at));
        for (const double time_s : {0.0, 0.1})
            for (const bool down : {true, false})
                screen.input().push(ui::press(ui::Button::left, down, 1000 + time_s));
        frames(8);
    }
    // Edits by a key, along an axis, by the typed amount.
    void by_keys(int kind, int axis, const std::string& amount)
    {
        move(layout().view.center() + glm::vec2(200, 100));
        key({kind});
        key({axis});
        type(amount);
        key({ui::key_enter});
        wait();
    }
    void drag(const glm::ivec3& from, glm::vec2 by)
    {
        const glm::vec2 at = seen_at(point(from));
        move(at);
        draw({at, at + by});
        wait();
    }
};
constexpr glm::ivec3 corner(0, 0, 3);

TEST(LatticeEditing, ChoosesARowByADoubleClickAndTheNextOneByAnother)
{
    BoxRig rig;
    rig.double_click(corner);
    rig.by_keys('G', 'Z', "0.1");
    ASSERT_EQ(rig.shaped(), 1u);
    const std::vector<glm::ivec3> row = rig.last().points;
    EXPECT_EQ(row.size(), 4u);
    EXPECT_EQ(rig.last().by, glm::dvec3(0, 0, 0.1));
    rig.double_click(corner);
    rig.by_keys('G', 'Z', "0.1");
    EXPECT_EQ(rig.last().points.size(), 4u);
    EXPECT_NE(rig.last().points, row);
}

TEST(LatticeEditing, ChoosesAPlaneByADoubleClickWithShift)
{
    BoxRig rig;
    rig.hold(ui::key_left_shift);
    rig.double_click(corner);
    rig.hold(ui::key_left_shift, false);
    rig.by_keys('G', 'Y', "-0.1");
    ASSERT_EQ(rig.shaped(), 1u);
    ASSERT_EQ(rig.last().points.size(), 16u);
    for (const glm::ivec3& p : rig.last().points) EXPECT_EQ(p.y, 0); // looks at the eye
}

TEST(LatticeEditing, ChoosesAllPointsNoneTheOthersAndTheNextOnesByTheKeysOfObjects)
{
    BoxRig rig;
    const auto moved = [&] {
        rig.by_keys('G', 'Z', "0.01");
        return rig.last().points.size();
    };
    rig.key({'A'});
    EXPECT_EQ(moved(), 64u);
    rig.key({.key = 'A', .alt = true});
    rig.drag(corner, {0, 0});
    EXPECT_EQ(moved(), 1u);
    rig.key({ui::key_equal});
    EXPECT_EQ(moved(), 4u);
    rig.key({.key = 'I', .ctrl = true});
    EXPECT_EQ(moved(), 60u);
    EXPECT_EQ(rig.editor.session.selected.ids(), std::vector<Id>{2});
}

TEST(LatticeEditing, TurnsAndScalesTheChosenPointsInOneStepEach)
{
    BoxRig rig;
    rig.hold(ui::key_left_shift);
    rig.double_click(corner);
    rig.hold(ui::key_left_shift, false);
    rig.by_keys('R', 'Y', "20");
    ASSERT_EQ(rig.shaped(), 1u);
    EXPECT_LT(glm::length(rig.last().rotation_deg - glm::dvec3(0, 20, 0)), 1e-9);
    rig.by_keys('S', 'X', "0.5");
    ASSERT_EQ(rig.shaped(), 2u);
    EXPECT_LT(glm::length(rig.last().factors - glm::dvec3(0.5, 1, 1)), 1e-9);
    rig.editor.session.undo();
    rig.wait();
    EXPECT_EQ(rig.shaped(), 1u);
}

TEST(LatticeEditing, ChoosesOneOfSeveralChosenPointsAloneByAClick)
{
    BoxRig rig;
    rig.key({'A'});
    rig.drag(corner, {0, 0});
    rig.by_keys('G', 'Z', "0.01");
    ASSERT_EQ(rig.shaped(), 1u);
    EXPECT_EQ(rig.last().points, std::vector<glm::ivec3>{corner});
}

TEST(LatticeEditing, MovesNothingByAKeyWhileNoPointIsChosen)
{
    BoxRig rig;
    const std::size_t before = rig.steps();
    rig.move(rig.layout().view.center());
    rig.key({'G'});
    EXPECT_EQ(rig.editor.active_tool().name(), "Lattice");
    EXPECT_FALSE(rig.editor.active_tool().busy());
    EXPECT_EQ(rig.steps(), before);
    ASSERT_FALSE(rig.editor.session.notices.all().empty());
    EXPECT_EQ(rig.editor.session.notices.all().back().title, "No control point is selected");
}

TEST(LatticeEditing, KeysTheStepThatMovedTheChosenPoints)
{
    BoxRig rig;
    const auto track = [&](const std::string& name) {
        return track_of(rig.editor.session.document(), 2, name) != nullptr;
    };
    rig.drag(corner, {0, 0});
    rig.by_keys('G', 'Z', "0.1");
    rig.move(rig.layout().view.center());
    rig.key({'I'});
    EXPECT_TRUE(track("shaping.0.shift.by.z"));
    EXPECT_FALSE(track("transform.translation.z"));
    rig.editor.session.undo();
    rig.wait();
    rig.drag({3, 0, 3}, {0, 0}); // which no step moved
    rig.move(rig.layout().view.center());
    const std::size_t before = rig.steps();
    rig.key({'I'});
    EXPECT_EQ(rig.steps(), before);
    EXPECT_EQ(rig.editor.session.notices.all().back().title, "The selected points have no key");
}

TEST(LatticeEditing, TakesThePointsOfAnInnerLatticeWhereTheOuterOneBendsThem)
{
    BoxRig rig;
    const glm::vec2 unbent = rig.seen_at(rig.point(corner));
    ASSERT_TRUE(rig.editor.session.run(AddLattice{.objects = {2}, .shape = {.size = {2, 2, 2}}}));
    ASSERT_TRUE(rig.editor.session.run(WarpVolume{3, {.shear = 0.3}}));
    rig.editor.session.selected = 2;
    rig.wait();
    const EvaluatedObject& inner = *rig.editor.session.evaluated().objects.at(2);
    const Ref<Lattice> cage = inner.seen_cage();
    const glm::vec2 at = rig.seen_at(control_point(*cage, corner.x, corner.y, corner.z));
    ASSERT_GT(glm::distance(at, unbent), 40);
    rig.move(at);
    rig.draw({at, at});
    rig.by_keys('G', 'Z', "0.05");
    ASSERT_EQ(rig.shaped(), 1u);
    EXPECT_EQ(rig.last().points, std::vector<glm::ivec3>{corner});
    EXPECT_EQ(rig.last().by, glm::dvec3(0, 0, 0.05));
}

TEST(LatticeEditing, FollowsTheMouseWhereTheLatticeLiesOnAStroke)
{
    BoxRig rig;
    Session& session = rig.editor.session;
    ASSERT_TRUE(session.run(AddPlane{.shape = {.size = {6, 6}}}));
    Sketch line{rig.editor.session.view.camera, {}};
    line.camera.eye = {0, -0.02, 9};
    line.camera.target = {0, 0, 0};
    for (int i = 0; i <= 20; ++i)
        line.samples.push_back({line.camera.size_px * glm::dvec2(0.35 + 0.015 * i, 0.5), 0.02 * i});
    Place place{2, line, {}, {3}};
    place.parameters.height = 0.4; // of a box of 1 m: what is seen is not its own size
    ASSERT_TRUE(session.run(place));
    rig.editor.session.selected = 2;
    rig.wait();
    const auto seen = [&] {
        const Ref<Lattice> cage = session.evaluated().objects.at(2)->seen_cage();
        return rig.seen_at(control_point(*cage, corner.x, corner.y, corner.z));
    };
    const glm::vec2 at = seen();
    rig.move(at);
    rig.draw({at, at + glm::vec2(6, -16)});
    rig.wait();
    ASSERT_EQ(rig.shaped(), 1u);
    EXPECT_LT(glm::distance(seen(), at + glm::vec2(6, -16)), 3);
}

TEST(LatticeEditing, PressesTheLatticeOfWhatThePressIsDraggedOn)
{
    BoxRig rig;
    rig.editor.session.selected = 1;
    rig.key({'P'});
    rig.wait();
    const glm::vec2 at = rig.seen_at({0, 0, 0});
    rig.move(at);
    rig.draw({at, at + glm::vec2(0, 12)});
    rig.wait();
    ASSERT_EQ(rig.shaped(), 1u);
    EXPECT_TRUE(object(rig.editor.session.document(), 2).shaping.back()->press);
}

TEST(LatticeEditing, TakesTheNeighboursAlongWhereItIsProportional)
{
    BoxRig rig;
    rig.key({'O'});
    EXPECT_TRUE(*rig.editor.tool_parts()->proportional());
    const glm::dvec3 far = rig.point({3, 3, 0}), near = rig.point({0, 0, 2});
    rig.drag(corner, {0, -20});
    ASSERT_EQ(rig.shaped(), 1u);
    ASSERT_EQ(rig.last().points.size(), rig.last().weights.size());
    EXPECT_EQ(rig.last().points.front(), corner);
    EXPECT_EQ(rig.last().weights.front(), 1);
    EXPECT_GT(rig.last().points.size(), 1u);
    EXPECT_GT(rig.point({0, 0, 2}).z, near.z);
    EXPECT_EQ(rig.point({3, 3, 0}), far);
}

TEST(LatticeEditing, ReachesFurtherByTheWheelWhileItGoesOn)
{
    BoxRig rig;
    rig.key({'O'});
    rig.drag(corner, {0, 0});
    rig.key({'G'});
    rig.key({'Z'});
    rig.type("0.05");
    rig.wait();
    const std::size_t before = rig.last().points.size();
    const double distance = glm::length(rig.editor.session.view.camera.eye);
    for (int i = 0; i < 8; ++i) rig.screen.input().push(ui::turn_wheel(1));
    rig.frames(4);
    rig.key({ui::key_page_up});
    rig.wait();
    EXPECT_GT(rig.last().points.size(), before);
    EXPECT_EQ(glm::length(rig.editor.session.view.camera.eye), distance); // it did not zoom
}

TEST(LatticeEditing, FollowsTheMouseInALatticeThatIsScaledAndTurned)
{
    BoxRig rig({.translation = {0, 0, 0}, .rotation_deg = {0, 0, 30}, .scale = glm::dvec3(2)});
    const glm::vec2 goal = rig.seen_at(rig.point(corner)) + glm::vec2(12, -20);
    rig.drag(corner, {12, -20});
    ASSERT_EQ(rig.shaped(), 1u);
    EXPECT_LT(glm::distance(rig.seen_at(rig.point(corner)), goal), 1);
}

} // namespace
} // namespace trivar
