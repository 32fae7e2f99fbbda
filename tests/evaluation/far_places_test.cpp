// SPDX-License-Identifier: GPL-3.0-or-later
// What a scene gives far from the origin is what it gives near it, moved.
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/import.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/placement/place.h"
#include "core/evaluation/far_places.h"
#include "core/placement/placement.h"

#include "core/files/read_model.h"
#include "core/files/write_model.h"
#include "core/steps/laying/attaching.h"
#include "tests/support/fixtures.h"
#include "tests/support/scenes/commands.h"
#include "tests/support/scenes/lying.h"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>

namespace trivar {
namespace {

using testing::fitting_commands, testing::fitting_document, testing::furthest_off,
    testing::new_evaluator, testing::small_document, testing::small_sketch, testing::world_points;

const glm::dvec3 utm(684032, 5613568, 0);

// The same scene at another place: what stands in the world by itself, and the views of strokes.
Document at_another_place(Document document, const glm::dvec3& by)
{
    const Document before = document;
    for (const auto& [id, ref] : before.objects) {
        Object object = *ref;
        if (object.parent == 0) object.transform.translation += by;
        if (object.stroke) {
            object.stroke->sketch.camera.eye += by;
            object.stroke->sketch.camera.target += by;
            if (object.stroke->attach)
                for (AttachedHost& host : object.stroke->attach->hosts) host.origin += by;
        }
        document.objects.set(id, make_ref(std::move(object)));
    }
    return document;
}

void expect_same(const Evaluation& near, const Evaluation& far, const glm::dvec3& by, double off)
{
    ASSERT_EQ(near.objects.size(), far.objects.size());
    for (const auto& [id, object] : near.objects) {
        const EvaluatedObject& there = *far.objects.at(id);
        EXPECT_EQ(there.rejected, object->rejected);
        EXPECT_EQ(there.notices, object->notices);
        EXPECT_EQ(there.parts.size(), object->parts.size());
        const std::vector<glm::dvec3> expected = world_points(*object);
        if (expected.empty()) continue;
        EXPECT_LE(furthest_off(world_points(there), expected, glm::translate(glm::dmat4(1), by)),
                  off)
            << "object " << id;
        const Box box = *object->bounds, box_there = *there.bounds;
        EXPECT_LE(glm::distance(box.lo + by, box_there.lo), 2 * off);
        EXPECT_LE(glm::distance(box.hi + by, box_there.hi), 2 * off);
        // and where another program finds them, by the formula of each point
        for (std::size_t p = 0; p < there.parts.size(); ++p) {
            const Part& part = there.parts[p];
            if (!part.bent) continue;
            const Mesh& before = *innermost(part).before_volume();
            for (std::size_t v = 0; v < before.vertex_count(); v += 37)
                EXPECT_LE(glm::distance(
                              place_in_world(part, glm::dvec3(before.positions[v])),
                              glm::dvec3(part.to_world * glm::dvec4(part.mesh()->positions[v], 1))),
                          off);
        }
    }
}

// A pot on a stroke over a table, attached to it.
Document attached(const glm::dvec3& by)
{
    Document document = at_another_place(small_document(), by);
    const Evaluation evaluated = new_evaluator()(document);
    Sketch sketch = small_sketch();
    sketch.camera.eye += by;
    sketch.camera.target += by;
    return after(
        document,
        Attach{.object = 3, .attach = *attachment_of(*evaluated.objects.at(3), sketch, false)});
}

} // namespace

TEST(FarPlaces, GiveForEveryCommandWhatItGivesNearTheOrigin)
{
    for (const Command& command : fitting_commands()) {
        const Document near = after(fitting_document(), command);
        const Document far = at_another_place(near, utm);
        SCOPED_TRACE(command.kind());
        expect_same(new_evaluator()(near), new_evaluator()(far), utm, 2e-5);
    }
}

TEST(FarPlaces, LeaveVerticesNearZero)
{
    const Document far = at_another_place(fitting_document(), utm);
    for (const auto& [id, object] : new_evaluator()(far).objects)
        for (const Part& part : object->parts)
            for (const glm::vec3& p : part.mesh()->positions) EXPECT_LT(glm::length(p), 20) << id;
}

TEST(FarPlaces, ChangeNothingNearTheOrigin)
{
    const Document document = fitting_document();
    FarPlaces places;
    const Shape empty;
    const FarPlaces::Near near =
        places(document, {1, 2, 3}, [&](Id) -> const Shape& { return empty; });
    EXPECT_TRUE(near.moved_by.empty());
    EXPECT_EQ(near.document, document);
}

TEST(FarPlaces, OfOneObjectLeaveOthersWhereTheyAre)
{
    const Document alone = small_document();
    AddBox far_box;
    far_box.transform.translation = utm;
    const Document both = after(alone, far_box);
    const Evaluation near = new_evaluator()(alone), far = new_evaluator()(both);
    for (const Id id : {1, 2, 3})
        EXPECT_EQ(world_points(*near.objects.at(id)), world_points(*far.objects.at(id)));
}

TEST(FarPlaces, KeepAttachedStrokesOnTheirHosts)
{
    for (const glm::dvec3& turn : {glm::dvec3(0), glm::dvec3(0, 0, 40)}) {
        const auto moved = [&](Document document, const glm::dvec3& by) {
            const glm::dvec3 there = by + glm::dvec3(0.5, 0.25, 0.125);
            return after(std::move(document),
                         SetTransform{.object = 4,
                                      .transform = {.translation = there, .rotation_deg = turn}});
        };
        const Document near = moved(attached(glm::dvec3(0)), glm::dvec3(0)),
                       far = moved(attached(utm), utm);
        expect_same(new_evaluator()(near), new_evaluator()(far), utm, 2e-5);
        EXPECT_EQ(
            attachment_of(*new_evaluator()(far).objects.at(3),
                          stroke_now(*new_evaluator()(far).objects.at(3), *object(far, 3).stroke),
                          false)
                .has_value(),
            true);
    }
}

TEST(FarPlaces, AreMetByRays)
{
    const Evaluation far = new_evaluator()(at_another_place(small_document(), utm));
    const EvaluatedObject& pot = *far.objects.at(3);
    const std::optional<Hit> hit =
        pot.lies_on->hit({utm + glm::dvec3(0.1, 0.2, 5), glm::dvec3(0, 0, -1)});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->p_world.z, 0.4, 0.1); // the ball on the table
    for (const StripNode& node : pot.placement->nodes)
        EXPECT_LT(glm::distance(node.p_world, utm), 5);
}

