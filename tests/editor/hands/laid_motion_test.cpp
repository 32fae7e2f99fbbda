// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/arrange.h"
#include "core/commands/volumes/lattice.h"
#include "core/steps/laying/attaching.h"
#include "tests/editor/laid.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using testing::LaidRig;

TEST(LaidMotion, GSlidesItOverTheSurfaceUnderTheMouseInOneStep)
{
    LaidRig rig;
    const std::size_t before = rig.steps();
    const glm::dvec3 was = rig.middle(), ahead = rig.ahead();
    const double length = rig.laid().report.length_world, width = rig.laid().report.width_world;
    const glm::vec2 by(60, -50);
    rig.move(rig.layout().view.center());
    rig.key({'G'});
    ASSERT_TRUE(rig.editor.active_tool().busy());
    rig.move(rig.layout().view.center() + by);
    rig.wait();
    EXPECT_TRUE(rig.editor.session.proposing());
    EXPECT_LT(glm::distance(rig.seen_at(rig.middle()), rig.seen_at(was) + by), 1.5f)
        << "what is moved goes with the mouse";
    rig.click(rig.layout().view.center() + by);
    rig.wait();
    EXPECT_EQ(rig.steps(), before + 1);
    EXPECT_LT(glm::distance(rig.seen_at(rig.middle()), rig.seen_at(was) + by), 1.5f);
    EXPECT_NEAR(rig.middle().z, 0, 1e-6) << "it still lies on the plane";
    EXPECT_LT(glm::distance(rig.ahead(), ahead), 1e-6);
    EXPECT_NEAR(rig.laid().report.length_world, length, 1e-6);
    EXPECT_NEAR(rig.laid().report.width_world, width, 1e-6);
    ASSERT_TRUE(rig.step().attach) << "it goes with what it lies on";
    EXPECT_EQ(rig.step().attach->hosts.front().object, 1);
    rig.editor.session.undo();
    rig.wait();
    EXPECT_EQ(rig.middle(), was);
}

TEST(LaidMotion, ACopyMovesAtOnceAndWhatIsTypedMeanwhileIsItsAmount)
{
    LaidRig rig;
    const glm::dvec3 was = rig.middle(), ahead = rig.ahead();
    const std::string name = object(rig.editor.session.document(), 2).name;
    rig.editor.session.notices.clear();
    const std::size_t steps = rig.steps();
    ui::Input& input = rig.screen.input(); // all in one frame
    input.push(ui::press_key(ui::key_left_shift));
    input.push(ui::press_key('D'));
    input.push(ui::press_key('D', false));
    input.push(ui::press_key(ui::key_left_shift, false));
    input.push(ui::press_key('1'));
    input.push(ui::type_text('1'));
    input.push(ui::press_key('1', false));
    input.push(ui::press_key(ui::key_enter));
    input.push(ui::press_key(ui::key_enter, false));
    rig.frames(1);
    rig.wait();
    rig.frames(8);
    rig.wait();
    EXPECT_EQ(rig.steps(), steps + 2);
    ASSERT_TRUE(rig.is_laid(3));
    EXPECT_TRUE(rig.step(3).attach);
    EXPECT_LT(glm::distance(rig.middle(3), was + ahead), 1e-3);
    EXPECT_LT(glm::distance(rig.middle(2), was), 1e-9);
    EXPECT_EQ(object(rig.editor.session.document(), 2).name, name);
    EXPECT_TRUE(rig.editor.session.notices.all().empty());
    EXPECT_EQ(rig.editor.outliner.renaming, 0) << "Enter ended the motion";
}

TEST(LaidMotion, SlidesALatticeThatLiesOnAStroke)
{
    testing::Rig rig({720, 520});
    rig.two_objects();
    ASSERT_TRUE(rig.editor.session.run(
        AddLattice{.objects = {2}, .shape = {.size = {1.2, 0.3, 0.3}}, .transform = {{0, 0, 1}}}));
    rig.editor.session.selected = 3;
    rig.wait();
    rig.key({'D'});
    rig.draw(rig.stroke());
    rig.wait();
    rig.key({'Q'});
    rig.wait();
    const auto middle = [&] {
        const Ref<EvaluatedObject> lattice = rig.editor.session.evaluated().objects.at(3);
        EXPECT_TRUE(lattice->lattice_stroke);
        return evaluate(lattice->stroke_placement()->contact, {0.5, 0.5}).value;
    };
    const glm::dvec3 was = middle();
    rig.key({'G'});
    rig.type("0.5");
    rig.key({ui::key_enter});
    rig.wait();
    EXPECT_NEAR(glm::distance(middle(), was), 0.5, 1e-3);
    EXPECT_NEAR(middle().z, 0, 1e-6);
}

