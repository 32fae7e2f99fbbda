// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/objects/animate.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/group.h"
#include "core/commands/objects/keep_shape.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/objects/refine.h"
#include "core/commands/objects/shape.h"
#include "core/commands/paste.h"
#include "core/commands/placement/place.h"
#include "core/commands/volumes/lattice.h"
#include "core/commands/volumes/warp.h"
#include "core/document/document_digest.h"
#include "core/evaluation/evaluate.h"
#include "core/placement/shaper.h"
#include "core/refinement/refine.h"
#include "tests/support/fixtures.h"
#include "tests/support/scenes/commands.h"
#include "tests/support/scenes/drawn_off.h"
#include "tests/support/scenes/world_points.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

// A ball of radius 0.4 (object 1) in a lattice of 1 x 1 x 1 (object 2).
Document ball_in_box(const LatticeShape& shape = {})
{
    Document document = after(Document{}, AddSphere{.shape = {.radius = 0.4}});
    return after(document, AddLattice{.objects = {1}, .shape = shape});
}

Evaluation all_of(const Document& document)
{
    return Evaluator(std::make_shared<const AssetStore>(""))(document);
}

std::vector<glm::vec3> points_of(const Document& document, Id id)
{
    return testing::world_points(all_of(document).objects.at(id)->parts.at(0));
}

// Applies a command as a person gives it, where a step that does nothing is refused.
Document given(const Document& document, const Command& command)
{
    check_new(document, command);
    return after(document, command);
}

MovePoints lift(Id lattice, const glm::ivec3& point, double by)
{
    return {.object = lattice, .shift = {.points = {point}, .by = {0, 0, by}}};
}

TEST(Lattices, AtRestLeaveWhatStandsInThemWhereItIs)
{
    const Document alone = after(Document{}, AddSphere{.shape = {.radius = 0.4}});
    EXPECT_LT(testing::most_apart(points_of(ball_in_box(), 1), points_of(alone, 1)), 1e-7);
}

TEST(Lattices, BendWhatStandsInThemAsTheirVolumeSays)
{
    const Document bent = after(ball_in_box(), lift(2, {1, 1, 3}, 0.2));
    const Ref<Placement> box = all_of(bent).objects.at(2)->placement;
    const std::vector<glm::vec3> rest = points_of(ball_in_box(), 1), now = points_of(bent, 1);
    double most = 0;
    for (std::size_t i = 0; i < rest.size(); ++i) {
        const glm::dvec3 uvw = glm::dvec3(rest[i]) + 0.5;
        most = std::max(most, glm::length(evaluate(box->volume, uvw).value - glm::dvec3(now[i])));
    }
    EXPECT_LT(most, 1e-6);
    EXPECT_GT(testing::most_apart(rest, now), 0.02);
}

TEST(Lattices, MoveWhatIsOutsideWithTheirNearestSide)
{
    Document document =
        after(Document{}, AddBox{.shape = {.size = {2, 2, 2}, .segments = {1, 1, 1}}});
    document = after(document,
                     AddLattice{.objects = {1}, .shape = {.grid = {2, 2, 2}, .orders = {2, 2, 2}}});
    const std::vector<glm::vec3> rest = points_of(document, 1);
    const std::vector<glm::vec3> now = points_of(after(document, lift(2, {1, 1, 1}, 0.25)), 1);
    for (std::size_t i = 0; i < rest.size(); ++i) {
        const bool corner = rest[i].x > 0 && rest[i].y > 0 && rest[i].z > 0;
        EXPECT_NEAR(now[i].z - rest[i].z, corner ? 0.25 : 0, 1e-6);
    }
}

TEST(Lattices, KeepWhatIsMovedInThemWhereTheHandPutIt)
{
    const Document bent = after(ball_in_box(), lift(2, {1, 1, 3}, 0.2));
    const Document moved = after(bent, SetTransform{1, {.translation = {0.1, 0, 0}}});
    const Ref<Placement> box = all_of(moved).objects.at(2)->placement;
    const std::vector<glm::vec3> rest = points_of(ball_in_box(), 1), now = points_of(moved, 1);
    const glm::dvec3 uvw = glm::dvec3(rest[40]) + glm::dvec3(0.6, 0.5, 0.5);
    EXPECT_LT(glm::length(evaluate(box->volume, uvw).value - glm::dvec3(now[40])), 1e-6);
}

