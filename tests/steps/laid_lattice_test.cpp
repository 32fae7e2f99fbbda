// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/objects/animate.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/group.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/objects/refine.h"
#include "core/commands/objects/shape.h"
#include "core/commands/paste.h"
#include "core/commands/placement/place.h"
#include "core/commands/placement/travel.h"
#include "core/commands/volumes/lattice.h"
#include "core/commands/volumes/warp.h"
#include "core/document/document_digest.h"
#include "core/evaluation/evaluate.h"
#include "core/placement/placement.h"
#include "core/refinement/refine.h"
#include "core/steps/laying/attaching.h"
#include "tests/support/fixtures.h"
#include "tests/support/scenes/commands.h"
#include "tests/support/scenes/drawn_off.h"
#include "tests/support/scenes/world_points.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

constexpr Id ground_id = 1, box_id = 2, lattice_id = 3;

// A box of 1 x 1 x 1 in a lattice of its size, over a plain ground.
Document box_in_lattice()
{
    Document document = after(Document{}, AddPlane{.shape = {.size = {8, 8}}});
    document = after(document, AddBox{.shape = {.size = {1, 1, 1}, .segments = {6, 6, 6}}});
    return after(document, AddLattice{.objects = {box_id}, .shape = {.orders = {3, 3, 3}}});
}

Place along_a_stroke(Id object)
{
    Place out{object, testing::small_sketch(), {}, {ground_id}};
    out.parameters.grid = {12, 4, 3};
    out.parameters.offset = 1;
    return out;
}

Document laid()
{
    return after(box_in_lattice(), along_a_stroke(lattice_id));
}

Evaluation shown_scene(const Document& document)
{
    return Evaluator(std::make_shared<const AssetStore>(""))(document);
}

std::vector<glm::vec3> world_points(const Document& document, Id id = box_id)
{
    return testing::world_points(shown_scene(document).objects.at(id)->parts.at(0));
}

MovePoints lift_roof(double by)
{
    MovePoints out{.object = lattice_id, .shift = {.points = {}, .by = {0, 0, by}}};
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) out.shift.points.push_back({i, j, 3});
    return out;
}

TEST(LaidLattices, LayWhatFillsThemAsItWouldLieAlone)
{
    Document document = after(Document{}, AddPlane{.shape = {.size = {8, 8}}});
    document = after(document, AddBox{.shape = {.size = {1, 1, 1}, .segments = {6, 6, 6}}});
    EXPECT_LT(testing::most_apart(world_points(after(document, along_a_stroke(box_id))),
                                  world_points(laid())),
              1e-5);
    EXPECT_EQ(shown_scene(laid()).objects.at(lattice_id)->rejected, "");
}

TEST(LaidLattices, BendTheirContentsByTheBoxFirstAndThenByTheStroke)
{
    const Document document = after(laid(), lift_roof(-0.3));
    const Evaluation all = shown_scene(document);
    const EvaluatedObject& round = *all.objects.at(lattice_id);
    ASSERT_TRUE(round.lattice_stroke);
    const Part part = all.objects.at(box_id)->parts.at(0);
    const Ref<Mesh>& at_rest = innermost(part).rest;
    const Ref<Mesh> drawn = part.mesh();
    for (std::size_t v = 0; v < drawn->positions.size(); ++v) {
        const glm::dvec3 uvw = glm::dvec3(at_rest->positions[v]) + 0.5;
        const glm::dvec3 inner = evaluate(round.placement->volume, uvw).value;
        const glm::dvec3 outer =
            evaluate(round.lattice_stroke->placement->volume,
                     glm::dvec3(round.lattice_stroke->embedding.to_uvw * glm::dvec4(inner, 1)))
                .value;
        ASSERT_LT(glm::distance(outer, glm::dvec3(drawn->positions[v])), 1e-5);
    }
}

TEST(LaidLattices, LetTheirContentsRiseAboveTheVolumeOfTheStroke)
{
    const std::vector<glm::vec3> before = world_points(laid());
    const double height =
        shown_scene(laid()).objects.at(lattice_id)->lattice_stroke->placement->report.height_world;
    for (const double by : {0.25, 1.0}) {
        const std::vector<glm::vec3> now = world_points(after(laid(), lift_roof(by)));
        EXPECT_NEAR(testing::most_apart(now, before), by * height, 0.02 * by * height);
    }
}

TEST(LaidLattices, LetTheirContentsBeRefinedWithACertificate)
{
    Document document = after(laid(), WarpVolume{lattice_id, {.twist_deg = 60}});
    document = after(document, Refine{{box_id}, {.tolerance = 5e-3}});
    const Ref<EvaluatedObject> refined = shown_scene(document).objects.at(box_id);
    ASSERT_TRUE(refined->refined);
    EXPECT_LE(refined->refined->bound, 5e-3);
    EXPECT_LE(testing::drawn_off(refined->parts.at(0)), refined->refined->bound);
    EXPECT_GT(refined->parts.at(0).mesh()->face_count(), 6u * 36u);
}

