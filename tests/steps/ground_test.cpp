// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/placement/place.h"
#include "core/placement/placement.h"
#include "core/steps/laying/ground_plane.h"

#include "core/base/rejected.h"
#include "core/commands/command.h"
#include "core/document/document_digest.h"
#include "core/steps/laying/attaching.h"
#include "tests/support/scenes/commands.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr;
using testing::new_evaluator, testing::small_sketch;

constexpr double on_it = 1e-9; // metres

const Placement& laid(const Evaluation& evaluated, Id id)
{
    const EvaluatedObject& object = *evaluated.objects.at(id);
    EXPECT_EQ(object.rejected, "");
    return *object.stroke_placement();
}

Place on_ground(Id id)
{
    return {.object = id, .sketch = small_sketch(), .parameters = {.on_ground = true}, .onto = {}};
}

Document pot_alone()
{
    return after({}, AddTeapot{.name = "Pot", .shape = {.height = 0.2, .resolution = 4}});
}

// A pot on a stroke from the ground over a low box that stands in the middle of it.
Document pot_over_box()
{
    const AddBox box{.name = "Box",
                     .shape = {.size = {0.5, 4, 0.1}},
                     .transform = {.translation = {0, 0, 0.05}}};
    return after(after(pot_alone(), box), on_ground(1));
}

TEST(Ground, IsMetByRaysThatComeDownFromAboveIt)
{
    EXPECT_EQ(distance_to_ground({{1, 2, 3}, {0, 0, -1}}), 3);
    EXPECT_NEAR(*distance_to_ground({{0, 0, 3}, {0, 0.8, -0.6}}), 5, 1e-12);
    EXPECT_FALSE(distance_to_ground({{1, 2, 3}, {0, 1, 0}}));
    EXPECT_FALSE(distance_to_ground({{1, 2, 3}, {0, 0, 1}}));
    EXPECT_FALSE(distance_to_ground({{1, 2, -3}, {0, 0, 1}})); // it has one side
}

TEST(Ground, CarriesWhatLiesOnNothingElse)
{
    const Document document = after(pot_alone(), on_ground(1));
    EXPECT_TRUE(object(document, 1).stroke->onto.empty());
    const Evaluation evaluated = new_evaluator()(document);
    const Placement& placement = laid(evaluated, 1);
    EXPECT_EQ(placement.report.missed_share, 0);
    EXPECT_EQ(placement.report.contact_share, 1);
    for (const StripNode& node : placement.nodes) {
        EXPECT_EQ(node.contact, Contact::touches);
        EXPECT_NEAR(node.p_world.z, 0, on_it);
    }
    EXPECT_FALSE(attachment_of(*evaluated.objects.at(1), small_sketch(), false));
}

TEST(Ground, IsPassedOverByAStrokeThatDoesNotSaySo)
{
    Place passing = on_ground(1);
    passing.parameters.on_ground = false;
    try {
        after(pot_alone(), passing);
        ADD_FAILURE() << "it lies on nothing";
    } catch (const Rejected& error) {
        EXPECT_THAT(error.what(),
                    HasSubstr("there is nothing visible that object 1 (Pot) could lie on"));
    }
    passing.onto = {2};
    const Evaluation evaluated = new_evaluator()(after(pot_over_box(), passing));
    EXPECT_THAT(evaluated.objects.at(1)->rejected,
                HasSubstr("of the model would have no surface beneath it"));
}

TEST(Ground, LiesUnderTheObjectsThatStandOnIt)
{
    const Document document =
        after(pot_over_box(), EditPlacement{1, {.springs = false, .on_ground = true}, {}, {}});
    const Evaluation evaluated = new_evaluator()(document);
    double lowest = 1e300, highest = -1e300;
    for (const StripNode& node : laid(evaluated, 1).nodes) {
        lowest = std::min(lowest, node.p_world.z);
        highest = std::max(highest, node.p_world.z);
    }
    EXPECT_NEAR(lowest, 0, on_it);
    EXPECT_GE(highest, 0.1 - 1e-7); // single precision of the box
    EXPECT_LT(highest, 0.2);        // it is rounded where it steps up
    EXPECT_EQ(laid(evaluated, 1).report.missed_share, 0);
}

TEST(Ground, StaysWhereItIsWhenAStrokeGoesWithItsHost)
{
    Document document = pot_over_box();
    const Evaluation before = new_evaluator()(document);
    const auto attachment = attachment_of(*before.objects.at(1), small_sketch(), false);
    ASSERT_TRUE(attachment);
    ASSERT_EQ(attachment->hosts.size(), 1u);
    EXPECT_EQ(attachment->hosts[0].object, 2);
    document = after(document, Attach{1, attachment});
    document =
        after(document, SetTransform{.object = 2, .transform = {.translation = {0.3, 0.2, 0.25}}});
    const Evaluation now = new_evaluator()(document);
    double lowest = 1e300;
    for (const StripNode& node : laid(now, 1).nodes) lowest = std::min(lowest, node.p_world.z);
    EXPECT_NEAR(lowest, 0, on_it);
}

TEST(Ground, AloneKeepsWhatLiesOnItWhateverIsMovedUnderTheStroke)
{
    const AddBox beside{.name = "Box",
                        .shape = {.size = {0.5, 4, 0.1}},
                        .transform = {.translation = {0, 50, 0.05}}};
    Place place = on_ground(1);
    place.onto = {2};
    Document document = after(after(pot_alone(), beside), place);
    const Evaluation before = new_evaluator()(document);
    const auto attachment = attachment_of(*before.objects.at(1), small_sketch(), false);
    ASSERT_TRUE(attachment);
    EXPECT_FALSE(attachment->hosts.at(0).touched);
    document = after(document, Attach{1, attachment});
    document =
        after(document, SetTransform{.object = 2, .transform = {.translation = {0, 0, 0.05}}});
    const Evaluation now = new_evaluator()(document);
    for (const StripNode& node : laid(now, 1).nodes) EXPECT_NEAR(node.p_world.z, 0, on_it);
    EXPECT_EQ(laid(now, 1).volume.displacement.points, laid(before, 1).volume.displacement.points);
}

TEST(Ground, CannotBeTakenFromUnderWhatLiesOnItAlone)
{
    const Document document = after(pot_alone(), on_ground(1));
    EXPECT_THROW(after(document, EditPlacement{1, {}, {}, {}}), Rejected);
    EXPECT_NO_THROW(after(pot_over_box(), EditPlacement{1, {}, {}, {}}));
}

} // namespace
} // namespace trivar
