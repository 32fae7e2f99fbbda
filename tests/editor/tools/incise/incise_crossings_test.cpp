// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/arrange.h"
#include "core/document/document_digest.h"
#include "core/evaluation/evaluate.h"
#include "tests/editor/tools/incise/incise_rig.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

using testing::InciseRig;

// Two incisions that cross before the camera: the first one to the right, the second one down.
struct CrossedRig : InciseRig {
    CrossedRig()
    {
        drag({{-110, 0}, {110, 0}});
        drag({{30, -100}, {30, 100}});
        EXPECT_EQ(incising()->cuts.size(), 2u);
        EXPECT_EQ(editor.session.incision, (ChosenIncision{1, 2}));
        hover_crossing();
    }
    void hover_crossing()
    {
        move(in_window(handle("crossing")));
        frames(2);
    }
    const std::vector<PeeledFlap>& flaps() const { return incising()->flaps; }
    double farthest() const // of what is shown from the middle of the ball
    {
        double out = 0;
        for (const glm::vec3& p :
             editor.session.evaluated().objects.at(1)->parts.front().mesh()->positions)
            out = std::max(out, static_cast<double>(glm::length(p)));
        return out;
    }
};

TEST(IncisionCrossings, AreFoundWithTheirShares)
{
    CrossedRig rig;
    const auto share = [&] { // of the chosen one
        const std::string words = rig.handle("crossing").words;
        return std::stod(words.substr(std::string("Crosses at ").size())) / 100;
    };
    const Handle at = rig.handle("crossing");
    EXPECT_EQ(at.key, (HandleKey{"crossing", {1, 2}}));
    EXPECT_TRUE(at.words.ends_with("Incision 2 is the later one")) << at.words;
    EXPECT_NEAR(share(), 0.5, 0.05);
    EXPECT_LT(glm::distance(rig.seen_at(at.p_world), rig.layout().view.center() + glm::vec2(30, 0)),
              4);
    rig.editor.session.incision.number = 1;
    rig.frames(2);
    EXPECT_NEAR(share(), 140.0 / 220, 0.05);
}

TEST(IncisionCrossings, LieUnderNoOtherHandle)
{
    CrossedRig rig;
    const glm::dvec2 at = rig.handle("crossing").p_px;
    for (const Handle& each : rig.tool().handles(rig.editor.session, 1))
        if (each.key.kind != "crossing") {
            EXPECT_GT(glm::distance(each.p_px, at), each.key.kind == "flap" ? 9 : 12)
                << each.key.kind;
        }
}

TEST(IncisionCrossings, SlideAlongTheChosenOneAndTakeTheOtherOneWithThem)
{
    CrossedRig rig;
    const NamedIncision first = rig.one(0), second = rig.one(1);
    const std::string whole = digest(rig.editor.session.committed());
    const std::size_t before = rig.steps();
    const glm::vec2 at = rig.in_window(rig.handle("crossing"));
    rig.draw({at, at + glm::vec2(0, 20), at + glm::vec2(4, 45)});
    rig.wait();
    EXPECT_EQ(rig.steps(), before + 1);
    EXPECT_EQ(rig.one(1), second); // the chosen one stays
    EXPECT_EQ(rig.one(0).opening, first.opening);
    for (const SurfacePoint& each : rig.one(0).cut.stroke)
        EXPECT_NEAR(glm::length(each.p), 1, 0.01);
    rig.frames(2);
    EXPECT_LT(glm::distance(rig.in_window(rig.handle("crossing")), at + glm::vec2(0, 45)), 5);
    EXPECT_EQ(rig.outcome(0).refusal, "");
    rig.editor.session.undo();
    rig.wait();
    EXPECT_EQ(digest(rig.editor.session.committed()), whole);
}

TEST(IncisionCrossings, AreSwappedByAClick)
{
    CrossedRig rig;
    const NamedIncision first = rig.one(0), second = rig.one(1);
    const std::size_t before = rig.steps();
    rig.click(rig.in_window(rig.handle("crossing")));
    rig.wait();
    EXPECT_EQ(rig.steps(), before + 1);
    EXPECT_EQ(rig.one(0), second);
    EXPECT_EQ(rig.one(1), first);
    EXPECT_EQ(rig.editor.session.incision, (ChosenIncision{1, 1})); // the same one stays chosen
    rig.editor.session.undo();
    rig.wait();
    EXPECT_EQ(rig.editor.session.incision, (ChosenIncision{1, 2}));
}