TEST(FarPlaces, AreWrittenWithAllTheirDetail)
{
    const Document near_document = small_document();
    const Document far_document = at_another_place(near_document, utm);
    const Evaluation near = new_evaluator()(near_document), far = new_evaluator()(far_document);
    const Model near_model = model_of(near, near_document), far_model = model_of(far, far_document);
    const testing::TemporaryFolder folder;
    for (const char* extension : {".ply", ".obj", ".off", ".glb"}) {
        const std::string a = folder.file(std::string("near") + extension),
                          b = folder.file(std::string("far") + extension);
        write_model(near_model, a);
        write_model(far_model, b);
        EXPECT_EQ(what_is_lost(far_model, b), "");
        const auto points = [](const Model& model) {
            std::vector<glm::dvec3> out;
            for (std::size_t n = 0; n < model.nodes.size(); ++n)
                if (const int m = model.nodes[n].mesh; m >= 0)
                    for (const glm::vec3& p : model.meshes[static_cast<std::size_t>(m)]->positions)
                        out.emplace_back(node_to_model(model, static_cast<int>(n)) *
                                         glm::dvec4(p, 1));
            return out;
        };
        EXPECT_LE(furthest_off(points(read_model(b)), points(read_model(a)),
                               glm::translate(glm::dmat4(1), utm)),
                  2e-5)
            << extension;
    }
    EXPECT_THAT(what_is_lost(far_model, "far.stl"), ::testing::HasSubstr("round places to 0.7 m"));
}

// A file of a map whose points are 10 cm apart, moved back to the origin in the scene.
TEST(FarPlaces, KeepTheGridOfAMap)
{
    std::string grid;
    for (int y = 0; y <= 10; ++y)
        for (int x = 0; x <= 10; ++x)
            grid += fmt::format("v {:.1f} {:.1f} {}\n", 684263.1 + 0.1 * x, 5613583.1 + 0.1 * y,
                                0.01 * x * y);
    for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 10; ++x) {
            const int v = 11 * y + x + 1;
            grid += fmt::format("f {} {} {} {}\n", v, v + 1, v + 12, v + 11);
        }
    const testing::TemporaryFolder folder;
    testing::write_file(folder.file("grid.obj"), grid);
    ImportModel import;
    import.file.path = folder.file("grid.obj");
    import.file.up = UpAxis::z;
    Document document = after({}, import);
    document =
        after(document,
              SetTransform{.object = 1, .transform = {.translation = {-684263.1, -5613583.1, 0}}});
    const std::vector<glm::dvec3> points = world_points(*new_evaluator()(document).objects.at(1));
    ASSERT_EQ(points.size(), 121u);
    for (int y = 0; y <= 10; ++y)
        for (int x = 0; x <= 10; ++x)
            EXPECT_LE(glm::distance(points[static_cast<std::size_t>(11 * y + x)],
                                    glm::dvec3(0.1 * x, 0.1 * y, 0.01 * x * y)),
                      1e-6);
}

} // namespace trivar
