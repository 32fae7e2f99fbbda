// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/cutting/peel.h"
#include "core/commands/objects/animate.h"
#include "core/document/document_digest.h"
#include "tests/support/scenes/incised_ball.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using testing::ball_in, testing::ball_to_incise, testing::over_ball;
using ::testing::Contains, ::testing::HasSubstr, ::testing::IsEmpty, ::testing::ThrowsMessage;

auto refuses(const char* words)
{
    return ThrowsMessage<Rejected>(HasSubstr(words));
}

// Two incisions that cross before a ball of radius 1, the first one from left to right and the
// second one from below to above.
Document crossed_ball(double opening = 1)
{
    Document out = ball_to_incise();
    for (const bool second : {false, true}) {
        NamedIncision cut = second ? over_ball({0.02, -1, -0.4}, {0.02, -1, 0.4})
                                   : over_ball({-0.4, -1, 0.01}, {0.4, -1, 0.01});
        cut.cut.width = 0.12;
        cut.cut.depth = 0.1;
        cut.opening.share = opening;
        out = after(out, Incise{1, cut});
    }
    return out;
}

// The flap to the upper right, seen from outside, where the first incision goes to the right.
PeeledFlap upper_right(double lift)
{
    return {
        .side_of_first = IncisionSide::left, .side_of_second = IncisionSide::right, .lift = lift};
}

Ref<Mesh> mesh_in(const Document& document, double frame = 1)
{
    return ball_in(document, frame)->parts.at(0).mesh();
}

// The greatest distance of a vertex from the middle of the ball, by the quarter of the front in
// which it is.
double highest(const Mesh& mesh, bool right, bool above)
{
    double out = 0;
    for (const glm::vec3& p : mesh.positions)
        if (p.y < 0 && (p.x > 0.02f) == right && (p.z > 0.01f) == above)
            out = std::max(out, glm::length(glm::dvec3(p)));
    return out;
}

TEST(PeeledFlaps, RiseByTheirLiftAndNoOtherDoes)
{
    const Mesh mesh = *mesh_in(after(crossed_ball(), PeelFlap{1, upper_right(0.1)}));
    EXPECT_NEAR(highest(mesh, true, true), 1.1, 0.01);
    // Lips slide over a round ball on straight ways
    EXPECT_LT(highest(mesh, false, true), 1.015);
    EXPECT_LT(highest(mesh, true, false), 1.015);
    EXPECT_LT(highest(mesh, false, false), 1.015);
}

TEST(PeeledFlaps, ChangeNothingWhereTheyLieOrAllIsShut)
{
    const Document open = crossed_ball();
    const Ref<EvaluatedObject> lying = ball_in(after(open, PeelFlap{1, upper_right(0)}));
    EXPECT_EQ(*lying->parts.at(0).mesh(), *mesh_in(open));
    const Ref<EvaluatedObject> shut =
        ball_in(after(crossed_ball(0), PeelFlap{1, upper_right(0.1)}));
    EXPECT_EQ(*shut->parts.at(0).mesh(), *mesh_in(ball_to_incise()));
    EXPECT_THAT(shut->notices, IsEmpty());
}

TEST(PeeledFlaps, TurnTheNormalsOfTheirSkin)
{
    const Document open = crossed_ball();
    const Mesh flat = *mesh_in(open), raised = *mesh_in(after(open, PeelFlap{1, upper_right(0.1)}));
    ASSERT_EQ(flat.vertex_count(), raised.vertex_count());
    int turned = 0;
    for (std::size_t v = 0; v < flat.vertex_count(); ++v) {
        EXPECT_NEAR(glm::length(raised.normals[v]), 1, 1e-4);
        turned += glm::dot(flat.normals[v], raised.normals[v]) < 0.99f;
        if (flat.positions[v].y > 0) {
            EXPECT_EQ(flat.normals[v], raised.normals[v]);
        }
    }
    EXPECT_GT(turned, 4);
}