TEST(IncisionFlaps, ArePeeledByTheirHandles)
{
    CrossedRig rig;
    const std::string whole = digest(rig.editor.session.committed());
    const std::size_t before = rig.steps();
    EXPECT_LT(rig.farthest(), 1.03);
    const Handle flap = rig.handle("flap");
    const glm::vec2 at = rig.in_window(flap);
    const glm::vec2 up = glm::vec2(flap.way_px) * 30.0f;
    rig.move(at);
    rig.frames(2);
    rig.draw({at, at + 0.5f * up, at + up});
    rig.wait();
    EXPECT_EQ(rig.steps(), before + 1);
    ASSERT_EQ(rig.flaps().size(), 1u);
    const PeeledFlap peeled = rig.flaps().front();
    EXPECT_EQ((std::array{peeled.first, peeled.second}),
              (std::array{flap.key.numbers[0], flap.key.numbers[1]}));
    EXPECT_GT(rig.farthest(), 1 + 0.9 * rig.flaps().front().lift);
    // A second drag goes on from there
    rig.move(at);
    rig.frames(2);
    const Handle now = rig.handle("flap");
    ASSERT_EQ(now.key, flap.key);
    const glm::vec2 there = rig.in_window(now);
    EXPECT_LT(glm::distance(there, at + up), 2); // it went with the hand
    rig.move(there);
    rig.frames(2);
    const double lift = rig.flaps().front().lift;
    rig.draw({there, there - 0.5f * up});
    rig.wait();
    ASSERT_EQ(rig.flaps().size(), 1u);
    EXPECT_NEAR(rig.flaps().front().lift, lift / 2, 0.05 * lift);
    EXPECT_TRUE(rig.flaps().front().same_place(peeled));
    rig.editor.session.undo();
    rig.editor.session.undo();
    rig.wait();
    EXPECT_EQ(digest(rig.editor.session.committed()), whole);
}

TEST(IncisionFlaps, TakeTypedNumbers)
{
    CrossedRig rig;
    const glm::vec2 at = rig.in_window(rig.handle("flap"));
    rig.move(at);
    rig.frames(2);
    rig.draw({at, at + glm::vec2(0, -10)}, false);
    rig.type("0.2");
    rig.key({ui::key_enter});
    rig.wait();
    ASSERT_EQ(rig.flaps().size(), 1u);
    EXPECT_NEAR(rig.flaps().front().lift, 0.2, 0.005);
}

TEST(InciseTool, BeginsAndEndsStrokesOnTheWayOfAnother)
{
    InciseRig rig;
    rig.drag({{-110, 0}, {110, 0}});
    rig.drag({{40, -100}, {40, -3}});
    ASSERT_EQ(rig.incising()->cuts.size(), 2u);
    const auto away = [&](const SurfacePoint& p) {
        double out = 1e9;
        for (const SurfacePoint& each : at_equal_steps(rig.one(0).cut.stroke, 1000))
            out = std::min(out, glm::distance(each.p, p.p));
        return out;
    };
    EXPECT_LT(away(rig.one(1).cut.stroke.back()), 1.5e-3);
    EXPECT_GT(away(rig.one(1).cut.stroke.front()), 0.2);
    rig.drag({{-60, 2}, {-60, 90}});
    EXPECT_LT(away(rig.one(2).cut.stroke.front()), 1.5e-3);
    EXPECT_EQ(rig.outcome(1).refusal, "");
    EXPECT_EQ(rig.outcome(2).refusal, "");
}

