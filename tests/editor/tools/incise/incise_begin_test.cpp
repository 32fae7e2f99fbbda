// SPDX-License-Identifier: GPL-3.0-or-later
// Strokes that begin, end or go on beside the skin, on walls and at crossings.
#include "tests/editor/tools/incise/incise_rig.h"

namespace trivar {
namespace {

using testing::InciseRig;

double away_from(const NamedIncision& incision, const SurfacePoint& p)
{
    double out = 1e9;
    for (const SurfacePoint& each : at_equal_steps(incision.cut.stroke, 1000))
        out = std::min(out, glm::distance(each.p, p.p));
    return out;
}

TEST(InciseTool, BeginsAStrokeWhereItComesToTheSkin)
{
    InciseRig rig;
    const std::size_t before = rig.steps();
    rig.drag({{-200, 10}, {-150, 5}, {-60, 0}, {40, 10}}); // from beside the ball
    EXPECT_EQ(rig.steps(), before + 1);
    ASSERT_TRUE(rig.incising());
    EXPECT_EQ(rig.outcome().refusal, "");
    EXPECT_EQ(rig.editor.session.selected, 1u);
    const SurfacePoint& first = rig.one().cut.stroke.front();
    EXPECT_NEAR(glm::length(first.p), 1, 0.01);
    EXPECT_LT(first.p.x, -0.85); // near the silhouette
}

TEST(InciseTool, LeavesAllAsItIsWhereAStrokeMeetsNothing)
{
    InciseRig rig;
    rig.cut();
    const std::size_t before = rig.steps();
    const ChosenIncision chosen = rig.editor.session.incision;
    rig.drag({{-200, -100}, {-190, 100}});
    EXPECT_EQ(rig.steps(), before);
    EXPECT_EQ(rig.editor.session.selected, 1u);
    EXPECT_EQ(rig.editor.session.incision, chosen);
    EXPECT_FALSE(rig.editor.session.notices.all().empty());
}

TEST(InciseTool, BeginsAStrokeOnAnOpenWallAtTheIncisionAboveIt)
{
    InciseRig rig;
    rig.drag({{-110, 0}, {110, 0}});
    EditIncision wide{1, 1, rig.one()};
    wide.incision.cut.width = 0.3;
    wide.incision.cut.depth = 0.3;
    wide.incision.cut.stroke.clear();
    ASSERT_TRUE(rig.editor.session.run(wide));
    rig.editor.session.incision = {};
    rig.wait();
    for (const float y : {-12.0f, 12.0f}) { // on either wall
        const std::size_t k = rig.incising()->cuts.size();
        const float x = y < 0 ? 30 : -40; // apart, as there are flaps at crossings
        rig.drag({{x, y}, {x + 4, 4 * y}, {x + 8, 8 * y}});
        ASSERT_EQ(rig.incising()->cuts.size(), k + 1);
        const std::vector<SurfacePoint>& stroke = rig.one(k).cut.stroke;
        EXPECT_LT(away_from(rig.one(0), stroke.front()), 0.01);
        EXPECT_LT(glm::distance(rig.seen_at(stroke.front().p),
                                rig.layout().view.center() + glm::vec2(x, 0)),
                  8);
        for (std::size_t i = 1; i < stroke.size(); ++i) // it never turns round
            EXPECT_GT((stroke[i - 1].p.z - stroke[i].p.z) * double{y}, -1e-4);
        EXPECT_EQ(rig.outcome(k).refusal, "");
    }
}

TEST(InciseTool, GoesThroughACrossingOfOthers)
{
    InciseRig rig;
    rig.drag({{-110, 0}, {110, 0}});
    rig.drag({{30, -100}, {30, 100}});
    const glm::dvec3 crossing = rig.handle("crossing").p_world;
    rig.drag({{-40, -76}, {26, -2}, {27, 2}, {95, 76}}); // by the crossing, a few pixels off
    ASSERT_EQ(rig.incising()->cuts.size(), 3u);
    double nearest = 1;
    for (const SurfacePoint& each : rig.one(2).cut.stroke)
        nearest = std::min(nearest, glm::distance(each.p, crossing));
    EXPECT_LT(nearest, 1e-3);
    EXPECT_EQ(rig.outcome(2).refusal, "");
}

TEST(IncisionFlaps, ThatAreLaidBackLeaveNoRow)
{
    InciseRig rig;
    rig.drag({{-110, 0}, {110, 0}});
    rig.drag({{30, -100}, {30, 100}});
    const auto pull = [&](float by) {
        rig.move(rig.in_window(rig.handle("crossing")));
        rig.frames(2);
        const Handle flap = rig.handle("flap");
        const glm::vec2 at = rig.in_window(flap);
        rig.move(at);
        rig.frames(2);
        rig.draw({at, at + 0.5f * by * glm::vec2(flap.way_px), at + by * glm::vec2(flap.way_px)});
        rig.wait();
    };
    const std::size_t before = rig.steps();
    pull(-20); // it lies already
    EXPECT_EQ(rig.steps(), before);
    pull(30);
    EXPECT_EQ(rig.incising()->flaps.size(), 1u);
    pull(-300);
    EXPECT_TRUE(rig.incising()->flaps.empty());
    EXPECT_EQ(rig.steps(), before + 2);
}

} // namespace
} // namespace trivar