TEST(LaidMotion, NumbersGoAlongAcrossAndOffTheSurface)
{
    LaidRig rig;
    const glm::dvec3 was = rig.middle(), ahead = rig.ahead();
    const glm::dvec3 left = glm::cross(glm::dvec3(0, 0, 1), ahead);
    rig.key({'G'});
    rig.type("0.5");
    rig.key({ui::key_enter});
    rig.wait();
    EXPECT_LT(glm::distance(rig.middle(), was + 0.5 * ahead), 1e-3);
    rig.key({'G'});
    rig.key({'Y'});
    rig.type("-0.3");
    rig.key({ui::key_enter});
    rig.wait();
    EXPECT_LT(glm::distance(rig.middle(), was + 0.5 * ahead - 0.3 * left), 1e-3);
    rig.key({'G'});
    rig.key({'Z'});
    rig.type("0.1");
    rig.key({ui::key_enter});
    rig.wait();
    const glm::dvec3 there = was + 0.5 * ahead - 0.3 * left;
    EXPECT_LT(glm::distance(rig.middle(), there + glm::dvec3(0, 0, 0.1)), 1e-3)
        << "straight off the surface, however the stroke looks at it";
    EXPECT_GT(rig.step().parameters.clearance, 0.11) << "which is measured along its rays";
    rig.key({'G'});
    rig.key({'Z'});
    rig.type("-5");
    rig.key({ui::key_enter});
    rig.wait();
    EXPECT_EQ(rig.step().parameters.clearance, 0) << "nothing goes under the surface";
    EXPECT_LT(glm::distance(rig.middle(), there), 2e-3) << "and back straight down";
}

TEST(LaidMotion, RTurnsItAboutItsContactAndXIsNoCommandMeanwhile)
{
    LaidRig rig;
    const std::size_t before = rig.steps();
    const glm::dvec3 was = rig.middle(), ahead = rig.ahead();
    rig.key({'R'});
    rig.key({'X'});
    rig.type("90");
    rig.key({ui::key_enter});
    rig.wait();
    EXPECT_EQ(rig.steps(), before + 1);
    EXPECT_LT(glm::distance(rig.middle(), was), 1e-3);
    EXPECT_LT(glm::distance(rig.ahead(), glm::cross(glm::dvec3(0, 0, 1), ahead)), 1e-3);
    rig.move(rig.seen_at(was) + glm::vec2(100, 0));
    rig.key({'R'});
    rig.move(rig.seen_at(was) + glm::vec2(0, -60));
    rig.wait();
    rig.key({ui::key_enter});
    rig.wait();
    EXPECT_EQ(rig.steps(), before + 2);
    EXPECT_LT(glm::dot(rig.ahead(), ahead), -0.8) << "it went a quarter further with the mouse";
}

TEST(LaidMotion, ALiftTurnsNothingWhereTheSurfaceIsCurved)
{
    testing::Rig rig;
    AddSphere ball;
    ball.shape.radius = 2;
    ball.transform.translation = {0, 0, -2};
    ASSERT_TRUE(rig.editor.session.run(ball));
    AddBox box;
    box.shape.size = {1.2, 0.3, 0.3};
    box.transform.translation = {0, 0, 1};
    ASSERT_TRUE(rig.editor.session.run(box));
    rig.editor.session.selected = 2;
    rig.editor.session.view.camera.eye = {0.5, -6, 4};
    rig.editor.session.view.camera.target = {0, 0, 0};
    rig.wait();
    rig.key({'D'});
    rig.draw(rig.stroke());
    rig.wait();
    rig.key({'Q'});
    const auto stroke = [&] {
        return object(rig.editor.session.document(), 2).stroke.value().sketch;
    };
    const auto middle = [&] {
        const auto laid = rig.editor.session.evaluated().objects.at(2)->placement;
        return evaluate(laid->contact, {0.5, 0.5}).value;
    };
    const Sketch was = stroke();
    const glm::dvec3 from = middle(), normal = glm::normalize(from - glm::dvec3(0, 0, -2));
    rig.key({'G'});
    rig.key({'Z'});
    rig.type("0.1");
    rig.key({ui::key_enter});
    rig.wait();
    EXPECT_LT(glm::distance(glm::normalize(stroke().camera.target - stroke().camera.eye),
                            glm::normalize(was.camera.target - was.camera.eye)),
              1e-9);
    EXPECT_GT(glm::dot(middle() - from, normal), 0.08);
    EXPECT_LT(glm::distance(middle(), from + 0.1 * normal), 0.03);
}