TEST(PeeledFlaps, StayWithTheirIncisions)
{
    const Document peeled = after(crossed_ball(), PeelFlap{1, upper_right(0.1)});
    const auto flaps = [](const Document& document) { return object(document, 1).incising->flaps; };
    // The same flap again is the same entry, whichever incision is named first
    PeeledFlap other{2, 1, IncisionSide::right, IncisionSide::left, 0.05};
    ASSERT_EQ(flaps(after(peeled, PeelFlap{1, other})).size(), 1u);
    EXPECT_EQ(flaps(after(peeled, PeelFlap{1, other})).front(), upper_right(0.05));

    const Document swapped = after(peeled, SwapIncisions{1, 1, 2});
    EXPECT_EQ(flaps(swapped).front().side_of_first, IncisionSide::right);
    EXPECT_NEAR(highest(*mesh_in(swapped), true, true), 1.1, 0.01);
    EXPECT_EQ(digest(after(swapped, SwapIncisions{1, 2, 1})), digest(peeled));

    const Document turned =
        after(peeled, EditIncision{1, 1, reversed(object(peeled, 1).incising->cuts.front())});
    EXPECT_EQ(flaps(turned).front().side_of_first, IncisionSide::right);
    EXPECT_NEAR(highest(*mesh_in(turned), true, true), 1.1, 0.01);

    EXPECT_TRUE(flaps(after(peeled, RemoveIncision{1, 1})).empty());
    EXPECT_TRUE(flaps(after(peeled, LayFlap{1, 1})).empty());
}

TEST(PeeledFlaps, RiseWithKeysThatGoWhereTheyGo)
{
    Document document = after(crossed_ball(), Incise{1, over_ball({0.5, -1, 0}, {0.6, -0.8, 0.3})});
    PeeledFlap none = upper_right(0);
    none.second = 3;
    document = after(document, PeelFlap{1, none});
    document = after(document, PeelFlap{1, upper_right(0)});
    document = after(document, Animate{{{1, {{"incising.flaps.1.lift", {{1, 0}, {21, 0.1}}}}}}});
    EXPECT_LT(highest(*mesh_in(document, 1), true, true), 1.015);
    EXPECT_NEAR(highest(*mesh_in(document, 21), true, true), 1.1, 0.01);
    // The flap before it goes with its incision
    document = after(document, RemoveIncision{1, 3});
    ASSERT_EQ(object(document, 1).tracks.size(), 1u);
    EXPECT_EQ(object(document, 1).tracks.begin()->parameter, "incising.flaps.0.lift");
    EXPECT_NEAR(highest(*mesh_in(document, 21), true, true), 1.1, 0.01);
    EXPECT_TRUE(object(after(document, ClearIncisions{{1}}), 1).tracks.empty());
}

TEST(PeeledFlaps, SayWhereThereIsNothingToRaise)
{
    Document document =
        after(crossed_ball(), Incise{1, over_ball({0.5, -0.6, -0.3}, {0.6, -0.6, 0.3})});
    PeeledFlap apart = upper_right(0.1);
    apart.second = 3;
    document = after(document, PeelFlap{1, apart});
    EXPECT_THAT(ball_in(document)->notices,
                Contains(HasSubstr("flap 1 is not raised: incision 1 and incision 3")));
    EXPECT_THAT(
        [&] {
            after(document, PeelFlap{1, {.first = 2, .second = 2}});
        },
        refuses("two different incisions"));
    EXPECT_THAT(
        [&] {
            after(document, PeelFlap{1, {.first = 1, .second = 7}});
        },
        refuses("none of number 7"));
    EXPECT_THAT([&] { after(document, LayFlap{1, 2}); }, refuses("none of number 2"));
    EXPECT_THAT(
        [&] {
            after(document, SwapIncisions{1, 2, 2});
        },
        refuses("two different incisions"));
}

} // namespace
} // namespace trivar
