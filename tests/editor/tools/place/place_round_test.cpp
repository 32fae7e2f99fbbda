// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/arrange.h"
#include "core/commands/placement/place.h"
#include "core/placement/placement.h"
#include "editor/tools/place/place_round.h"

#include "editor/actions/actions.h"
#include "editor/actions/placement_actions.h"
#include "tests/editor/rig.h"

#include <glm/gtc/constants.hpp>

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
    EXPECT_TRUE(rig.can()) << "a plane goes round the box, where another plane cuts this";
    rig.editor.session.selected.set({1});
    ASSERT_TRUE(rig.editor.session.run(Delete{{3}}));
    rig.wait();
    EXPECT_FALSE(rig.can()) << "which body is meant?";
    rig.editor.session.undo();
    rig.wait();
    ASSERT_TRUE(rig.editor.session.run(AddSphere{}));
    rig.wait();
    rig.editor.session.selected.set({2});
    EXPECT_FALSE(rig.can()) << "there are two bodies to go round";
    EXPECT_EQ(bodies_to_go_round(rig.editor.session, 2), (std::vector<Id>{3, 4}));
    EXPECT_EQ(bodies_to_go_round(rig.editor.session, 3), (std::vector<Id>{2, 4}));
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

// The laid object is outside the box 1 x 2 x 3 at (2, 0, 0), and near it everywhere.
TEST(PlaceRoundAction, GoesRoundAnyBodyAboutAnyOfItsAxes)
{
    RoundRig rig;
    AddBox box;
    box.shape.size = {1, 2, 3};
    box.transform = {.translation = {2, 0, 1}, .rotation_deg = {0, 0, 30}};
    ASSERT_TRUE(rig.editor.session.run(box)); // 4
    // Long and thin, as a text or a snake is.
    ASSERT_TRUE(rig.editor.session.run(SetTransform{2, {.scale = {8, 1, 1}}}));
    rig.wait();
    for (const RoundAxis axis : {RoundAxis::z, RoundAxis::x, RoundAxis::y}) {
        const std::size_t steps = rig.steps();
        lay_round(rig.editor.session, {2, 4, axis});
        rig.wait();
        EXPECT_EQ(rig.steps(), steps + 1);
        ASSERT_TRUE(rig.step(2) && rig.step(2)->round && rig.step(2)->round->normal);
        EXPECT_EQ(round_now(rig.editor.session.document(), 2)->axis, axis);
        EXPECT_NEAR(rig.step(2)->round->level, 0, 1e-3) << "about the middle of the box";
        const auto laid = rig.editor.session.evaluated().objects.at(2);
        ASSERT_TRUE(laid->placement) << laid->rejected;
        EXPECT_GT(laid->placement->report.smallest_jacobian, 0);
        const glm::dmat4 to_own = glm::inverse(to_world(rig.editor.session.document(), 4));
        const Box body{{-0.5, -1, -1.5}, {0.5, 1, 1.5}};
        double round = 0; // the angle about the axis, all of it
        glm::dvec2 before(0);
        const int a = static_cast<int>(axis), b = (a + 1) % 3, c = (a + 2) % 3;
        for (int i = 0; i <= 200; ++i) {
            const glm::dvec3 p =
                evaluate(laid->placement->contact, {i / 200.0 * (1 - 1e-9), 0.5}).value;
            const glm::dvec3 own(to_own * glm::dvec4(p, 1));
            EXPECT_GT(std::max({std::abs(own.x) / 0.5, std::abs(own.y), std::abs(own.z) / 1.5}),
                      1 - 0.02);
            EXPECT_LT(body.distance(own), 0.25);
            EXPECT_NEAR(own[a], 0, 0.05);
            const glm::dvec2 now(own[b], own[c]);
            if (i > 0)
                round += std::atan2(before.x * now.y - before.y * now.x, glm::dot(before, now));
            before = now;
        }
        EXPECT_NEAR(round, 2 * glm::pi<double>(), 0.01);
    }
    // Its level stays as it is laid again about the same axis, and it goes along with the box.
    const glm::dvec3 was = rig.editor.session.evaluated().objects.at(2)->bounds->center();
    Transform moved = object(rig.editor.session.document(), 4).transform;
    moved.translation.x += 3;
    ASSERT_TRUE(rig.editor.session.run(SetTransform{4, moved}));
    rig.wait();
    EXPECT_LT(glm::distance(rig.editor.session.evaluated().objects.at(2)->bounds->center(),
                            was + glm::dvec3(3, 0, 0)),
              1e-4);
}

} // namespace
} // namespace trivar