TEST(LaidMotion, HistorySaysMoveTurnScaleAndLift)
{
    LaidRig rig;
    const auto title = [&] {
        const History& history = rig.editor.session.scene().history();
        const std::size_t n = history.position();
        return step_title(history.steps()[n - 1].command, history.steps()[n - 2].result,
                          history.steps()[n - 1].result)
            .text();
    };
    const auto by = [&](std::initializer_list<int> keys, const char* amount) {
        for (const int key : keys) rig.key({key});
        rig.type(amount);
        rig.key({ui::key_enter});
        rig.wait();
        return title();
    };
    EXPECT_EQ(by({'G'}, "0.4"), "Slide Box 0.4 m");
    EXPECT_EQ(by({'R'}, "90"), "Turn Box on the surface 90°");
    EXPECT_EQ(by({'R'}, "-30"), "Turn Box on the surface -30°");
    EXPECT_EQ(by({'G', 'Y'}, "-0.2"), "Slide Box 0.2 m");
    EXPECT_EQ(by({'S'}, "0.5"), "Scale Box on the surface × 0.5");
    EXPECT_THAT(by({'G', 'Z'}, "0.1"), ::testing::StartsWith("Lift Box clearance 0.1"));
    EXPECT_EQ(by({'G', 'Z'}, "-1"), "Lower Box clearance 0 m");
}

TEST(LaidMotion, SScalesLengthWidthAndHeightTogetherAndAnAxisOneOfThem)
{
    LaidRig rig;
    const glm::vec2 c = rig.layout().view.center();
    rig.key({'D'});
    rig.draw({c + glm::vec2(-90, 20), c + glm::vec2(90, 20)});
    rig.wait();
    const PlacementReport first = rig.laid().report;
    rig.key({'S'});
    rig.type("0.5");
    rig.key({ui::key_enter});
    rig.wait();
    EXPECT_NEAR(rig.laid().report.length_world, first.length_world / 2, 1e-6);
    EXPECT_NEAR(rig.laid().report.width_world, first.width_world / 2, 1e-6);
    EXPECT_NEAR(rig.laid().report.height_world, first.height_world / 2, 1e-6);
    EXPECT_EQ(rig.step().parameters.width, 0) << "in proportion to the model, as before";
    // A wider strip, seen at a slant, measures its length a little differently.
    const double much = 0.01 * first.length_world;
    rig.key({'S'});
    rig.key({'Y'});
    rig.type("3");
    rig.key({ui::key_enter});
    rig.wait();
    EXPECT_NEAR(rig.laid().report.length_world, first.length_world / 2, much);
    EXPECT_NEAR(rig.laid().report.width_world, first.width_world * 1.5, 1e-6);
    EXPECT_NEAR(rig.laid().report.height_world, first.height_world / 2, much);
    const double width = rig.laid().report.width_world;
    rig.key({'S'});
    rig.key({'X'});
    rig.type("1.5");
    rig.key({ui::key_enter});
    rig.wait();
    EXPECT_NEAR(rig.laid().report.length_world, first.length_world * 0.75, much);
    EXPECT_NEAR(rig.laid().report.width_world, width, 1e-6);
    EXPECT_NEAR(rig.laid().report.height_world, first.height_world / 2, much);
    rig.key({'S'});
    rig.type("2");
    rig.key({ui::key_enter});
    rig.wait();
    EXPECT_NEAR(rig.laid().report.width_world, 2 * width, 1e-6);
    EXPECT_NEAR(rig.laid().report.height_world, first.height_world, much);
}

TEST(LaidMotion, EscapeLeavesNoTraceAndNothingIsLaidBesideTheScene)
{
    LaidRig rig;
    const std::size_t before = rig.steps();
    const glm::dvec3 was = rig.middle();
    rig.move(rig.layout().view.center());
    rig.key({'G'});
    rig.move(rig.layout().view.center() + glm::vec2(60, 0));
    rig.wait();
    EXPECT_NE(rig.middle(), was);
    rig.key({ui::key_escape});
    rig.wait();
    EXPECT_EQ(rig.middle(), was);
    EXPECT_EQ(rig.editor.session.scene().history().steps().size(), before);
    rig.key({'G'});
    rig.move(rig.layout().view.center() + glm::vec2(40, 0));
    rig.wait();
    const glm::dvec3 seen_last = rig.middle();
    rig.editor.session.view.camera.target.z = 40; // looks up into the air
    rig.frames();
    rig.move(rig.layout().view.center() + glm::vec2(50, -10));
    rig.click(rig.layout().view.center() + glm::vec2(50, -10));
    rig.wait();
    EXPECT_EQ(rig.steps(), before + 1);
    EXPECT_LT(glm::distance(rig.middle(), seen_last), 1e-9);
}

