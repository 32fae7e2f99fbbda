// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/cutting/incise.h"
#include "core/commands/objects/animate.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/primitives.h"
#include "core/incise/incised.h"
#include "tests/support/scenes/incised_ball.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using testing::ball_in, testing::ball_to_incise, testing::over_ball;
using ::testing::HasSubstr, ::testing::ThrowsMessage;

// A ball with an incision from left to right, and a small box that opens it.
Document bladed_ball(const glm::dvec3& at)
{
    const Document two = after(ball_to_incise(), AddBox{.shape = {.size = {0.1, 0.1, 0.1}},
                                                        .transform = {.translation = at}});
    NamedIncision cut = over_ball({-0.5, -1, 0}, {0.5, -1, 0});
    cut.cut.opening_profile.shape = IncisionProfile::Shape::even;
    cut.blade = 2;
    return after(two, Incise{1, cut});
}

// How far the lips stand off the middle of the cut, left or right of the middle of the ball.
double gape(const Document& document, bool right, double frame = 1)
{
    double out = 0;
    const Ref<EvaluatedObject> shown = ball_in(document, frame);
    for (const IncisingEffects::OfMesh& each : shown->incised_meshes) {
        const Mesh &open = *shown->parts.at(0).mesh(), &shut = *each.incised->rest;
        for (std::size_t v = 0; v < open.vertex_count(); ++v)
            if ((shut.positions[v].x > 0) == right && std::abs(shut.positions[v].x) > 0.1f)
                out = std::max(
                    out, static_cast<double>(glm::distance(open.positions[v], shut.positions[v])));
    }
    return out;
}

TEST(IncisionBlade, OpensTheSkinBehindIt)
{
    EXPECT_EQ(gape(bladed_ball({-5, -1, 0}), false), 0);
    const Document half = bladed_ball({0, -1.5, 0.3});
    EXPECT_GT(gape(half, false), 0.04);
    EXPECT_EQ(gape(half, true), 0);
    const Document whole = bladed_ball({5, -1, 0});
    EXPECT_GT(gape(whole, false), 0.04);
    EXPECT_GT(gape(whole, true), 0.04);
    // No further than it may open at all
    Document limited = whole;
    NamedIncision cut = object(whole, 1).incising->cuts.front();
    cut.opening.to = 0.5;
    EXPECT_EQ(gape(after(whole, EditIncision{1, 1, cut}), true), 0);
}

TEST(IncisionBlade, CutsWhereItsKeysTakeIt)
{
    Document document = bladed_ball({-5, -1, 0});
    document = after(document, Animate{{{2, {{"transform.translation.x", {{1, -1}, {21, 1}}}}}}});
    EXPECT_EQ(gape(document, false, 1), 0);
    EXPECT_GT(gape(document, false, 11), 0.04);
    EXPECT_EQ(gape(document, true, 11), 0);
    EXPECT_GT(gape(document, true, 21), 0.04);
}

TEST(IncisionBlade, FollowsAnObjectThatIsTurned)
{
    // Both turn by half about Z: what was at the left is at the right in the world
    Document document = bladed_ball({0.9, 1.2, 0});
    document = after(document, SetTransform{1, {.rotation_deg = {0, 0, 180}}});
    EXPECT_EQ(gape(document, false), 0);
    document = after(document, SetTransform{2, {.translation = {-0.9, 1.2, 0}}});
    EXPECT_GT(gape(document, true), 0.04);
}

TEST(IncisionBlade, IsLetGoWithTheObjectThatItWas)
{
    const Document document = bladed_ball({0, -1.5, 0});
    const Document alone = after(document, Delete{.objects = {2}});
    EXPECT_EQ(object(alone, 1).incising->cuts.front().blade, 0);
    EXPECT_GT(gape(alone, true), 0.04);
    // A copy of both is cut by its own blade
    const Document copied = after(document, Duplicate{.objects = {1, 2}});
    const Id copy = object(copied, 3).incising ? 3 : 4;
    EXPECT_EQ(object(copied, copy).incising->cuts.front().blade, copy == 3 ? 4 : 3);
}

TEST(IncisionBlade, RefusesWhatDependsOnTheSkin)
{
    NamedIncision cut = over_ball({-0.5, -1, 0}, {0.5, -1, 0});
    cut.blade = 1;
    const auto refuses = [](const char* words) {
        return ThrowsMessage<Rejected>(HasSubstr(words));
    };
    EXPECT_THAT([&] { after(ball_to_incise(), Incise{1, cut}); }, refuses("on which it depends"));
    cut.blade = 9;
    EXPECT_THAT([&] { after(ball_to_incise(), Incise{1, cut}); }, refuses("9"));
}

} // namespace
} // namespace trivar