TEST(Lattices, GoWithTheirOwnTransform)
{
    const Document bent = after(ball_in_box(), lift(2, {1, 1, 3}, 0.2));
    const Transform there{.translation = {1, 2, 3}, .rotation_deg = {0, 0, 90}, .scale = {2, 2, 2}};
    const std::vector<glm::vec3> here = points_of(bent, 1);
    const std::vector<glm::vec3> now = points_of(after(bent, SetTransform{2, there}), 1);
    std::vector<glm::vec3> expected;
    for (const glm::vec3& p : here) expected.emplace_back(there.matrix() * glm::dvec4(p, 1));
    EXPECT_LT(testing::most_apart(now, expected), 2e-6);
}

TEST(Lattices, BendOneAfterTheOther)
{
    Document document =
        after(after(ball_in_box(), lift(2, {1, 1, 3}, 0.2)),
              AddLattice{.objects = {2}, .name = "Outer", .shape = {.size = {2, 2, 2}}});
    const std::vector<glm::vec3> inner = points_of(document, 1);
    document = after(document, lift(3, {3, 1, 1}, -0.3));
    const Ref<Placement> outer = all_of(document).objects.at(3)->placement;
    const std::vector<glm::vec3> now = points_of(document, 1);
    double most = 0;
    for (std::size_t i = 0; i < inner.size(); ++i) {
        const glm::dvec3 uvw = glm::dvec3(inner[i]) / 2.0 + 0.5;
        most = std::max(most, glm::length(evaluate(outer->volume, uvw).value - glm::dvec3(now[i])));
    }
    EXPECT_LT(most, 1e-6);
}

TEST(Lattices, BendWhatLiesOnAStroke)
{
    Document document = testing::small_document(); // 3, the pot, lies on 1
    const std::vector<glm::vec3> laid = points_of(document, 3);
    document = after(document, AddLattice{.objects = {3}, .shape = {.size = {6, 6, 6}}});
    EXPECT_LT(testing::most_apart(points_of(document, 3), laid), 1e-6);
    document = after(document, lift(document.next_id - 1, {1, 1, 1}, 0.5));
    EXPECT_GT(testing::most_apart(points_of(document, 3), laid), 0.01);
}

TEST(Lattices, GiveBackWhatStandsInThemWhenTheyAreTakenAway)
{
    const Document bent = after(ball_in_box(), lift(2, {1, 1, 3}, 0.2));
    EXPECT_LT(
        testing::most_apart(points_of(after(bent, Ungroup{2}), 1), points_of(ball_in_box(), 1)),
        1e-7);
}

TEST(Lattices, AreRefinedWithoutAChangeOfShape)
{
    const Document bent = after(ball_in_box(), lift(2, {1, 1, 3}, 0.2));
    const Document finer =
        after(bent, InsertKnots{2, {.along = {0.5}, .across = {0.3}, .up = {0.7}}});
    EXPECT_LT(testing::most_apart(points_of(finer, 1), points_of(bent, 1)), 1e-6);
}

TEST(Lattices, AreKeptByTheirGuardFromFolding)
{
    const Document bent = after(ball_in_box(), lift(2, {1, 1, 3}, -5));
    const Ref<EvaluatedObject> box = all_of(bent).objects.at(2);
    EXPECT_TRUE(box->shaped->steps.at(0).would_fold);
    EXPECT_LT(-box->shaped->steps.at(0).done, 5);
}

TEST(Lattices, MoveInTimeWithKeysOnTheirPoints)
{
    Document document = after(ball_in_box(), lift(2, {1, 1, 3}, 0.2));
    document = after(document, Animate{{{2, {{"shaping.0.shift.by.z", {{1, 0}, {25, 0.2}}}}}}});
    Evaluator evaluator(std::make_shared<const AssetStore>(""));
    const auto highest = [&](double frame) {
        return evaluator(document, frame).objects.at(1)->bounds->hi.z;
    };
    EXPECT_NEAR(highest(1), 0.4, 1e-6);
    EXPECT_GT(highest(13), 0.41);
    EXPECT_GT(highest(25), highest(13) + 0.01);
}

TEST(Lattices, AreTwistedAsAWhole)
{
    const Document twisted =
        after(ball_in_box({.grid = {6, 6, 12}}), WarpVolume{2, {.fixed = 0.5, .twist_deg = 90}});
    const Lattice volume = all_of(twisted).objects.at(2)->placement->volume;
    const glm::dvec3 top = evaluate(volume, {1, 0.5, 1}).value,
                     low = evaluate(volume, {1, 0.5, 0}).value;
    EXPECT_LT(glm::length(top - glm::dvec3(0.5 * std::sqrt(0.5), 0.5 * std::sqrt(0.5), 0.5)), 1e-9);
    EXPECT_LT(glm::length(low - glm::dvec3(0.5 * std::sqrt(0.5), -0.5 * std::sqrt(0.5), -0.5)),
              1e-9);
    const Ref<ShapedVolume> shaped = all_of(twisted).objects.at(2)->shaped;
    EXPECT_FALSE(shaped->steps.at(0).would_fold);
    EXPECT_TRUE(shaped->volume->verdicts->good());
}

