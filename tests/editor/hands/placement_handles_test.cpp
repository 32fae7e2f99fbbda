// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/arrange.h"
#include "core/commands/placement/place.h"
#include "core/document/document_digest.h"
#include "core/evaluation/evaluate.h"
#include "core/placement/height_map.h"
#include "core/placement/profile.h"
#include "core/placement/redraw.h"
#include "editor/hands/placement_handles.h"
#include "editor/hands/selected_placement.h"
#include "tests/editor/laid.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::ElementsAre, ::testing::IsEmpty;
using testing::Rig;

struct PlacedRig : testing::LaidRig {
    using LaidRig::LaidRig;
    Handle handle(const HandleKey& key) const
    {
        for (const Handle& each : placement_handles(editor.session, HandleChoice::all, 1))
            if (each.key == key) return each;
        ADD_FAILURE() << "there is no such handle";
        return {};
    }
    glm::vec2 in_window(const Handle& handle) const
    {
        return layout().view.lo + glm::vec2(handle.p_px);
    }
    // A drag of a handle by some pixels.
    void pull(const Handle& handle, glm::vec2 by)
    {
        const glm::vec2 at = in_window(handle);
        move(at);
        draw({at, at + by});
        wait();
    }
    // A drag that makes the way from what it is tied to longer by a share.
    void lengthen(const Handle& handle, float by)
    {
        pull(handle, by * glm::vec2(handle.p_px - handle.base_px));
    }
};

TEST(PlacementHandles, ARimSetsTheWidthAndTheRoofTheHeightAStepEach)
{
    PlacedRig rig;
    ASSERT_TRUE(rig.editor.session.evaluated().objects.at(2)->placement);
    const std::size_t before = rig.steps();
    const double width = rig.laid().report.width_world, height = rig.laid().report.height_world;
    const Handle rim = rig.handle({"width"});
    rig.lengthen(rim, 1); // as far again
    EXPECT_EQ(rig.steps(), before + 1);
    EXPECT_NEAR(rig.step().parameters.width, 2 * width, 0.02 * width);
    EXPECT_NEAR(rig.laid().report.width_world, 2 * width, 0.02 * width);
    const Handle roof = rig.handle({"height"});
    // The height is seen end on from where the stroke was drawn: its handle is on a stalk.
    EXPECT_GT(glm::distance(rig.in_window(roof), rig.seen_at(roof.p_world)), 20);
    const Camera& camera = rig.editor.session.view.camera;
    const double px = pixel_size_world(
        camera, project(camera, evaluate(rig.laid().volume, {0.5, 0.5, 0}).value).depth_world);
    rig.pull(roof, {0, -40});
    EXPECT_EQ(rig.steps(), before + 2);
    EXPECT_NEAR(rig.step().parameters.height, height + 40 * px, 0.03 * height);
    rig.editor.session.view.camera.eye = {-4, -5, 2};
    rig.frames(4);
    const Handle aside = rig.handle({"height"});
    const double now = rig.step().parameters.height;
    rig.lengthen(aside, 0.25f);
    EXPECT_EQ(rig.steps(), before + 3);
    EXPECT_NEAR(rig.step().parameters.height, 1.25 * now, 0.03 * now);
    rig.editor.session.undo();
    rig.editor.session.undo();
    rig.editor.session.undo();
    rig.wait();
    EXPECT_EQ(rig.laid().report.width_world, width);
}

TEST(PlacementHandles, ARimOfAProfileMovesItsPointOnly)
{
    PlacedRig rig;
    PlacementParameters p = rig.step().parameters;
    p.width_profile = {{0, 1}, {0.5, 1}, {1, 1}};
    ASSERT_TRUE(rig.editor.session.run(EditPlacement{2, p, {}, {}}));
    rig.wait();
    const Handle middle = rig.handle({"width", {3}}); // the left rim at the second point
    rig.lengthen(middle, 0.5f);
    const std::vector<glm::dvec2>& profile = rig.step().parameters.width_profile;
    EXPECT_EQ(rig.step().parameters.width, p.width);
    EXPECT_NEAR(Profile(profile).at(0.5), 1.5, 0.05);
    EXPECT_EQ(profile.front(), glm::dvec2(0, 1));
    EXPECT_EQ(profile.back(), glm::dvec2(1, 1));
}