TEST(InciseTool, CutsAlongALineOfTheTextureCoordinates)
{
    InciseRig rig;
    IncisedSkin skin;
    skin.look(rig.editor.session, 1);
    const Camera& camera = rig.editor.session.view.camera;
    const glm::dvec2 middle = 0.5 * glm::dvec2(camera.size_px);
    const auto from = skin.hit(ray_through(camera, middle + glm::dvec2(-60, 20)));
    ASSERT_TRUE(from);
    IncisionStroke stroke(skin, {}, *from, middle + glm::dvec2(-60, 20));
    const std::vector<StrokeSample> way{{.p_px = middle + glm::dvec2(0, 25)},
                                        {.p_px = middle + glm::dvec2(70, 12)}};
    EXPECT_TRUE(stroke.take(camera, way, {.straight = false, .along_uv = true, .scale = 1}));
    const std::vector<SurfacePoint> points = stroke.points();
    ASSERT_GT(points.size(), 8u);
    // A parallel of the ball: on one height
    for (const SurfacePoint& each : points) EXPECT_NEAR(each.p.z, points.front().p.z, 2e-3);
    EXPECT_GT(glm::distance(points.front().p, points.back().p), 0.4);
    // and back, down a meridian
    stroke.take(camera, {{.p_px = middle + glm::dvec2(-58, 90)}},
                {.straight = false, .along_uv = true, .scale = 1});
    const std::vector<SurfacePoint> down = stroke.points();
    EXPECT_LT(down.back().p.z, points.front().p.z - 0.15);
    EXPECT_NEAR(std::atan2(down.back().p.y, down.back().p.x),
                std::atan2(points.front().p.y, points.front().p.x), 5e-3);
}

TEST(IncisionHandles, ShowTheZipWhereTheBladeIs)
{
    InciseRig rig;
    rig.drag({{-110, 0}, {110, 0}});
    EXPECT_TRUE(rig.editor.session.run(
        AddBox{.shape = {.size = {0.05, 0.05, 0.05}}, .transform = {.translation = {0, -1.5, 0}}}));
    NamedIncision cut = rig.one();
    cut.blade = 2;
    EXPECT_TRUE(rig.editor.session.run(EditIncision{1, 1, cut}));
    rig.wait();
    const glm::vec2 knot = rig.in_window(rig.handle("zip").base_px);
    EXPECT_NEAR(knot.x, rig.layout().view.center().x, 6);
    rig.editor.session.run(SetTransform{2, {.translation = {0.25, -1.5, 0}}});
    rig.wait();
    EXPECT_GT(rig.in_window(rig.handle("zip").base_px).x, knot.x + 20);
}

TEST(InciseTool, GivesTheFirstIncisionLayers)
{
    InciseRig rig;
    rig.cut();
    ASSERT_EQ(rig.incising()->layers.size(), 3u);
    EXPECT_EQ(rig.incising()->layers.front().name, "Skin");
    EXPECT_NEAR(rig.incising()->layers.back().depth, rig.one().cut.depth, 1e-4);
    // Whoever took them away keeps it so
    EXPECT_TRUE(rig.editor.session.run(LayerIncisions{{1}, {}}));
    rig.drag({{-90, 80}, {90, 80}});
    EXPECT_TRUE(rig.incising()->layers.empty());
}

TEST(InciseTool, OpensAndDeepensTheChosenOneByKeys)
{
    InciseRig rig;
    rig.cut();
    const NamedIncision first = rig.one();
    const std::size_t before = rig.steps();
    rig.move(rig.layout().view.center() + glm::vec2(0, 90));
    rig.key({.key = 'F', .shift = true});
    rig.frames(2);
    EXPECT_TRUE(rig.tool().busy());
    rig.type("0.3");
    rig.key({ui::key_enter});
    rig.wait();
    EXPECT_EQ(rig.steps(), before + 1);
    EXPECT_NEAR(rig.one().cut.depth, 0.3, 0.01);
    rig.key({'F'});
    rig.frames(2);
    rig.type("40");
    rig.key({ui::key_enter});
    rig.wait();
    EXPECT_NEAR(rig.one().opening.share, 0.4, 1e-9);
    EXPECT_EQ(rig.one().cut.width, first.cut.width);
    rig.key({'F'});
    rig.frames(2);
    rig.key({ui::key_escape});
    rig.wait();
    EXPECT_EQ(rig.steps(), before + 2);
    EXPECT_FALSE(rig.tool().busy());
}

TEST(InciseTool, TakesTheWidthOfAStrokeFromTheKeyboard)
{
    InciseRig rig;
    rig.drag({{-90, 0}, {90, 0}}, false);
    rig.type("0.1");
    rig.screen.input().push(ui::press(ui::Button::left, false));
    rig.frames(3);
    rig.wait();
    EXPECT_NEAR(rig.one().cut.width, 0.1, 0.004);
}

} // namespace
} // namespace trivar