TEST(Lattices, AreBentAlongAnArcOfTheirOwnLength)
{
    const Document bent =
        after(ball_in_box({.grid = {4, 4, 40}}), WarpVolume{2, {.fixed = 0.5, .bend_deg = 90}});
    const Lattice volume = all_of(bent).objects.at(2)->placement->volume;
    const double radius = 2 / 3.14159265358979;
    for (int i = 0; i <= 20; ++i) {
        const double t = i / 20.0, angle = (t - 0.5) * 3.14159265358979 / 2;
        const glm::dvec3 arc(radius - radius * std::cos(angle), 0, radius * std::sin(angle));
        EXPECT_LT(glm::length(evaluate(volume, {0.5, 0.5, t}).value - arc), 2e-3);
    }
}

TEST(Lattices, StandStillWhereABendAndATwistHaveTheirFixedEnd)
{
    for (const double fixed : {0.0, 1.0}) {
        const Document bent =
            after(ball_in_box({.grid = {4, 4, 12}}),
                  WarpVolume{2, {.fixed = fixed, .twist_deg = 30, .bend_deg = 60}});
        const Lattice volume = all_of(bent).objects.at(2)->placement->volume;
        for (const glm::dvec2 at : {glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0.3, 1)}) {
            const glm::dvec3 uvw(at, fixed);
            EXPECT_LT(glm::length(evaluate(volume, uvw).value - (uvw - 0.5)), 1e-9);
        }
    }
}

TEST(Lattices, AreBentNoFurtherThanIsProvenNotToFold)
{
    const Document bent = after(ball_in_box({.grid = {4, 4, 8}}), WarpVolume{2, {.taper = -1}});
    const Ref<ShapedVolume> shaped = all_of(bent).objects.at(2)->shaped;
    EXPECT_TRUE(shaped->steps.at(0).would_fold);
    EXPECT_TRUE(shaped->volume->verdicts->good());
}

TEST(Lattices, LetWhatStandsInThemBeRefinedWithACertificate)
{
    Document document = after(ball_in_box(), lift(2, {1, 1, 3}, 0.3));
    const std::size_t before = all_of(document).objects.at(1)->parts.at(0).rest->face_count();
    document = after(document, Refine{{1}, {.tolerance = 1e-3}});
    const Ref<EvaluatedObject> ball = all_of(document).objects.at(1);
    ASSERT_TRUE(ball->refined);
    EXPECT_LE(ball->refined->bound, 1e-3);
    EXPECT_TRUE(ball->notices.empty());
    EXPECT_GT(ball->parts.at(0).rest->face_count(), before);
}

TEST(Lattices, LetWhatTwoOfThemBendBeRefinedWithACertificate)
{
    Document document = after(ball_in_box(), lift(2, {1, 1, 3}, 0.3));
    document = after(document, AddLattice{.objects = {2}, .shape = {.size = {2, 2, 2}}});
    document = after(document, lift(3, {2, 1, 1}, -0.4));
    document = after(document, Refine{{1}, {.tolerance = 1e-3}});
    const Ref<EvaluatedObject> ball = all_of(document).objects.at(1);
    ASSERT_TRUE(ball->refined);
    EXPECT_LE(ball->refined->bound, 1e-3);
    EXPECT_TRUE(ball->notices.empty());
    EXPECT_LE(testing::drawn_off(ball->parts.at(0)), ball->refined->bound);
}

TEST(Lattices, AreWantedWhereWhatLiesOnNoStrokeIsToBeRefined)
{
    const Document document = after(Document{}, AddSphere{});
    EXPECT_THAT(
        [&] {
            after(document, Refine{{1}, {}});
        },
        ThrowsMessage<Rejected>(HasSubstr("neither placed")));
}

TEST(Lattices, ComeWithTheirStepsWhenTheyAreCopied)
{
    const Document bent = after(ball_in_box(), lift(2, {1, 1, 3}, 0.2));
    const Document pasted = after(bent, copied(bent, {2}, "/"));
    EXPECT_LT(testing::most_apart(points_of(pasted, 4), points_of(bent, 1)), 1e-7);
}

