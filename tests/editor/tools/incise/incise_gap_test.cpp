// SPDX-License-Identifier: GPL-3.0-or-later
// Incisions whose strokes leave the skin.
#include "tests/editor/tools/incise/incise_rig.h"

#include <algorithm>
#include <fmt/format.h>
#include <random>

namespace trivar {
namespace {

using testing::InciseRig;

// A stroke over the front of the ball; the points that `in_air` names stand off it.
NamedIncision over_ball(int points, const std::function<bool(int)>& in_air)
{
    NamedIncision out;
    out.cut.width = 0.05;
    out.cut.depth = 0.1;
    for (int i = 0; i < points; ++i) {
        const double angle = -0.8 + 1.6 * i / (points - 1);
        const glm::dvec3 n(std::sin(angle), -std::cos(angle), 0);
        out.cut.stroke.push_back({n * (in_air(i) ? 1.5 : 1.0), n});
    }
    return out;
}

std::optional<SeenIncision> seen_of(InciseRig& rig, const NamedIncision& incision)
{
    rig.editor.session.run(ClearIncisions{{1}});
    rig.editor.session.run(Incise{1, incision});
    rig.editor.session.incision = {1, 1};
    rig.wait();
    IncisedSkin skin;
    skin.look(rig.editor.session, 1);
    return seen_incision(skin, incision, nullptr);
}

TEST(SeenIncision, OfAStrokeInTheAirIsNothing)
{
    InciseRig rig;
    EXPECT_FALSE(seen_of(rig, over_ball(9, [](int) { return true; })));
    EXPECT_TRUE(rig.tool().handles(rig.editor.session, 1).empty());
}

TEST(SeenIncision, OfAStrokeThatJumpsAGapHasItsHandlesOnTheLongestPart)
{
    InciseRig rig;
    const auto seen = seen_of(rig, over_ball(21, [](int i) { return i > 4 && i < 10; }));
    ASSERT_TRUE(seen);
    EXPECT_FALSE(seen->on_skin[20]);
    EXPECT_GT(seen->first, 24u);
    EXPECT_EQ(seen->last, SeenIncision::steps);
    const auto handles = rig.tool().handles(rig.editor.session, 1);
    EXPECT_GE(handles.size(), 5u);
    for (const Handle& each : handles)
        if (each.key.kind == "place" || each.key.kind == "left" || each.key.kind == "right" ||
            each.key.kind == "depth") {
            const auto at = std::ranges::find(seen->line, each.p_world, &SurfaceHit::p_world);
            ASSERT_NE(at, seen->line.end()) << each.key.kind;
            EXPECT_TRUE(seen->on_skin[static_cast<std::size_t>(at - seen->line.begin())]);
        }
    for (std::size_t i = 0; i < seen->line.size(); ++i)
        EXPECT_LT(seen->line[i].p_world.y, 0) << "the gap is bridged between its ends";
}

// Whatever leaves the skin wherever, all that reads a cut finds a place for each step.
TEST(SeenIncision, HasAPlaceForEachStepWhateverOfItIsInTheAir)
{
    InciseRig rig;
    std::mt19937 dice(7);
    for (int round = 0; round < 25; ++round) {
        const unsigned air = dice() % 8;
        std::vector<bool> in_air;
        for (int i = 0; i < 17; ++i) in_air.push_back(dice() % 8 < air);
        const auto seen =
            seen_of(rig, over_ball(17, [&](int i) { return in_air[static_cast<std::size_t>(i)]; }));
        const auto handles = rig.tool().handles(rig.editor.session, 1);
        EXPECT_EQ(handles.empty(), !seen) << round;
        for (const Handle& each : handles) { // each can be hovered, dragged and let go
            const glm::vec2 at = rig.in_window(each);
            rig.draw({at, at + glm::vec2(6, 5)});
        }
        rig.wait();
        if (!seen) continue;
        EXPECT_LE(seen->first, seen->last);
        for (std::size_t i = seen->first; i <= seen->last; ++i) EXPECT_TRUE(seen->on_skin[i]);
        for (const SurfaceHit& each : seen->line)
            EXPECT_TRUE(std::isfinite(glm::length(each.p_world)));
    }
}

TEST(SeenIncision, CrossesNothingInTheAir)
{
    InciseRig rig;
    rig.editor.session.run(Incise{1, over_ball(21, [](int i) { return i > 6 && i < 14; })});
    NamedIncision down;
    down.cut.width = 0.05;
    down.cut.depth = 0.1;
    for (int i = 0; i < 9; ++i) {
        const double angle = -0.6 + 1.2 * i / 8;
        const glm::dvec3 n(0, -std::cos(angle), std::sin(angle));
        down.cut.stroke.push_back({n, n});
    }
    rig.editor.session.run(Incise{1, down});
    rig.editor.session.incision = {1, 2};
    rig.wait();
    const auto handles = rig.tool().handles(rig.editor.session, 1);
    EXPECT_FALSE(handles.empty());
    for (const Handle& each : handles) EXPECT_NE(each.key.kind, "crossing");
}

} // namespace
} // namespace trivar
