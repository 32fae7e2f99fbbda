// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/group.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/placement/place.h"
#include "core/document/document_digest.h"
#include "core/evaluation/evaluate.h"

#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/commands/command.h"
#include "core/mesh/primitives.h"
#include "core/steps/lacking.h"
#include "tests/support/scenes/commands.h"

#include <gmock/gmock.h>
#include <limits>

namespace trivar {
namespace {

using ::testing::ElementsAre, ::testing::HasSubstr, ::testing::IsEmpty;
using testing::new_evaluator, testing::small_document, testing::small_sketch;

bool has_stage(const Evaluation& evaluated, const std::string& name)
{
    for (const Timings::Stage& stage : evaluated.timings.stages)
        if (stage.name == name) return true;
    return false;
}

// The teapot lies on table and ball; another lies on the teapot.
Document stacked_document()
{
    AddTorus ring;
    ring.shape = {.radius = 0.1, .tube = 0.03, .segments = {24, 12}};
    Sketch sketch = small_sketch();
    for (StrokeSample& sample : sketch.samples) sample.p_px.x = 540 + (sample.p_px.x - 440) / 2;
    return after(after(small_document(), ring), Place{5, sketch, {}, {3}});
}

TEST(Evaluator, LaysWhatIsPlacedIntoTheWorldAndLeavesTheRestWhereItIs)
{
    Evaluator evaluate = new_evaluator();
    const Evaluation result = evaluate(small_document());
    ASSERT_EQ(result.objects.size(), 3u); // a group is nothing to see
    const EvaluatedObject& pot = *result.objects.at(3);
    ASSERT_THAT(pot.rejected, IsEmpty());
    ASSERT_TRUE(pot.placement);
    EXPECT_EQ(pot.parts.front().to_world, glm::dmat4(1));
    EXPECT_GT(pot.bounds->hi.z, 0.2); // on the table, whose top is at 0.25
    EXPECT_EQ(result.objects.at(2)->parts.front().to_world, glm::dmat4(1));
    EXPECT_NEAR(result.objects.at(1)->bounds->hi.z, 0.25, 1e-6);
}

TEST(Evaluator, KeepsThePointersOfWhatDidNotChange)
{
    Evaluator evaluate = new_evaluator();
    const Document document = small_document();
    const Evaluation first = evaluate(document);
    EXPECT_EQ(evaluate(document).objects, first.objects);
    const Evaluation renamed = evaluate(after(document, Rename{3, "Kettle"}));
    EXPECT_EQ(renamed.objects, first.objects);
    const Evaluation painted = evaluate(after(document, SetMaterial{{3}, {}}));
    EXPECT_EQ(painted.objects.at(1), first.objects.at(1));
    EXPECT_NE(painted.objects.at(3), first.objects.at(3));
    EXPECT_EQ(painted.objects.at(3)->parts, first.objects.at(3)->parts);
    EXPECT_TRUE(painted.timings.stages.empty());
}

TEST(Evaluator, FindsTheResultOfTheStepBeforeOnUndo)
{
    Evaluator evaluate = new_evaluator();
    const Document before = small_document();
    const Evaluation first = evaluate(before);
    evaluate(after(before, SetTransform{1, {.translation = {0, 0, 0.1}}}));
    const Evaluation again = evaluate(before);
    EXPECT_EQ(again.objects, first.objects);
    EXPECT_TRUE(again.timings.stages.empty());
}

TEST(Evaluator, LaysTheUpperOneAgainWhenTheLowerOneChanges)
{
    Evaluator evaluate = new_evaluator();
    const Document document = stacked_document();
    const Evaluation first = evaluate(document);
    ASSERT_THAT(first.objects.at(5)->rejected, IsEmpty());
    PlacementParameters flatter = object(document, 3).stroke->parameters;
    flatter.height = 0.4;
    const Evaluation result = evaluate(after(document, EditPlacement{3, flatter, {}, {}}));
    ASSERT_THAT(result.objects.at(5)->rejected, IsEmpty());
    EXPECT_LT(result.objects.at(5)->bounds->hi.z, first.objects.at(5)->bounds->hi.z - 0.05);
    EXPECT_EQ(result.objects.at(2), first.objects.at(2));
}

TEST(Evaluator, DoesNotTouchWhatLiesBelowWhenTheUpperOneChanges)
{
    Evaluator evaluate = new_evaluator();
    const Document document = stacked_document();
    const Evaluation first = evaluate(document);
    PlacementParameters other = object(document, 5).stroke->parameters;
    other.height = 0.3;
    const Evaluation result = evaluate(after(document, EditPlacement{5, other, {}, {}}));
    EXPECT_EQ(result.objects.at(3), first.objects.at(3));
    EXPECT_NE(result.objects.at(5), first.objects.at(5));
    EXPECT_TRUE(has_stage(result, "volume"));
    EXPECT_FALSE(has_stage(result, "import"));
    EXPECT_FALSE(has_stage(result, "deform"));
}

TEST(Evaluator, DeformsWhatOthersLieOnAndTheRestWhenItIsAskedFor)
{
    Evaluator evaluate = new_evaluator();
    Evaluation result = evaluate(stacked_document());
    const auto is_deformed = [&](Id id) {
        return result.objects.at(id)->parts.front().bent->mesh.ready();
    };
    EXPECT_TRUE(is_deformed(3));
    EXPECT_FALSE(is_deformed(5));
    const Box box = *result.objects.at(5)->bounds;
    EXPECT_TRUE(is_deformed(5));
    EXPECT_FALSE(box.empty());

    result = new_evaluator()(stacked_document());
    EXPECT_FALSE(is_deformed(5));
    result.timings = {};
    deform_parts(result);
    EXPECT_TRUE(is_deformed(5));
    EXPECT_TRUE(has_stage(result, "deform"));
    EXPECT_EQ(result.objects.at(5)->bounds->lo, box.lo);
}

TEST(Evaluator, HidesTheTableWithoutDroppingThePot)
{
    Evaluator evaluate = new_evaluator();
    const Document document = small_document();
    const Evaluation first = evaluate(document);
    const Evaluation result = evaluate(after(document, Hide{{4}}));
    EXPECT_FALSE(result.objects.contains(1));
    EXPECT_EQ(result.objects.at(3), first.objects.at(3));
    Evaluator fresh = new_evaluator();
    EXPECT_EQ(fresh(after(document, Hide{{4}})).objects.at(3)->bounds->hi,
              first.objects.at(3)->bounds->hi);
}

TEST(Evaluator, SaysWhenAStrokeGivesNothingAndStandsTheObjectStraight)
{
    Evaluator evaluate = new_evaluator();
    Sketch sky = small_sketch();
    for (StrokeSample& sample : sky.samples) sample.p_px.y = 5;
    const Evaluation missed =
        evaluate(after(small_document(), EditPlacement{3, {}, sky, std::nullopt}));
    EXPECT_FALSE(missed.objects.at(3)->rejected.empty());
    EXPECT_FALSE(missed.objects.at(3)->placement);
    EXPECT_FALSE(missed.objects.at(3)->parts.empty());
    const Evaluation alone = evaluate(after(small_document(), Delete{{2, 4}}));
    EXPECT_THAT(alone.objects.at(3)->rejected, HasSubstr("is gone"));
}

TEST(Evaluator, GivesTheSameBitsForAnyNumberOfThreadsAndAnyWayThere)
{
    const Document document = stacked_document();
    Evaluator evaluate = new_evaluator();
    evaluate(small_document());
    evaluate(after(document, Hide{{2}}));
    const std::string expected = digest(evaluate(document));
    for (const int threads : {1, 2, 4}) {
        const ThreadLimit limit(threads);
        Evaluator fresh = new_evaluator();
        EXPECT_EQ(digest(fresh(document)), expected) << threads;
    }
}

TEST(Evaluator, ScalesAndMirrorsBeforeItLaysDown)
{
    Evaluator evaluate = new_evaluator();
    const Document document = small_document();
    const Evaluation mirrored = evaluate(after(document, SetTransform{3, {.scale = {1, -1, 1}}}));
    const EvaluatedObject& pot = *mirrored.objects.at(3);
    ASSERT_THAT(pot.rejected, IsEmpty());
    // Still turned inside in: the faces' volume is positive.
    const Mesh& mesh = *pot.parts.front().mesh();
    double volume = 0;
    const glm::dvec3 middle = pot.bounds->center();
    for (const glm::uvec3& t : triangles(mesh))
        volume += glm::dot(glm::dvec3(mesh.positions[t.x]) - middle,
                           glm::cross(glm::dvec3(mesh.positions[t.y]) - middle,
                                      glm::dvec3(mesh.positions[t.z]) - middle));
    EXPECT_GT(volume, 0);
}

// For models whose length is not their x axis: half a turn brings the spout where the handle was.
TEST(Evaluator, TurnsAModelBeforeItLaysItDown)
{
    Evaluator evaluate = new_evaluator();
    const Document document = small_document();
    const Evaluation first = evaluate(document);
    const auto& straight = first.objects.at(3)->parts.front().mesh()->positions;
    Transform half = object(document, 3).transform;
    half.rotation_deg.z += 180;
    const Evaluation second = evaluate(after(document, SetTransform{3, half}));
    const auto& turned = second.objects.at(3)->parts.front().mesh()->positions;
    ASSERT_EQ(turned.size(), straight.size());
    EXPECT_NE(turned, straight);
    EXPECT_GT(second.objects.at(3)->bounds->hi.z, 0.2); // still on the table
}

TEST(Evaluator, CoversAnObjectWithOnePlainMaterial)
{
    Evaluator evaluate = new_evaluator();
    const Surfacing red{{1, 0, 0, 0.5f}, 1, 0.2f};
    const Evaluation result = evaluate(after(small_document(), SetMaterial{{2}, red}));
    for (const Material& material : *result.objects.at(2)->materials) {
        EXPECT_EQ(material.base_color, red.base_color);
        EXPECT_EQ(material.metallic, 1);
        EXPECT_EQ(material.alpha, Material::Alpha::blend);
    }
}

TEST(Evaluator, LetsLongWorkBeStopped)
{
    Evaluator evaluate = new_evaluator();
    const Progress stop = [](double, std::string_view) { throw Cancelled(); };
    EXPECT_THROW(evaluate(small_document(), stop), Cancelled);
    EXPECT_EQ(evaluate(small_document()).objects.size(), 3u);
}

TEST(ModelOf, HoldsEveryPartWithItsNameAndMaterials)
{
    Evaluator evaluate = new_evaluator();
    const Document document = after(small_document(), SetMaterial{{2}, {}});
    const Model model = model_of(evaluate(document), document);
    ASSERT_EQ(model.nodes.size(), 4u);
    EXPECT_EQ(model.nodes[2].name, "Ball");
    for (const Ref<Mesh>& mesh : model.meshes)
        for (const std::uint32_t material : mesh->face_material)
            EXPECT_LT(material, model.materials.size());
}

TEST(ModelOf, HangsPartsOnTheirGroupsWhichMoveNothing)
{
    Evaluator evaluate = new_evaluator();
    Document document = after(small_document(), Group{{4, 2}, "All"});
    document = after(document, SetTransform{5, {.translation = {1, 2, 3}}});
    const Evaluation evaluated = evaluate(document);
    const Model model = model_of(evaluated, document);
    std::vector<std::string> names;
    for (const Node& node : model.nodes)
        names.push_back(
            (node.parent < 0 ? "" : model.nodes[static_cast<std::size_t>(node.parent)].name + "/") +
            node.name);
    EXPECT_THAT(names, ::testing::ElementsAre("All", "All/Furniture", "Furniture/Table", "All/Ball",
                                              "Pot"));
    for (int n = 0; n < std::ssize(model.nodes); ++n) {
        EXPECT_LT(model.nodes[static_cast<std::size_t>(n)].parent, n);
        if (model.nodes[static_cast<std::size_t>(n)].name != "Ball") continue;
        EXPECT_EQ(node_to_model(model, n), evaluated.objects.at(2)->parts[0].to_world);
    }
}

TEST(Evaluator, LeavesOutWhatIsTooLargeAndSaysSo)
{
    Evaluator evaluate = new_evaluator();
    AddBox far;
    far.name = "Far";
    far.shape.size = {1e9, 1, 1};
    far.transform.scale = {1e5, 1, 1};
    const Document still = after(small_document(), far);
    const Id id = still.next_id - 1;
    EXPECT_THAT(lacks(evaluate(still), still), IsEmpty());
    const Document document = after(still, SetTransform{id, {.scale = {1e9, 1, 1}}});
    const Evaluation result = evaluate(document);
    EXPECT_THAT(result.objects.at(id)->parts, IsEmpty());
    EXPECT_TRUE(result.objects.at(id)->bounds->empty());
    EXPECT_THAT(result.objects.at(id)->notices, ElementsAre(HasSubstr("too large")));
    EXPECT_THAT(lacks(result, document),
                ElementsAre(HasSubstr("Far: where it lies its coordinates")));
    EXPECT_EQ(evaluate(document).objects.at(id), result.objects.at(id)) << "and it is kept";
    EXPECT_FALSE(result.objects.at(3)->parts.empty());
}

TEST(OutOfReach, IsAPartThatGoesAndTheOthersStay)
{
    const Ref<Mesh> mesh = make_ref(box_mesh({2, 2, 2}, {1, 1, 1}));
    const Box box = bounding_box(*mesh);
    glm::dmat4 far(1);
    far[3].y = 2 * most_coordinate;
    Lattice bent = lattice_at_rest(
        {Knots::uniform(3, 4), Knots::uniform(3, 4), Knots::uniform(3, 4)}, glm::dmat4(1));
    bent.displacement.points[5].z = std::numeric_limits<double>::infinity();
    const Ref<Deformation> lies = make_ref(Deformation{Embedding{}, make_ref(bent), {}});
    EvaluatedObject object;
    object.parts = {{.rest = mesh, .key = {.mesh = 0}, .bounds = box},
                    {.rest = mesh, .to_world = far, .key = {.mesh = 1}, .bounds = box},
                    {.rest = mesh, .bent = lies, .key = {.mesh = 2}, .bounds = box},
                    {.rest = mesh, .key = {.mesh = 3}, .bounds = box}};
    leave_out_what_is_out_of_reach(object);
    ASSERT_EQ(object.parts.size(), 2u);
    EXPECT_EQ(object.parts[1].key.mesh, 3);
    EXPECT_THAT(object.lacks, ElementsAre(HasSubstr("2 of its 4 meshes are left out")));
    EXPECT_EQ(object.notices, object.lacks);
}

} // namespace
} // namespace trivar