TEST(Lattices, AreEditedProportionallyTurnedAndScaledInOneStepEach)
{
    const MovePoints turn{2,
                          {.points = {{1, 1, 3}, {2, 2, 3}, {1, 2, 3}},
                           .weights = {1, 1, 0.5},
                           .rotation_deg = {0, 0, 30}}};
    const Document turned = after(ball_in_box(), turn);
    EXPECT_EQ(object(turned, 2).shaping.size(), 1u);
    EXPECT_GT(testing::most_apart(points_of(turned, 1), points_of(ball_in_box(), 1)), 0.005);
    EXPECT_EQ(command_from_json_line(to_json_line(turn)), Command(turn));
    EXPECT_NE(digest(turned),
              digest(after(ball_in_box(), MovePoints{2, {.points = turn.shift.points}})));
}

TEST(Lattices, RefuseWhatCannotBeInASentence)
{
    const auto refused = [](const Command& command, const char* why) {
        EXPECT_THAT([&] { given(ball_in_box(), command); },
                    ThrowsMessage<Rejected>(HasSubstr(why)));
    };
    refused(AddLattice{.objects = {}}, "no object");
    refused(AddLattice{.objects = {7}}, "no object 7");
    refused(AddLattice{.objects = {1}, .shape = {.orders = {4, 7, 4}}}, "between 2 and 6");
    refused(AddLattice{.objects = {1}, .shape = {.grid = {1024, 1024, 10}}}, "10,485,760 control");
    refused(Place{2, testing::small_sketch(), {}, {1}}, "is in object 2 (Lattice) already");
    refused(AddLattice{.objects = {1}, .shape = {.grid = {3, 4, 4}}}, "order 4 needs at least 4");
    refused(AddLattice{.objects = {1}, .shape = {.grid = {1, 4, 4}}}, "between 2 and 1,024");
    refused(AddLattice{.objects = {1}, .shape = {.grid = {300, 300, 300}}},
            "27,000,000 control points");
    refused(AddLattice{.objects = {1}, .shape = {.size = {1, 1, 0}}}, "above 0");
    refused(SetLattice{.object = 1}, "is not a lattice");
    refused(Reorder{.objects = {2}, .parent = 2}, "cannot be in itself");
    refused(WarpVolume{1, {.twist_deg = 5}}, "is not a lattice");
    refused(SetMaterial{{2}, {}}, "group");
    ImportedFile file;
    file.path = "kept.glb";
    refused(KeepShape{1, {1}, {file}}, "is not a lattice");
    refused(KeepShape{2, {1}, {}}, "0 files for 1 members");
    refused(KeepShape{2, {2}, {file}}, "is not in object 2");
    refused(MovePoints{2, {.points = {{0, 0, 0}}, .weights = {1, 1}}}, "2 numbers for 1 points");
    refused(MovePoints{2, {.points = {{0, 4, 0}}}}, "names 0, 4, 0, but Lattice has 4 x 4 x 4");
    refused(CoarsenVolume{2, {VolumeAxis::up, 4}}, "4 control points along Z; give fewer");
    refused(CoarsenVolume{2, {VolumeAxis::up, 3}}, "order 4 needs at least 4 control points");
    refused(InsertKnots{2, {.up = std::vector<double>(62497, 0.5)}}, "1,000,016 control points");
    refused(SetWarp{2, 1, {.twist_deg = 5}}, "step 1 of object 2 (Lattice) is not a warp");
    refused(SetWarp{1, 1, {.twist_deg = 5}}, "is not a lattice");
}

TEST(Lattices, PassOverStepsOfOlderScenesThatTheyCannotTake)
{
    const Document sound = after(ball_in_box(), lift(2, {1, 1, 3}, 0.05));
    for (const Command& step : {Command(MovePoints{2, {.points = {{0, 4, 0}}, .by = {0, 0, 0.1}}}),
                                Command(CoarsenVolume{2, {VolumeAxis::up, 4}}),
                                Command(CoarsenVolume{2, {VolumeAxis::up, 3}}),
                                Command(InsertKnots{2, {.up = std::vector<double>(62497, 0.5)}})}) {
        EXPECT_THROW(given(sound, step), Rejected);
        const Document older = after(sound, step);
        EXPECT_EQ(object(older, 2).shaping.size(), 2u);
        EXPECT_EQ(points_of(older, 1), points_of(sound, 1));
        EXPECT_THAT(all_of(older).objects.at(2)->notices,
                    ::testing::Contains(HasSubstr("step 2 of its shaping")));
        // A step that was passed over counts no more: others fit without it.
        EXPECT_NO_THROW(given(older, InsertKnots{2, {.up = {0.5}}}));
        EXPECT_THROW(given(older, MovePoints{2, {.points = {{0, 0, 4}}}}), Rejected);
    }
}