TEST(PlacementHandles, TheFloorIsPulledIntoTheSceneAndTheRiseUpAndDown)
{
    PlacedRig rig;
    rig.editor.session.view.camera.eye = {-4, -5, 2};
    rig.frames(4);
    const Handle floor = rig.handle({"sunk"});
    const double height = rig.laid().report.height_world;
    rig.lengthen(floor, 0.3f);
    const double sunk = rig.step().parameters.contact_level;
    EXPECT_NEAR(sunk, 0.3, 0.03);
    EXPECT_NEAR(rig.laid().report.height_world, height, 1e-9);
    EXPECT_EQ(rig.laid().ground, sunk);
    rig.pull(rig.handle({"sunk"}), {0, -300}); // no further than up again
    EXPECT_EQ(rig.step().parameters.contact_level, 0);
    PlacementParameters p = rig.step().parameters;
    p.rise_profile = {{0, 0}, {0.5, 0.5}, {1, 1}};
    p.height_across = {{0, 1}, {0.5, 1}, {1, 1}};
    ASSERT_TRUE(rig.editor.session.run(EditPlacement{2, p, {}, {}}));
    rig.wait();
    const Handle middle = rig.handle({"rise", {1}});
    rig.lengthen(middle, 0.4f);
    EXPECT_NEAR(ShareCurve(rig.step().parameters.rise_profile).at(0.5), 0.7, 0.03);
    rig.pull(rig.handle({"rise", {1}}), {0, -400}); // it stays a rise
    EXPECT_LT(rig.step().parameters.rise_profile[1].y, 1);
    const Handle left = rig.handle({"across", {2}});
    rig.lengthen(left, 0.5f);
    EXPECT_NEAR(rig.step().parameters.height_across.back().y, 1.5, 0.05);
    EXPECT_EQ(rig.step().parameters.height_across.front().y, 1);
}