TEST(LaidMotion, AHandleSlidesItToo)
{
    LaidRig rig;
    rig.key({'G'});
    rig.key({ui::key_escape}); // the tool stays
    const std::size_t before = rig.steps();
    const glm::dvec3 was = rig.middle();
    const glm::vec2 at = rig.seen_at(was);
    rig.move(at);
    rig.draw({at, at + glm::vec2(30, 20)});
    rig.wait();
    EXPECT_EQ(rig.steps(), before + 1);
    EXPECT_LT(glm::distance(rig.seen_at(rig.middle()), at + glm::vec2(30, 20)), 1.5f);
}

TEST(LaidMotion, OnWhatWasMovedSinceItMovesInTheSpaceOfItsStroke)
{
    LaidRig rig;
    ASSERT_TRUE(rig.editor.session.run(SetTransform{
        1,
        {.translation = {0.2, 0.4, 0.3}, .rotation_deg = {0, 0, 30}, .scale = glm::dvec3(0.8)}}));
    rig.wait();
    rig.editor.session.selected = 2;
    const glm::dvec3 was = rig.middle(), ahead = rig.ahead();
    const PlacementReport first = rig.laid().report;
    rig.key({'G'});
    rig.type("0.4");
    rig.key({ui::key_enter});
    rig.wait();
    EXPECT_LT(glm::distance(rig.middle(), was + 0.4 * ahead), 1e-3);
    EXPECT_NEAR(rig.laid().report.length_world, first.length_world, 1e-6);
    EXPECT_NEAR(rig.laid().report.width_world, first.width_world, 1e-6);
    const glm::dvec3 now = rig.middle();
    rig.key({'R'});
    rig.type("90");
    rig.key({ui::key_enter});
    rig.wait();
    EXPECT_LT(glm::distance(rig.middle(), now), 1e-3);
    EXPECT_LT(glm::distance(rig.ahead(), glm::cross(glm::dvec3(0, 0, 1), ahead)), 1e-3);
}

TEST(LaidMotion, OnABallItGoesRoundToAnySideThatIsSeen)
{
    testing::Rig rig;
    AddSphere ball;
    ball.shape.radius = 1;
    ASSERT_TRUE(rig.editor.session.run(ball));
    AddBox box;
    box.shape.size = {0.6, 0.15, 0.15};
    ASSERT_TRUE(rig.editor.session.run(box));
    rig.editor.session.selected = 2;
    rig.editor.session.view.camera.eye = {0, -6, 0};
    rig.editor.session.view.camera.target = {0, 0, 0};
    rig.wait();
    rig.key({'D'});
    const glm::vec2 c = rig.layout().view.center();
    rig.draw({c + glm::vec2(-30, 0), c, c + glm::vec2(30, 0)});
    rig.wait();
    const auto middle = [&] {
        const auto& placement = rig.editor.session.evaluated().objects.at(2)->placement;
        return placement ? evaluate(placement->contact, {0.5, 0.5}, 1) : SurfaceJet<glm::dvec3>{};
    };
    ASSERT_NEAR(glm::length(middle().value), 1, 0.01);
    for (const glm::dvec3& eye : {glm::dvec3(6, 0, 0), {0, 6, 0}}) { // to the side, and behind
        rig.editor.session.view.camera.eye = eye;
        rig.frames();
        rig.move(c);
        rig.key({'G'});
        const glm::vec2 seen = rig.seen_at(middle().value);
        rig.move(c + (c - seen)); // the middle comes to the middle of the picture
        rig.wait();
        rig.key({ui::key_enter});
        rig.wait();
        EXPECT_LT(glm::distance(middle().value, eye / 6.0), 0.03);
        EXPECT_NEAR(glm::normalize(middle().u).z, 0, 0.05) << "it still goes level";
        EXPECT_LT(glm::dot(glm::cross(middle().u, middle().v), -eye), 0) << "and stands outside";
    }
}

} // namespace
} // namespace trivar