TEST(Lattices, KnowHowManyPointsTheirStepsHaveLeftThem)
{
    Document document = after(ball_in_box(), InsertKnots{2, {.up = {0.25, 0.5}}});
    document = after(document, MovePoints{2, {.points = {{0, 0, 5}}, .by = {0, 0, 0.1}}});
    document = after(document, CoarsenVolume{2, {VolumeAxis::up, 5}});
    const glm::ivec3 gone(0, 0, 5);
    EXPECT_THROW(given(document, MovePoints{2, {.points = {gone}}}), Rejected);
    EXPECT_THROW(given(document, CoarsenVolume{2, {VolumeAxis::up, 5}}), Rejected);
    EXPECT_EQ(all_of(document).objects.at(2)->placement->volume.displacement.axes[2].count(), 5);
}

TEST(Lattices, LetTheNumbersOfAnEarlierWarpBeChanged)
{
    Document document = after(ball_in_box(), WarpVolume{2, {.fixed = 0.5, .twist_deg = 30}});
    document = after(document, lift(2, {1, 1, 3}, 0.05));
    const Document changed = after(document, SetWarp{2, 1, {.fixed = 0.5, .twist_deg = 60}});
    const Document at_once =
        after(after(ball_in_box(), WarpVolume{2, {.fixed = 0.5, .twist_deg = 60}}),
              lift(2, {1, 1, 3}, 0.05));
    EXPECT_EQ(digest(changed), digest(at_once));
    EXPECT_THROW(after(document, SetWarp{2, 2, {}}), Rejected);
    EXPECT_THROW(after(document, SetWarp{2, 3, {}}), Rejected);
}

TEST(Lattices, TakeTheRowOfTheFirstOfTheirMembersWhereThatIsWanted)
{
    Document document = after(Document{}, AddSphere{});
    for (int i = 0; i < 3; ++i) document = after(document, AddBox{});
    const AddLattice last{.objects = {3, 2}};
    EXPECT_EQ(in_row_order(after(document, last)), (std::vector<Id>{1, 2, 3, 4, 5}));
    AddLattice in_place = last;
    in_place.in_place = true;
    EXPECT_EQ(in_row_order(after(document, in_place)), (std::vector<Id>{1, 5, 2, 3, 4}));
}

TEST(Lattices, CannotBeRoundAGroupThatHoldsThem)
{
    Document document = after(ball_in_box(), Group{.objects = {2}}); // 3
    EXPECT_THAT([&] { after(document, Reorder{.objects = {3}, .parent = 2}); },
                ThrowsMessage<Rejected>(HasSubstr("cannot be in object 2 (Lattice), which is in")));
}

TEST(Lattices, AreNoWayRoundForStrokesThatWouldLieOnEachOther)
{
    Document document = testing::small_document(); // 3, the pot, lies on 1 and 2
    document = after(document, AddLattice{.objects = {1, 3}, .shape = {.size = {6, 6, 6}}});
    EXPECT_THAT(
        [&] {
            after(document, Place{1, testing::small_sketch(), {}, {3}});
        },
        ThrowsMessage<Rejected>(HasSubstr("so the other way round is impossible")));
    EXPECT_EQ(all_of(document).objects.at(3)->rejected, "");
}

TEST(Lattices, BendWhatIsFlat)
{
    Document document =
        after(Document{}, AddPlane{.shape = {.size = {0.8, 0.8}, .segments = {4, 4}}});
    document = after(document, AddLattice{.objects = {1}, .shape = {.size = {1, 1, 0.05}}});
    const std::vector<glm::vec3> flat = points_of(document, 1);
    EXPECT_GT(testing::most_apart(points_of(after(document, lift(2, {1, 1, 1}, 0.3)), 1), flat),
              0.01);
}

TEST(Lattices, SayAlongWhichAxisTheyAreTooFlatToBend)
{
    const auto notices = [](const glm::dvec3& size) {
        const Document document = after(after(Document{}, AddPlane{}),
                                        AddLattice{.objects = {1}, .shape = {.size = size}});
        return testing::new_evaluator()(document, 1).objects.at(2)->notices;
    };
    EXPECT_THAT(notices({2, 2, 1e-9}), ::testing::Contains(::testing::HasSubstr("flat along Z")));
    EXPECT_TRUE(notices({2, 2, 0.05}).empty());
}

} // namespace
} // namespace trivar