TEST(PlacementHandles, APointOfTheHeightMapIsRaisedOverTheRoof)
{
    PlacedRig rig;
    PlacementParameters p = rig.step().parameters;
    p.height_map = {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
    ASSERT_TRUE(rig.editor.session.run(EditPlacement{2, p, {}, {}}));
    rig.editor.session.view.camera.eye = {-4, -5, 2};
    rig.wait();
    const Handle inner = rig.handle({"map", {1, 1}});
    const double u = HeightMap(p.height_map).along()[1];
    EXPECT_LT(glm::distance(inner.p_world, evaluate(rig.laid().volume, {u, 0.5, 1}).value), 1e-12);
    const std::size_t before = rig.steps();
    rig.lengthen(inner, 0.5f);
    EXPECT_EQ(rig.steps(), before + 1);
    const HeightGrid& grid = rig.step().parameters.height_map;
    EXPECT_NEAR(HeightMap(grid).at(u, 0.5), 1.5, 0.05);
    EXPECT_EQ(rig.step().parameters.height, p.height);
    HeightGrid others = grid;
    others[1][1] = 1;
    EXPECT_EQ(others, p.height_map);
}

TEST(PlacementHandles, TheEndsOfTheModelSlideAlongTheStroke)
{
    PlacedRig rig({1000, 760}); // no card lies over the ends
    const Handle start = rig.handle({"start"}), end = rig.handle({"end"});
    rig.pull(start, {80, 0});
    const double begins = rig.step().parameters.start;
    EXPECT_GT(begins, 0.1);
    EXPECT_NEAR(begins + rig.step().parameters.fill, 1, 1e-9);
    rig.pull(end, {-60, 0});
    EXPECT_EQ(rig.step().parameters.start, begins);
    EXPECT_LT(begins + rig.step().parameters.fill, 0.95);
}

TEST(PlacementHandles, APlaceOfTheStrokeIsPulledWhereTheMouseGoes)
{
    PlacedRig rig;
    const Handle middle = rig.handle({"stroke", {1}});
    const glm::vec2 goal = rig.seen_at(middle.p_world) + glm::vec2(0, 40);
    const Sketch before = rig.step().sketch;
    rig.pull(middle, {0, 40});
    const NearestLine now =
        nearest_on_line(rig.laid(), rig.editor.session.view.camera, goal - rig.layout().view.lo);
    EXPECT_LT(now.distance_px, 4);
    EXPECT_EQ(rig.step().sketch.samples.front().p_px, before.samples.front().p_px);
    EXPECT_EQ(rig.step().sketch.samples.back().p_px, before.samples.back().p_px);
}

TEST(PlacementHandles, AlsoFromAnotherSideThanItWasDrawnFrom)
{
    PlacedRig rig;
    rig.editor.session.view.camera.eye = {-4, -4, 5};
    rig.frames(4);
    const Handle end = rig.handle({"stroke", {2}});
    const glm::vec2 goal = rig.seen_at(end.p_world) + glm::vec2(25, 30);
    rig.pull(end, {25, 30});
    const NearestLine now =
        nearest_on_line(rig.laid(), rig.editor.session.view.camera, goal - rig.layout().view.lo);
    EXPECT_LT(now.distance_px, 4);
}

TEST(PlacementHandles, ARimSetsTheWidthOfWhatWentWithItsHostAndKeepsItAttached)
{
    PlacedRig rig;
    const auto touched = [&] {
        std::vector<Id> ids;
        if (rig.step().attach)
            for (const AttachedHost& host : rig.step().attach->hosts)
                if (host.touched) ids.push_back(host.object);
        return ids;
    };
    const auto middle = [&] { // of the stroke, on the host
        const std::vector<glm::dvec3>& line = rig.laid().strip.front();
        return line[line.size() / 2];
    };
    const auto pulled = [&] { // a rim, as far again
        const Handle rim = rig.handle({"width"});
        rig.lengthen(rim, 1);
    };
    ASSERT_THAT(touched(), ElementsAre(1));
    const double width = rig.laid().report.width_world;
    const glm::dvec3 narrow = middle();
    PlacementParameters p = rig.step().parameters;
    p.width = 2 * width;
    ASSERT_TRUE(rig.editor.session.run(EditPlacement{2, p, {}, {}}));
    rig.wait();
    const glm::dvec3 wide = middle();
    rig.editor.session.undo();
    const auto expect_carried = [&](const glm::dvec3& drawn, const Transform& host) {
        EXPECT_LT(glm::distance(middle(), glm::dvec3(host.matrix() * glm::dvec4(drawn, 1))), 1e-3);
    };
    const Transform there{.translation = {0.3, 0.4, 0.2}, .rotation_deg = {10, 0, 25}};
    ASSERT_TRUE(rig.editor.session.run(SetTransform{1, there}));
    rig.wait();
    expect_carried(narrow, there);
    const std::size_t steps = rig.steps();
    const std::string causes = digest(rig.editor.session.committed()),
                      effects = digest(rig.editor.session.evaluated());
    pulled();
    EXPECT_EQ(rig.steps(), steps + 1);
    EXPECT_NEAR(rig.step().parameters.width, 2 * width, 0.03 * width);
    EXPECT_NEAR(rig.laid().report.width_world, 2 * width, 0.03 * width);
    EXPECT_THAT(touched(), ElementsAre(1));
    expect_carried(wide, there);
    const Transform further{.translation = {-0.2, 0.1, 0.3}, .rotation_deg = {0, 5, -20}};
    ASSERT_TRUE(rig.editor.session.run(SetTransform{1, further}));
    rig.wait();
    expect_carried(wide, further);
    EXPECT_NEAR(rig.laid().report.width_world, 2 * width, 0.03 * width);
    rig.editor.session.undo();
    rig.editor.session.undo();
    rig.wait();
    EXPECT_EQ(digest(rig.editor.session.committed()), causes);
    EXPECT_EQ(digest(rig.editor.session.evaluated()), effects);
}

TEST(PlacementHandles, TakeATypedNumberInPlaceOfTheWayOfTheHand)
{
    PlacedRig rig;
    const std::size_t before = rig.steps();
    const auto type = [&](const HandleKey& key, const std::string& number) {
        const glm::vec2 at = rig.in_window(rig.handle(key));
        rig.move(at);
        rig.draw({at, at + glm::vec2(0, 9)}, false);
        rig.type(number);
        rig.key({ui::key_enter});
        rig.screen.input().push(ui::press(ui::Button::left, false));
        rig.wait();
    };
    type({"width"}, "0.7312345");
    EXPECT_EQ(rig.steps(), before + 1);
    EXPECT_NEAR(rig.laid().report.width_world, 0.7312345, 1e-9);
    EXPECT_EQ(rig.handle({"width"}).words, "width 0.731 m");
    type({"height"}, "45 cm");
    EXPECT_NEAR(rig.laid().report.height_world, 0.45, 1e-9);
    type({"sunk"}, "25");
    EXPECT_EQ(rig.step().parameters.contact_level, 0.25);
    type({"width"}, "-1"); // is refused, in a sentence
    EXPECT_EQ(rig.steps(), before + 3);
    EXPECT_FALSE(rig.editor.session.notices.all().empty());
    EXPECT_FALSE(rig.editor.active_tool().busy());
}

TEST(PlacementHandles, EscapeAndWhatIsLockedLeaveNoTrace)
{
    PlacedRig rig;
    const std::size_t before = rig.steps();
    const std::string then = digest(rig.editor.session.committed());
    const Handle rim = rig.handle({"width"});
    const glm::vec2 at = rig.in_window(rim);
    rig.move(at);
    rig.draw({at, at + glm::vec2(0, 50)}, false);
    EXPECT_TRUE(rig.editor.active_tool().busy());
    rig.key({ui::key_escape});
    rig.screen.input().push(ui::press(ui::Button::left, false));
    rig.wait();
    EXPECT_EQ(rig.steps(), before);
    EXPECT_EQ(digest(rig.editor.session.document()), then);
    ASSERT_TRUE(rig.editor.session.run(Lock{{2}}));
    rig.wait();
    EXPECT_EQ(selected_placement(rig.editor.session), nullptr);
}

TEST(PlaceTool, AStrokeFromTheOldOneRedrawsThatPartOfIt)
{
    PlacedRig rig;
    rig.key({'D'});
    const Sketch before = rig.step().sketch;
    const auto on_line = [&](double u) {
        const std::vector<glm::dvec3>& line = rig.laid().strip.front();
        return rig.seen_at(
            line[static_cast<std::size_t>(u * static_cast<double>(line.size() - 1))]);
    };
    const std::size_t steps = rig.steps();
    const glm::vec2 a = on_line(0.3), b = on_line(0.72), hill = (a + b) / 2.0f - glm::vec2(0, 60);
    rig.move(a);
    rig.draw({a, hill, b});
    rig.wait();
    EXPECT_EQ(rig.steps(), steps + 1);
    const Sketch& now = rig.step().sketch;
    EXPECT_EQ(now.samples.front().p_px, before.samples.front().p_px);
    EXPECT_EQ(now.samples.back().p_px, before.samples.back().p_px);
    EXPECT_LT(nearest_share(now, glm::dvec2(hill - rig.layout().view.lo)).distance_px, 2);
    EXPECT_GT(length_px(now.samples), length_px(before.samples) + 20);
}

TEST(PlaceTool, TheWheelSetsTheWidthWhileAStrokeIsDrawn)
{
    Rig rig;
    rig.two_objects();
    rig.key({'D'});
    const Camera before = rig.editor.session.view.camera;
    rig.draw(rig.stroke(), false);
    rig.wait();
    const double width =
        rig.editor.session.evaluated().objects.at(2)->placement->report.width_world;
    rig.screen.input().push(ui::turn_wheel(2));
    rig.frames(3);
    rig.wait();
    rig.screen.input().push(ui::press(ui::Button::left, false));
    rig.wait();
    EXPECT_EQ(rig.editor.session.view.camera, before);
    EXPECT_NEAR(object(rig.editor.session.document(), 2).stroke->parameters.width, 1.21 * width,
                0.01 * width);
}

} // namespace
} // namespace trivar
