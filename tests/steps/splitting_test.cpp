// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/cutting/split.h"
#include "core/commands/edits/edits.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/paste.h"
#include "core/commands/tiles/tiles.h"
#include "core/document/document_digest.h"
#include "core/evaluation/evaluate.h"
#include "core/mesh/closed_body.h"
#include "core/split/split_field.h"
#include "tests/support/fixtures.h"
#include "tests/support/scenes/commands.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr;
using testing::new_evaluator;
using ::testing::ThrowsMessage;

constexpr Id ball_id = 1, pillar_id = 2;

// A ball at y, in the way of a pillar that stands in the origin.
Document ball_and_pillar(double y)
{
    Transform there;
    there.translation = {0.05, y, 0};
    Document document =
        after(Document{},
              AddSphere{.shape = {.radius = 1, .segments = 48, .rings = 24}, .transform = there});
    return after(document, AddCylinder{.shape = {.radius = 0.25, .height = 4}});
}

Split by_the_pillar()
{
    return {{ball_id}, {.obstacles = {{.object = pillar_id, .clearance = 0.01}}}};
}

Ref<EvaluatedObject> shown_ball(const Document& document)
{
    return new_evaluator()(document, 1).objects.at(ball_id);
}

TEST(Splitting, PartsABallIntoClosedHalvesRoundAPillar)
{
    const Ref<EvaluatedObject> ball = shown_ball(after(ball_and_pillar(-0.2), by_the_pillar()));
    ASSERT_TRUE(ball->split_field);
    EXPECT_TRUE(ball->notices.empty());
    const Mesh& mesh = *ball->parts.at(0).mesh();
    EXPECT_TRUE(is_closed_body(mesh));
    EXPECT_GT(ball->split_off, 0);
    EXPECT_LE(ball->split_off, 2e-3);
    for (const glm::vec3& p : mesh.positions)
        EXPECT_GT(glm::length(glm::dvec2(p.x, p.y)), 0.25 * 0.998); // its cylinder has flat sides
}

TEST(Splitting, LeavesABallThatMeetsNothingAsItIs)
{
    for (const double y : {-3.0, 3.0}) {
        const Document document = ball_and_pillar(y);
        const Ref<EvaluatedObject> split = shown_ball(after(document, by_the_pillar()));
        EXPECT_EQ(*split->parts.at(0).rest, *shown_ball(document)->parts.at(0).rest);
        EXPECT_EQ(split->parts.at(0).to_world, shown_ball(document)->parts.at(0).to_world);
        EXPECT_TRUE(split->notices.empty());
    }
}

TEST(Splitting, ShowsAPatternInsideThatStaysWithTheBody)
{
    Split command = by_the_pillar();
    command.splitting.inside = Filling::wood;
    const Ref<EvaluatedObject> ball = shown_ball(after(ball_and_pillar(-0.2), command));
    ASSERT_EQ(ball->materials->size(), 2u);
    EXPECT_EQ((*ball->materials)[1].filling, Filling::wood);
    const Part& part = ball->parts.at(0);
    ASSERT_TRUE(part.before_split);
    EXPECT_EQ(part.before_split->corners, part.mesh()->corners);
    EXPECT_EQ(part.mesh()->face_material.back(), 1u);
    for (const glm::vec3& p : part.before_split->positions)
        EXPECT_LE(glm::length(glm::dvec3(p)), 1.0001); // in the ball's own space
}

TEST(Splitting, StaysWithAHiddenObstacleAndEndsWithADeletedOne)
{
    const Document document = after(ball_and_pillar(0), by_the_pillar());
    EXPECT_TRUE(shown_ball(after(document, Hide{{pillar_id}}))->split_field);
    const Document without = after(document, Delete{{pillar_id}});
    EXPECT_FALSE(object(without, ball_id).splitting);
    EXPECT_FALSE(shown_ball(without)->split_field);
}

TEST(Splitting, IsTakenBack)
{
    const Document before = ball_and_pillar(0);
    const Document document = after(before, by_the_pillar());
    EXPECT_NE(digest(document), digest(before));
    EXPECT_EQ(digest(after(document, ClearSplit{{ball_id}})), digest(before));
}