TEST(LaidLattices, StandInOtherLatticesThatBendAllOfIt)
{
    Document document =
        after(laid(), AddLattice{.objects = {lattice_id}, .shape = {.size = {9, 9, 9}}});
    EXPECT_LT(testing::most_apart(world_points(document), world_points(laid())), 1e-5);
    document = after(document, MovePoints{4, {.points = {{1, 1, 1}, {2, 2, 2}}, .by = {0, 0, 1}}});
    EXPECT_GT(testing::most_apart(world_points(document), world_points(laid())), 0.05);
}

TEST(LaidLattices, GoWithWhatTheyAreAttachedTo)
{
    Document document = laid();
    document = after(document,
                     Attach{lattice_id, attachment_of(*shown_scene(document).objects.at(lattice_id),
                                                      testing::small_sketch(), false)});
    const std::vector<glm::vec3> before = world_points(document);
    const Transform there{.translation = {1, 2, 3}, .rotation_deg = {10, 20, 30}};
    document = after(document, SetTransform{ground_id, there});
    std::vector<glm::vec3> expected;
    for (const glm::vec3& p : before) expected.emplace_back(there.matrix() * glm::dvec4(p, 1));
    EXPECT_LT(testing::most_apart(world_points(document), expected), 2e-5);
}

TEST(LaidLattices, KeepWhatWasDoneToTheirBox)
{
    const Document pressed = after(box_in_lattice(), lift_roof(0.2));
    const Document up = after(pressed, along_a_stroke(lattice_id));
    EXPECT_EQ(object(up, lattice_id).shaping, object(pressed, lattice_id).shaping);
    const Document down = after(up, Unplace{lattice_id});
    EXPECT_LT(testing::most_apart(world_points(down), world_points(pressed)), 1e-7);
}

TEST(LaidLattices, MoveAlongTheirStrokeWithKeysOnItsStart)
{
    Place place = along_a_stroke(lattice_id);
    place.parameters.fill = 0.4;
    Document document = after(box_in_lattice(), place);
    document =
        after(document, Animate{{{lattice_id, {Track{"placement.start", {{1, 0.0}, {25, 0.6}}}}}}});
    const std::shared_ptr<const AssetStore> assets = std::make_shared<const AssetStore>("");
    const auto middle = [&](double frame) {
        const Part part = Evaluator(assets)(document, frame).objects.at(box_id)->parts.at(0);
        return bounding_box(*part.mesh()).center();
    };
    EXPECT_GT(glm::distance(middle(1), middle(25)), 0.5);
}

TEST(LaidLattices, AreCopiedWithStrokeAndSteps)
{
    const Document document = after(laid(), lift_roof(0.2));
    const Document twice = after(document, Duplicate{.objects = {lattice_id}});
    const Id copy = 4, contents = 5;
    ASSERT_TRUE(is_lattice(twice, copy));
    EXPECT_LT(testing::most_apart(world_points(twice, contents), world_points(document)), 1e-7);
    const Document pasted = after(document, copied(document, {lattice_id}, ""));
    EXPECT_LT(testing::most_apart(world_points(pasted, contents), world_points(document)), 1e-7);
}

TEST(LaidLattices, RefuseRingsAndWhatTheyCannot)
{
    const auto refused = [](const Command& command, const char* why) {
        EXPECT_THAT([&] { after(laid(), command); }, ThrowsMessage<Rejected>(HasSubstr(why)));
    };
    refused(Place{lattice_id, testing::small_sketch(), {}, {box_id}}, "is in object 3 (Lattice)");
    refused(Reorder{.objects = {ground_id}, .parent = lattice_id}, "which lies on it");
    refused(SetParent{.objects = {ground_id}, .parent = lattice_id}, "which lies on it");
    refused(SetTravel{{lattice_id}, {.speed = 1}}, "does not travel");
    refused(Place{box_id, testing::small_sketch(), {}, {box_id}}, "cannot lie on itself");
}

TEST(LaidLattices, StandWhereTheyAreWhereTheStrokeFindsNothing)
{
    const Document document = after(laid(), SetTransform{ground_id, {.translation = {0, 0, -500}}});
    const Ref<EvaluatedObject> round = shown_scene(document).objects.at(lattice_id);
    if (!round->rejected.empty()) {
        EXPECT_FALSE(round->lattice_stroke);
        EXPECT_LT(testing::most_apart(world_points(document), world_points(box_in_lattice())),
                  1e-6);
    }
    const Document gone = after(laid(), Delete{{ground_id}});
    EXPECT_THAT(shown_scene(gone).objects.at(lattice_id)->rejected, HasSubstr("is gone"));
    EXPECT_LT(testing::most_apart(world_points(gone), world_points(box_in_lattice())), 1e-6);
}

} // namespace
} // namespace trivar
