// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/placement/place.h"
#include "editor/hands/last_shaping.h"
#include "editor/picture/volume_facts.h"
#include "tests/editor/rig.h"
#include "tests/ffd/folds.h"

namespace trivar {
namespace {

using testing::Rig;

// The box laid on the plane, seen from the front, and its control points.
struct LatticeRig : Rig {
    LatticeRig() : Rig({1100, 800})
    {
        two_objects();
        key({'D'});
        draw(stroke());
        wait();
        PlacementParameters p = object(editor.session.document(), 2).stroke->parameters;
        p.grid = {9, 4, 3};
        EXPECT_TRUE(editor.session.run(EditPlacement{2, p, {}, {}}));
        editor.session.view.camera.eye = {0.5, -4, 1.4};
        key({'V'});
        wait();
    }
    const Lattice& volume() const
    {
        return editor.session.evaluated().objects.at(2)->placement->volume;
    }
    glm::dvec3 point(const glm::ivec3& p) const { return control_point(volume(), p.x, p.y, p.z); }
    std::size_t shaped() const { return object(editor.session.document(), 2).shaping.size(); }
    const PointShift& last() const
    {
        return *object(editor.session.document(), 2).shaping.back()->shift;
    }
    void drag(const glm::ivec3& from, glm::vec2 by, bool let_go = true)
    {
        const glm::vec2 at = seen_at(point(from));
        move(at);
        draw({at, at + by}, let_go);
        wait();
    }
};
constexpr glm::ivec3 near_roof(4, 0, 2);

TEST(LatticePoints, OneIsDraggedWhereTheMouseGoesInOneStep)
{
    LatticeRig rig;
    EXPECT_EQ(rig.editor.active_tool().name(), "Lattice");
    const glm::vec2 goal = rig.seen_at(rig.point(near_roof)) + glm::vec2(6, -20);
    const glm::dvec3 beside = rig.point({5, 0, 2});
    rig.drag(near_roof, {6, -20});
    ASSERT_EQ(rig.shaped(), 1u);
    ASSERT_EQ(rig.last().points, std::vector{near_roof});
    EXPECT_EQ(rig.last().of.x * rig.last().of.y * rig.last().of.z,
              static_cast<int>(rig.volume().displacement.points.size()));
    EXPECT_LT(glm::distance(rig.seen_at(rig.point(near_roof)), goal), 1);
    EXPECT_EQ(rig.point({5, 0, 2}), beside);
    rig.editor.session.undo();
    rig.wait();
    EXPECT_EQ(rig.shaped(), 0u);
}

TEST(LatticePoints, StopBeforeTheVolumeFolds)
{
    LatticeRig rig;
    rig.drag(near_roof, {0, 12}, false);
    rig.key({'Z'});
    rig.type("-2");
    rig.wait();
    rig.screen.input().push(ui::press(ui::Button::left, false));
    rig.wait();
    ASSERT_EQ(rig.shaped(), 1u);
    EXPECT_EQ(testing::verdict_of(rig.volume()), Verdict::proven_good);
    const Shaping& step = rig.editor.session.evaluated().objects.at(2)->shaped->steps.back();
    EXPECT_LT(step.done, step.asked);
    const auto& notices = rig.editor.session.notices.all();
    ASSERT_FALSE(notices.empty());
    EXPECT_EQ(notices.back().title, "The volume would fold here");
}

TEST(LatticePoints, MayFoldTheVolumeWhereThatIsAllowed)
{
    LatticeRig rig;
    const auto pull = [&] {
        rig.drag(near_roof, {0, 12}, false);
        rig.key({'Z'});
        rig.type("-2");
        rig.wait();
        rig.screen.input().push(ui::press(ui::Button::left, false));
        rig.wait();
    };
    const Action& allow = action(rig.editor, allow_folds_action);
    EXPECT_FALSE(is_enabled(rig.editor, allow));
    pull();
    ASSERT_EQ(rig.editor.session.notices.all().back().actions.size(), 1u);
    rig.editor.session.notices.all().back().actions.front().act();
    rig.wait();
    EXPECT_TRUE(is_enabled(rig.editor, allow)); // the point is still chosen
    ASSERT_EQ(rig.shaped(), 2u);
    const auto& allowance = *object(rig.editor.session.document(), 2).shaping.back()->allowance;
    ASSERT_EQ(allowance.boxes.size(), 1u);
    EXPECT_EQ(allowance.boxes.front(), bent_by(rig.volume(), std::vector{near_roof}));
    pull();
    const EvaluatedObject& placed = *rig.editor.session.evaluated().objects.at(2);
    EXPECT_EQ(placed.shaped->steps.back().done, placed.shaped->steps.back().asked);
    EXPECT_EQ(testing::verdict_of(rig.volume()), Verdict::proven_bad);
    EXPECT_TRUE(rig.editor.viewport.volume_facts().verdicts(placed)->good());
}

TEST(LatticePoints, AreChosenByABoxAndMovedTogetherByATypedNumber)
{
    LatticeRig rig;
    const glm::dvec3 a = rig.point({0, 0, 2}), b = rig.point({8, 0, 2});
    const glm::vec2 margin(30, 30);
    rig.draw({glm::min(rig.seen_at(a), rig.seen_at(b)) - margin,
              glm::max(rig.seen_at(a), rig.seen_at(b)) + margin});
    rig.drag(near_roof, {0, -12}, false);
    rig.key({'Z'});
    rig.type("0.05");
    rig.wait();
    rig.screen.input().push(ui::press(ui::Button::left, false));
    rig.wait();
    ASSERT_EQ(rig.shaped(), 1u);
    EXPECT_GT(rig.last().points.size(), 9u);
    EXPECT_EQ(rig.last().by, glm::dvec3(0, 0, 0.05));
    EXPECT_NEAR(glm::distance(rig.point({0, 0, 2}), a), 0.05, 1e-9);
}

TEST(LatticePoints, GoWithTheMouseFromTheKeyOfMoveTillAClick)
{
    LatticeRig rig;
    rig.key({'G'}); // nothing is chosen: it says so
    EXPECT_EQ(rig.editor.active_tool().name(), "Lattice");
    EXPECT_FALSE(rig.editor.active_tool().busy());
    rig.drag(near_roof, {0, 0});
    const glm::vec2 from = rig.seen_at(rig.point(near_roof)) + glm::vec2(40, -30);
    rig.move(from);
    rig.key({'G'});
    EXPECT_EQ(rig.editor.active_tool().name(), "Lattice");
    rig.move(from + glm::vec2(0, -12));
    rig.wait();
    EXPECT_EQ(rig.shaped(), 1u);
    rig.key({ui::key_escape});
    rig.wait();
    EXPECT_EQ(rig.shaped(), 0u);
    rig.move(from);
    rig.key({'G'});
    rig.key({'Z'});
    rig.type("0.05");
    rig.wait();
    rig.draw({from});
    rig.wait();
    ASSERT_EQ(rig.shaped(), 1u);
    EXPECT_EQ(rig.last().points, std::vector{near_roof});
    EXPECT_EQ(rig.last().by, glm::dvec3(0, 0, 0.05));
}

TEST(LatticePoints, AreLeftAsTheyAreByAClickAndByEscape)
{
    LatticeRig rig;
    rig.drag(near_roof, {0, 0});
    EXPECT_EQ(rig.shaped(), 0u);
    const glm::dvec3 before = rig.point(near_roof);
    rig.drag(near_roof, {0, -15}, false);
    EXPECT_NE(rig.point(near_roof), before);
    rig.key({ui::key_escape});
    rig.wait();
    EXPECT_EQ(rig.shaped(), 0u);
    EXPECT_EQ(rig.point(near_roof), before);
}

TEST(LatticePoints, ThatTheLatticeLostAreForgotten)
{
    LatticeRig rig;
    const auto lay_with = [&](const glm::ivec3& grid) {
        PlacementParameters p = object(rig.editor.session.document(), 2).stroke->parameters;
        p.grid = grid;
        EXPECT_TRUE(rig.editor.session.run(EditPlacement{2, p, {}, {}}));
        rig.wait();
    };
    rig.drag({8, 0, 2}, {0, 0}); // chooses it
    lay_with({5, 4, 3});
    rig.key({'G'});
    rig.move(rig.layout().view.center());
    rig.wait();
    EXPECT_EQ(rig.shaped(), 0u);
    rig.key({ui::key_escape});
    lay_with({9, 4, 3});
    rig.drag({8, 0, 2}, {6, -20}, false);
    lay_with({5, 4, 3}); // with the hand on one
    rig.screen.input().push(ui::press(ui::Button::left, false));
    rig.wait();
    EXPECT_FALSE(rig.editor.active_tool().busy());
}

} // namespace
} // namespace trivar