TEST(Splitting, ReadsTheSwitchOfOlderFiles)
{
    const auto closing = [](const std::string& value) {
        const Command command = command_from_json_line(
            R"({"do": "split", "objects": [1], "obstacles": [{"object": 2}], "capped": )" + value +
            "}");
        return command.get<Split>().splitting.closing;
    };
    EXPECT_EQ(closing("false"), SplitClosing::open);
    EXPECT_EQ(closing("true"), SplitClosing::capped);
    EXPECT_EQ(closing("\"stitched\""), SplitClosing::stitched);
    EXPECT_THAT([&] { closing("1"); }, ThrowsMessage<Rejected>(HasSubstr("stitched")));
    // The digests are from the time when it was a switch.
    Split command = by_the_pillar();
    EXPECT_EQ(digest(after(ball_and_pillar(0), command)), "c84269b190dba4de573d2a230e2bb461");
    command.splitting.closing = SplitClosing::open;
    EXPECT_EQ(digest(after(ball_and_pillar(0), command)), "fa6a0a65944d6555ba9f8ba3cd426e8a");
}

TEST(Splitting, OpensEarlierWithSmoothEnds)
{
    const Document before = ball_and_pillar(-0.2);
    Split command = by_the_pillar();
    const Ref<EvaluatedObject> sharp = shown_ball(after(before, command));
    command.splitting.ends = SplitEnds::smooth;
    const Document document = after(before, command);
    EXPECT_NE(digest(document), digest(after(before, by_the_pillar())));
    const Ref<EvaluatedObject> smooth = shown_ball(document);
    ASSERT_TRUE(smooth->split_field);
    EXPECT_LT(smooth->split_field->openings.at(0).walls[0].lo().x,
              sharp->split_field->openings.at(0).walls[0].lo().x);
    EXPECT_TRUE(smooth->notices.empty());
    EXPECT_TRUE(is_closed_body(*smooth->parts.at(0).mesh()));
    for (const glm::vec3& p : smooth->parts.at(0).mesh()->positions)
        EXPECT_GT(glm::length(glm::dvec2(p.x, p.y)), 0.25 * 0.998);
}

TEST(Splitting, IsTheSameWhateverFramesCameBefore)
{
    auto evaluator = new_evaluator();
    for (const double y : {-1.0, -0.2, 3.0, 0.4, -0.2, -1.1, -0.9, -0.7, -0.5, -0.3, 0.8}) {
        SCOPED_TRACE(y);
        const Document document = after(ball_and_pillar(y), by_the_pillar());
        const Ref<EvaluatedObject> ball = evaluator(document, 1).objects.at(ball_id);
        const Ref<EvaluatedObject> alone = shown_ball(document);
        EXPECT_EQ(*ball->parts.at(0).mesh(), *alone->parts.at(0).mesh());
        EXPECT_EQ(ball->parts.at(0).bounds.lo, alone->parts.at(0).bounds.lo);
        EXPECT_EQ(ball->parts.at(0).bounds.hi, alone->parts.at(0).bounds.hi);
    }
}

TEST(Splitting, StitchesABallRoundAPillar)
{
    Split command = by_the_pillar();
    command.splitting.closing = SplitClosing::stitched;
    const Ref<EvaluatedObject> ball = shown_ball(after(ball_and_pillar(-0.2), command));
    ASSERT_TRUE(ball->split_field);
    EXPECT_TRUE(ball->notices.empty());
    EXPECT_TRUE(is_closed_body(*ball->parts.at(0).mesh()));
    EXPECT_LE(ball->split_off, 2e-3);
    for (const glm::vec3& p : ball->parts.at(0).mesh()->positions)
        EXPECT_GT(glm::length(glm::dvec2(p.x, p.y)), 0.25 * 0.998);
}

TEST(Splitting, IsCopiedWithItsObstacle)
{
    const Document document = after(ball_and_pillar(0), by_the_pillar());
    const Document alone = after(document, copied(document, {ball_id}, "/nowhere"));
    EXPECT_EQ(object(alone, 3).splitting, object(document, ball_id).splitting);
    const Document both = after(document, copied(document, {ball_id, pillar_id}, "/nowhere"));
    ASSERT_TRUE(object(both, 3).splitting);
    EXPECT_EQ(object(both, 3).splitting->obstacles.at(0).object, 4);
    const Document twin = after(document, Duplicate{{ball_id}});
    EXPECT_EQ(object(twin, 3).splitting, object(document, ball_id).splitting);
}

