// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/cutting/split.h"
#include "core/commands/objects/animate.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/shape.h"
#include "core/commands/paste.h"
#include "core/commands/volumes/lattice.h"
#include "core/document/document_digest.h"
#include "core/document/parameters.h"
#include "core/mesh/closed_body.h"
#include "tests/support/scenes/cut_ball.h"

#include <algorithm>
#include <gmock/gmock.h>

namespace trivar {
namespace {

using testing::across;
using testing::drawn_over_two;
using ::testing::HasSubstr;
using testing::new_evaluator;
using testing::one_ball;
using testing::shown_first;
using ::testing::ThrowsMessage;
using testing::volume_of;
using testing::volume_of_part;

TEST(Cutting, CutsABallIntoSolidPiecesThatStandApart)
{
    const Document document = one_ball();
    const Ref<EvaluatedObject> ball = shown_first(after(document, across(0.5)));
    ASSERT_EQ(ball->parts.size(), 2u);
    EXPECT_EQ(ball->pieces, 2u);
    EXPECT_TRUE(ball->notices.empty());
    double sum = 0;
    for (const Part& part : ball->parts) {
        EXPECT_TRUE(is_closed_body(*part.mesh()));
        sum += volume_of_part(part);
    }
    EXPECT_NEAR(sum, volume_of_part(shown_first(document)->parts.at(0)), 1e-6);
    EXPECT_NEAR(bounds_in_world(ball->parts[0]).hi.z, 0.2 - 0.25, 1e-6);
    EXPECT_NEAR(bounds_in_world(ball->parts[1]).lo.z, 0.2 + 0.25, 1e-6);
    EXPECT_NE(ball->parts[0].key, ball->parts[1].key);
}

TEST(Cutting, LeavesEverythingWhereItWasWithoutAGap)
{
    const Document document = one_ball();
    const Ref<EvaluatedObject> ball = shown_first(after(document, across(0)));
    const Mesh& whole = *shown_first(document)->parts.at(0).mesh();
    for (const Part& part : ball->parts) {
        EXPECT_EQ(part.to_world, glm::dmat4(1));
        for (const glm::vec3& p : part.mesh()->positions)
            EXPECT_TRUE(std::abs(p.z - 0.2f) < 1e-5f ||
                        std::ranges::find(whole.positions, p) != whole.positions.end());
    }
}

TEST(Cutting, KeepsOneSide)
{
    const Ref<EvaluatedObject> above = shown_first(after(one_ball(), across(0.5, CutKeep::above)));
    ASSERT_EQ(above->parts.size(), 1u);
    EXPECT_NEAR(bounds_in_world(above->parts[0]).lo.z, 0.2, 1e-5); // it does not move
    const Ref<EvaluatedObject> below = shown_first(after(one_ball(), across(0.5, CutKeep::below)));
    ASSERT_EQ(below->parts.size(), 1u);
    EXPECT_NEAR(bounds_in_world(below->parts[0]).hi.z, 0.2, 1e-5);
}

TEST(Cutting, SaysSoWhereItKeepsNothing)
{
    CutThrough command = across(0, CutKeep::above);
    command.cutting.cuts[0].point = {0, 0, 5};
    const Ref<EvaluatedObject> ball = shown_first(after(one_ball(), command));
    EXPECT_TRUE(ball->parts.empty());
    EXPECT_THAT(ball->notices, ::testing::ElementsAre(HasSubstr("keep nothing")));
    command.cutting.cuts[0].keep = CutKeep::both; // a cut that misses leaves the ball as it is
    EXPECT_EQ(*shown_first(after(one_ball(), command))->parts.at(0).mesh(),
              *shown_first(one_ball())->parts.at(0).mesh());
}

TEST(Cutting, CutsNothingOffAlongAFaceAndSaysSo)
{
    for (const double size : {1e-3, 1.0, 1e4}) {
        const Document box =
            after(Document{}, AddBox{.shape = {.size = glm::dvec3(size), .segments = {1, 1, 1}}});
        for (const CutKeep keep : {CutKeep::both, CutKeep::below, CutKeep::above}) {
            CutThrough command = across(0.05 * size, keep);
            command.cutting.cuts[0].point = {0, 0, size / 2};
            const Ref<EvaluatedObject> shown = shown_first(after(box, command));
            ASSERT_FALSE(shown->notices.empty());
            EXPECT_THAT(shown->notices[0], HasSubstr("only touches"));
            if (keep == CutKeep::above) {
                EXPECT_TRUE(shown->parts.empty());
                EXPECT_THAT(shown->notices.back(), HasSubstr("keep nothing"));
            } else {
                ASSERT_EQ(shown->parts.size(), 1u);
                EXPECT_EQ(shown->parts[0].mesh()->face_count(), 6u);
            }
        }
    }
}

TEST(Cutting, CutsWhatIsTinyAndWhatIsHuge)
{
    for (const double size : {1e-6, 1e7}) {
        const Document ball =
            after(Document{}, AddSphere{.shape = {.radius = size, .segments = 48, .rings = 24}});
        CutThrough command = across(size / 2);
        PlainCut& cut = command.cutting.cuts[0];
        cut.point *= size;
        for (int i = -8; i <= 8; ++i)
            cut.stroke.emplace_back(0.15 * i * size, 0.1 * size * std::sin(i));
        command.cutting.tolerance = 1e-3 * size;
        const Ref<EvaluatedObject> shown = shown_first(after(ball, command));
        EXPECT_TRUE(shown->notices.empty());
        ASSERT_EQ(shown->parts.size(), 2u);
        double sum = 0;
        for (const Part& part : shown->parts) {
            EXPECT_TRUE(is_closed_body(*part.mesh()));
            sum += volume_of_part(part);
        }
        const double whole = volume_of_part(shown_first(ball)->parts.at(0));
        EXPECT_NEAR(sum / whole, 1, 1e-4);
    }
}

TEST(Cutting, GoesThroughEachPieceWhereItStoodWhenTheCutWasDrawn)
{
    // A slanted plane through both pieces, which stood 0.25 m off their places along z
    const glm::dvec3 normal = glm::normalize(glm::dvec3(1, 0, 0.7)), point(0.1, 0, 0);
    const PlainCut second{.point = point, .normal = normal, .opened = {{0, 0, 0.25}}};
    for (const double gap : {0.5, 0.1, 0.0}) {
        CutThrough command = drawn_over_two(second);
        command.cutting.cuts[0].gap = gap;
        const Ref<EvaluatedObject> ball = shown_first(after(one_ball(), command));
        ASSERT_EQ(ball->parts.size(), 4u);
        std::size_t on_plane = 0;
        for (const Part& part : ball->parts) {
            EXPECT_TRUE(is_closed_body(*part.mesh()));
            const bool upper = bounds_in_world(part).center().z > 0.2;
            // The offset takes the point back to its place at that time.
            const glm::dvec3 off(0, 0, upper ? 0.25 - gap / 2 : -0.25 + gap / 2);
            double least = 1e300, most = -1e300;
            for (const glm::vec3& p : part.mesh()->positions) {
                const glm::dvec3 at(part.to_world * glm::dvec4(glm::dvec3(p), 1));
                const double height = glm::dot(at + off - point, normal);
                least = std::min(least, height);
                most = std::max(most, height);
                on_plane += std::abs(height) < 1e-5;
            }
            EXPECT_TRUE(least > -1e-5 || most < 1e-5);
        }
        EXPECT_GT(on_plane, 40u);
    }
    // Where nothing is said of that, it goes straight through the pieces at their own places
    CutThrough old = drawn_over_two({.point = point, .normal = normal});
    old.cutting.cuts[0].gap = 0;
    const Ref<EvaluatedObject> as_before = shown_first(after(one_ball(), old));
    for (const Part& part : as_before->parts) {
        double least = 1e300, most = -1e300;
        for (const glm::vec3& p : part.mesh()->positions) {
            const double height = glm::dot(glm::dvec3(p) - point, normal);
            least = std::min(least, height);
            most = std::max(most, height);
        }
        EXPECT_TRUE(least > -1e-5 || most < 1e-5);
    }
}

TEST(Cutting, CrossesCuts)
{
    CutThrough command = across(0.2);
    command.cutting.cuts.push_back({.normal = {1, 0, 0}, .gap = 0.4});
    command.cutting.cuts.push_back({.normal = {0, 1, 0.3}});
    const Ref<EvaluatedObject> ball = shown_first(after(one_ball(), command));
    EXPECT_EQ(ball->parts.size(), 8u);
    double sum = 0;
    for (const Part& part : ball->parts) {
        EXPECT_TRUE(is_closed_body(*part.mesh()));
        EXPECT_GT(std::abs(bounds_in_world(part).center().x), 0.2);
        sum += volume_of_part(part);
    }
    EXPECT_NEAR(sum, volume_of_part(shown_first(one_ball())->parts.at(0)), 1e-5);
}

TEST(Cutting, OpensByKeysAndOnlyMovesPieces)
{
    Document document = after(one_ball(), across(0));
    document =
        after(document, Animate{{{1, {{"cutting.cuts.0.gap", {{1, 0, Tween::linear}, {11, 1}}}}}}});
    Evaluator evaluator = new_evaluator();
    const auto at = [&](double frame) {
        return evaluator(document_at(document, frame), frame).objects.at(1);
    };
    const Ref<EvaluatedObject> first = at(1), half = at(6), last = at(11);
    EXPECT_NEAR(half->parts[1].to_world[3].z, 0.25, 1e-9);
    EXPECT_NEAR(last->parts[1].to_world[3].z, 0.5, 1e-9);
    for (std::size_t p = 0; p < 2; ++p) {
        EXPECT_EQ(first->parts[p].mesh(), last->parts[p].mesh()); // the same one
        EXPECT_EQ(first->parts[p].key, last->parts[p].key);
    }
}

TEST(Cutting, RidesWithTheObject)
{
    Document document = after(one_ball(), across(0.5));
    Transform turned;
    turned.translation = {3, 0, 0};
    turned.rotation_deg = {0, 90, 0};
    turned.scale = {2, 2, 2};
    document = after(document, SetTransform{.object = 1, .transform = turned});
    const Ref<EvaluatedObject> ball = shown_first(document);
    ASSERT_EQ(ball->parts.size(), 2u);
    EXPECT_NEAR(bounds_in_world(ball->parts[0]).hi.x, 3 + 0.4 - 0.25, 1e-5); // metres of the world
    EXPECT_NEAR(bounds_in_world(ball->parts[1]).lo.x, 3 + 0.4 + 0.25, 1e-5);
    turned.scale = {2, 2, -2};
    const Ref<EvaluatedObject> mirrored =
        shown_first(after(document, SetTransform{.object = 1, .transform = turned}));
    for (const Part& part : mirrored->parts) EXPECT_TRUE(is_closed_body(*part.mesh()));
    EXPECT_NEAR(bounds_in_world(mirrored->parts[1]).hi.x, 3 - 0.4 - 0.25, 1e-5);
}

TEST(Cutting, CutsWhatALatticeBendsAsItIsSeen)
{
    Document document = after(one_ball(), AddLattice{.objects = {1}});
    document =
        after(document, MovePoints{.object = 2,
                                   .shift = {.points = {{1, 1, 3}, {2, 2, 3}}, .by = {0, 0, 0.5}}});
    CutThrough command = across(0.2);
    command.cutting.inside = Filling::wood;
    const Ref<EvaluatedObject> whole = shown_first(document);
    ASSERT_TRUE(whole->parts.at(0).bent);
    const Ref<EvaluatedObject> ball = shown_first(after(document, command));
    ASSERT_EQ(ball->parts.size(), 2u);
    double sum = 0;
    for (const Part& part : ball->parts) {
        EXPECT_TRUE(is_closed_body(*part.mesh()));
        sum += volume_of_part(part);
        ASSERT_TRUE(part.before_split); // the rings of the wood stay with the unbent ball
        ASSERT_EQ(part.before_split->vertex_count(), part.mesh()->vertex_count());
        for (const glm::vec3& p : part.before_split->positions)
            EXPECT_LE(glm::length(glm::dvec3(p)), 1.0001);
    }
    EXPECT_NEAR(sum, volume_of_part(whole->parts[0]), 1e-5);
}

TEST(Cutting, IsSplitAfterwardsPieceByPiece)
{
    Document document = after(one_ball(), AddCylinder{.shape = {.radius = 0.2, .height = 4}});
    CutThrough command = across(0.3);
    command.cutting.inside = Filling::wood;
    document = after(document, command);
    document =
        after(document, Split{{1}, {.obstacles = {{.object = 2}}, .inside = Filling::flesh}});
    const Ref<EvaluatedObject> ball = shown_first(document);
    EXPECT_TRUE(ball->notices.empty());
    ASSERT_EQ(ball->parts.size(), 2u);
    EXPECT_EQ(ball->materials->size(), 3u);
    for (const Part& part : ball->parts) EXPECT_TRUE(is_closed_body(*part.mesh()));
}

TEST(Cutting, CutsWhatAnObstacleLeavesWhereItWasDrawnOverThat)
{
    Document document = after(one_ball(), AddCylinder{.shape = {.radius = 0.2, .height = 4}});
    document = after(document, Split{{1}, {.obstacles = {{.object = 2}}, .opening = {1, 0, 0}}});
    CutThrough command{{1}, {.cuts = {{.point = {0.5, 0, 0}, .normal = {1, 0.3, 0}}}}};
    command.cutting.cuts[0].parted = true;
    const Ref<EvaluatedObject> ball = shown_first(after(document, command));
    EXPECT_TRUE(ball->notices.empty());
    ASSERT_EQ(ball->parts.size(), 2u);
    const glm::dvec3 normal = glm::normalize(glm::dvec3(1, 0.3, 0));
    std::size_t on_plane = 0;
    for (const Part& part : ball->parts) {
        EXPECT_TRUE(is_closed_body(*part.mesh()));
        double least = 1e300, most = -1e300;
        for (const glm::vec3& p : part.mesh()->positions) {
            const double height = glm::dot(glm::dvec3(p) - glm::dvec3(0.5, 0, 0), normal);
            least = std::min(least, height);
            most = std::max(most, height);
            on_plane += std::abs(height) < 1e-5;
        }
        EXPECT_TRUE(least > -1e-5 || most < 1e-5);
    }
    EXPECT_GT(on_plane, 20u);
    EXPECT_NEAR(volume_of(*ball), volume_of(*shown_first(document)), 1e-4);
}

TEST(Cutting, OfWhatIsPartedStaysWhereItIsWhenAnEarlierGapChanges)
{
    Document document = after(one_ball(), AddCylinder{.shape = {.radius = 0.2, .height = 4}});
    document = after(document, Split{{1}, {.obstacles = {{.object = 2}}, .opening = {1, 0, 0}}});
    const auto volumes = [&](double gap, const glm::dvec3& opened) {
        CutThrough command{{1},
                           {.cuts = {{.point = {0, 0, 0.1}, .normal = {0, 0, 1}, .gap = gap},
                                     {.point = {0.5, 0, 0}, .normal = {1, 0, 0.8}}}}};
        command.cutting.cuts[1].parted = true;
        command.cutting.cuts[1].opened = {opened};
        std::vector<double> out;
        const Ref<EvaluatedObject> ball = shown_first(after(document, command));
        for (const Part& part : ball->parts) out.push_back(volume_of_part(part));
        std::ranges::sort(out);
        return out;
    };
    const std::vector<double> drawn = volumes(0.4, {0, 0, 0.2});
    ASSERT_EQ(drawn.size(), 4u);
    for (const double gap : {0.0, 0.1, 1.5}) {
        const std::vector<double> moved = volumes(gap, {0, 0, 0.2});
        ASSERT_EQ(moved.size(), drawn.size());
        for (std::size_t i = 0; i < drawn.size(); ++i) EXPECT_NEAR(moved[i], drawn[i], 1e-4);
    }
    EXPECT_GT(std::abs(volumes(0.4, {})[0] - drawn[0]), 1e-3) << "it was drawn over another gap";
}

TEST(Cutting, IsTakenBack)
{
    const Document before = one_ball(), document = after(before, across(0.5));
    EXPECT_NE(digest(document), digest(before));
    EXPECT_EQ(digest(after(document, ClearCuts{{1}})), digest(before));
    EXPECT_EQ(digest(after(document, RemoveCut{1, 1})), digest(before));
    const Document two = after(before, drawn_over_two({.opened = {{0, 0, 0.25}}}));
    EXPECT_TRUE(object(after(two, RemoveCut{1, 1}), 1).cutting->cuts.at(0).opened.empty());
    EXPECT_EQ(digest(after(two, RemoveCut{1, 2})), digest(document));
}

TEST(Cutting, KeepsTheKeysOfOtherCutsWhenOneIsRemoved)
{
    CutThrough command = across(0.1);
    command.cutting.cuts.push_back({.normal = {1, 0, 0}, .gap = 0.2});
    Document document = after(one_ball(), command);
    document = after(
        document,
        Animate{{{1, {{"cutting.cuts.0.gap", {{1, 0}}}, {"cutting.cuts.1.gap", {{1, 0.7}}}}}}});
    document = after(document, RemoveCut{1, 1});
    ASSERT_EQ(object(document, 1).tracks.all().size(), 1u);
    EXPECT_EQ(object(document, 1).tracks.all()[0].parameter, "cutting.cuts.0.gap");
    EXPECT_EQ(object(document, 1).tracks.all()[0].keys[0].value, 0.7);
}

TEST(Cutting, IsCopiedAndHidden)
{
    const Document document = after(one_ball(), across(0.5));
    const Document twin = after(document, Duplicate{{1}});
    EXPECT_EQ(object(twin, 2).cutting, object(document, 1).cutting);
    const Document pasted = after(document, copied(document, {1}, "/nowhere"));
    EXPECT_EQ(object(pasted, 2).cutting, object(document, 1).cutting);
    const Document hidden = after(document, Hide{{1}});
    EXPECT_FALSE(new_evaluator()(hidden, 1).objects.contains(1));
    EXPECT_EQ(shown_first(after(hidden, Show{{1}}))->parts.size(), 2u);
}

TEST(Cutting, RefusesWhatCutsNothing)
{
    const Document document = one_ball();
    const auto refused = [&](CutThrough command, const std::string& words) {
        EXPECT_THAT([&] { after(document, command); }, ThrowsMessage<Rejected>(HasSubstr(words)));
    };
    refused({{1}, {}}, "name a plane or a stroke");
    CutThrough command = across(0);
    command.cutting.cuts[0].normal = {0, 0, 0};
    refused(command, "no direction");
    command = across(0);
    command.cutting.cuts[0].stroke = {{0, 0}, {1, 1}, {0.5, 2}};
    refused(command, "turns back");
    command.cutting.cuts[0].stroke = {{0, 0}, {1, 1}};
    command.cutting.cuts[0].along = {0, 0, 2};
    refused(command, "two different directions");
    command = across(0);
    command.cutting.cuts[0].opened = {{0, 0, 1}};
    refused(command, "only 0 cuts before it");
    command = across(0);
    command.cutting.cuts.resize(most_cuts + 1);
    refused(command, "at most");
    EXPECT_THAT(
        [&] {
            after(document, RemoveCut{1, 1});
        },
        ThrowsMessage<Rejected>(HasSubstr("is not cut")));
}

} // namespace
} // namespace trivar