TEST(Splitting, RefusesWhatCannotPartIt)
{
    const Document document = ball_and_pillar(0);
    const auto refused = [&](Split command, const std::string& words) {
        EXPECT_THAT([&] { after(document, command); }, ThrowsMessage<Rejected>(HasSubstr(words)));
    };
    Split command = by_the_pillar();
    command.splitting.obstacles[0].object = ball_id;
    refused(command, "whose shape depends on it");
    command = by_the_pillar();
    command.splitting.obstacles.push_back(command.splitting.obstacles[0]);
    refused(command, "twice");
    command = by_the_pillar();
    command.splitting.obstacles.clear();
    refused(command, "names no object");
    command = by_the_pillar();
    command.splitting.way = command.splitting.opening;
    refused(command, "two different directions");
    const Document split = after(document, by_the_pillar());
    EXPECT_THAT(
        [&] {
            after(split, Split{{pillar_id}, {.obstacles = {{ball_id}}}});
        },
        ThrowsMessage<Rejected>(HasSubstr("depends on it")));
}

TEST(Splitting, SaysWhereThereIsTooLittleRoom)
{
    Document document = ball_and_pillar(0);
    Transform beside;
    beside.translation = {0.55, 0, 0};
    document =
        after(document, AddCylinder{.shape = {.radius = 0.25, .height = 4}, .transform = beside});
    Split command = by_the_pillar();
    command.splitting.obstacles.push_back({.object = 3});
    const Ref<EvaluatedObject> ball = shown_ball(after(document, command));
    ASSERT_EQ(ball->notices.size(), 1u);
    EXPECT_THAT(ball->notices[0], HasSubstr("too near to another obstacle"));
}

TEST(Splitting, PartsWhatIsTinyAndWhatIsHuge)
{
    for (const double size : {1e-6, 1e7}) {
        Document document =
            after(Document{}, AddSphere{.shape = {.radius = size, .segments = 48, .rings = 24}});
        document =
            after(document, AddCylinder{.shape = {.radius = 0.2 * size, .height = 4 * size}});
        Split command{{1}, {.obstacles = {{.object = 2, .clearance = 0.01 * size}}}};
        command.splitting.tolerance = 2e-3 * size;
        const Ref<EvaluatedObject> ball = shown_ball(after(document, command));
        EXPECT_TRUE(ball->notices.empty());
        ASSERT_TRUE(ball->split_apart);
        for (const Part& part : ball->parts)
            for (const glm::vec3& p : part.mesh()->positions)
                EXPECT_GT(glm::length(glm::dvec2(p.x, p.y)), 0.2 * 0.998 * size);
    }
}

TEST(Splitting, KeepsItsFieldWhileTheObstacleMoves)
{
    const Document document = after(ball_and_pillar(0), by_the_pillar());
    Evaluator evaluator = new_evaluator();
    const Ref<EvaluatedObject> first = evaluator(document, 1).objects.at(ball_id);
    Transform moved;
    moved.translation = {0.3, 0.2, 0};
    const Ref<EvaluatedObject> second =
        evaluator(after(document, SetTransform{.object = pillar_id, .transform = moved}), 1)
            .objects.at(ball_id);
    ASSERT_TRUE(first->split_field && second->split_field);
    const Opening &a = first->split_field->openings.at(0), &b = second->split_field->openings.at(0);
    EXPECT_EQ(a.walls[0].height.points, b.walls[0].height.points);
    EXPECT_EQ(second->split_field->frame.origin,
              first->split_field->frame.origin + moved.translation);
}

TEST(Splitting, PartsTilesWithWhatTheyArePaintedOn)
{
    Document document = after(ball_and_pillar(-0.2),
                              AddBox{.shape = {.size = {0.1, 0.1, 0.05}, .segments = {1, 1, 1}}});
    TileStroke fill;
    fill.brush = TileBrush::fill;
    fill.size = 0.12;
    fill.samples = {{{{0, -1, 0}, {0, -1, 0}}}};
    document = after(document, PaintTiles{3, ball_id, fill});
    const Ref<EvaluatedObject> whole = new_evaluator()(document, 1).objects.at(3);
    const Ref<EvaluatedObject> parted =
        new_evaluator()(after(document, by_the_pillar()), 1).objects.at(3);
    ASSERT_TRUE(parted->split_field);
    EXPECT_EQ(parted->painted, whole->painted); // they are laid on the ball as it was
    EXPECT_TRUE(parted->notices.empty());
    for (const Part& part : parted->parts)
        for (const glm::vec3& p : part.mesh()->positions)
            EXPECT_GT(glm::length(glm::dvec2(p.x, p.y)), 0.25 * 0.998);
}

} // namespace
} // namespace trivar
