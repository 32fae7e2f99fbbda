// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/group.h"
#include "core/commands/objects/import.h"
#include "core/commands/objects/play.h"
#include "core/commands/objects/primitives.h"
#include "core/commands/objects/shape.h"
#include "core/commands/paste.h"
#include "core/commands/placement/place.h"
#include "core/commands/placement/travel.h"
#include "core/placement/placement.h"
#include "core/stages/stroke_motion.h"
#include "core/steps/laying/attaching.h"

#include "core/base/rejected.h"
#include "core/commands/command.h"
#include "core/document/document_digest.h"
#include "core/document/parameters.h"
#include "core/evaluation/evaluate.h"
#include "tests/support/scenes/commands.h"

#include <algorithm>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::Contains, ::testing::HasSubstr, ::testing::IsEmpty;
using testing::new_evaluator, testing::small_sketch;

constexpr double exact = 1e-6; // metres
constexpr Id host_id = 1, laid_id = 2;

std::vector<glm::dvec3> points_of(const Evaluation& evaluated, Id id)
{
    std::vector<glm::dvec3> out;
    for (const Part& part : evaluated.objects.at(id)->parts)
        for (const glm::vec3& p : part.mesh()->positions)
            out.emplace_back(part.to_world * glm::dvec4(glm::dvec3(p), 1));
    return out;
}

double farthest(const std::vector<glm::dvec3>& a, const std::vector<glm::dvec3>& b,
                const glm::dmat4& by = glm::dmat4(1))
{
    EXPECT_EQ(a.size(), b.size());
    EXPECT_FALSE(a.empty());
    double most = 0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        most = std::max(most, glm::distance(glm::dvec3(by * glm::dvec4(a[i], 1)), b[i]));
    return most;
}

// Attached as it lies in that frame.
Document attached(const Document& document, Id id, double frame = 1)
{
    Evaluator evaluate(std::make_shared<const AssetStore>("/"));
    const Evaluation result = evaluate(document, frame);
    const PlacementStep& step = *object(document, id).stroke;
    const auto attachment =
        attachment_of(*result.objects.at(id), step.sketch, step.parameters.skip_back_faces);
    EXPECT_TRUE(attachment) << result.objects.at(id)->rejected;
    return after(document, Attach{id, attachment});
}

Document pot_on_table()
{
    Document document;
    for (const Command& command : std::initializer_list<Command>{
             AddBox{.name = "Table", .shape = {.size = {4, 4, 0.5}}, .transform = {}},
             AddTeapot{.name = "Pot", .shape = {.height = 0.2, .resolution = 4}, .transform = {}},
             Place{
                 .object = laid_id, .sketch = small_sketch(), .parameters = {}, .onto = {host_id}}})
        document = after(document, command);
    return document;
}

glm::dvec3 evaluate_middle(const Placement& placement)
{
    return trivar::evaluate(placement.contact, {0.5, 0.5}).value;
}

// How far a place is from the middle line of the strip.
double off_line(const Placement& placement, const glm::dvec3& p)
{
    double least = 1e300;
    for (const glm::dvec3& q : placement.strip.front())
        least = std::min(least, glm::distance(p, q));
    return least;
}

bool was_laid(const Evaluation& evaluated)
{
    return std::ranges::any_of(evaluated.timings.stages, [](const Timings::Stage& stage) {
        return stage.name == "rays" || stage.name == "springs" || stage.name == "lift" ||
               stage.name == "volume";
    });
}

// Expects a command on the host to move the strokes attached to it by that matrix, without laying
// them again.
void expect_carried(const Document& document, const Command& command, const glm::dmat4& by,
                    Id id = laid_id)
{
    Evaluator evaluate = new_evaluator();
    const Evaluation before = evaluate(document);
    const Evaluation now = evaluate(after(document, command));
    EXPECT_LT(farthest(points_of(before, id), points_of(now, id), by), exact) << verb(command);
    EXPECT_FALSE(was_laid(now)) << verb(command);
    const Placement &a = *before.objects.at(id)->placement, &b = *now.objects.at(id)->placement;
    for (int i = 0; i < 3; ++i)
        EXPECT_LT(glm::distance(glm::dvec3(by * glm::dvec4(control_point(a.volume, i, i, i), 1)),
                                control_point(b.volume, i, i, i)),
                  exact);
    const auto& strip = a.strip.front();
    for (std::size_t i = 0; i < strip.size(); ++i)
        EXPECT_LT(glm::distance(glm::dvec3(by * glm::dvec4(strip[i], 1)), b.strip.front()[i]),
                  exact);
}

TEST(Attaching, KeepsThePlaceOfWhatLiesThere)
{
    for (const Document& document : {pot_on_table(), testing::small_document()}) {
        const Id id = document.objects.contains(3) ? 3 : laid_id;
        Evaluator evaluate = new_evaluator();
        const Evaluation before = evaluate(document), now = evaluate(attached(document, id));
        EXPECT_EQ(digest(before), digest(now));
        EXPECT_FALSE(now.objects.at(id)->stroke_motion->moved());
        EXPECT_FALSE(was_laid(now) && id == laid_id);
    }
}

TEST(Attaching, CarriesWhatLiesThereByMovesTurnsAndEvenScales)
{
    const Document document = attached(pot_on_table(), laid_id);
    for (const Transform& t : std::initializer_list<Transform>{
             {.translation = {1, -2, 0.25}},
             {.translation = {3, 0, 1}, .rotation_deg = {20, -35, 140}},
             {.rotation_deg = {180, 0, 0}, .scale = {0.5, 0.5, 0.5}},
             {.translation = {2, 1, -3}, .rotation_deg = {0, 90, 7}, .scale = {3, 3, 3}}})
        expect_carried(document, SetTransform{host_id, t}, t.matrix());
}

TEST(Attaching, CarriesItByGroupsAndParents)
{
    const Document document = attached(pot_on_table(), laid_id);
    const Transform t{.translation = {0, 2, 1}, .rotation_deg = {0, 0, 40}, .scale = {2, 2, 2}};
    const Document grouped = after(document, Group{{host_id, laid_id}, "Both"});
    expect_carried(document, Group{{host_id, laid_id}, "Both"}, glm::dmat4(1));
    expect_carried(grouped, SetTransform{3, t}, t.matrix());
    Document parented = after(document, AddSphere{});
    parented = after(parented, SetParent{{host_id}, 3});
    expect_carried(parented, SetTransform{3, t}, t.matrix() * glm::inverse(to_world(parented, 3)));
}

TEST(Attaching, CarriesItByKeys)
{
    Document document = attached(pot_on_table(), laid_id);
    document = after(
        document, Animate{{{host_id,
                            {{"transform.translation.x", {{1, 0}, {25, 3, Tween::linear}}},
                             {"transform.rotation_deg.z", {{1, 0}, {25, 90, Tween::linear}}}}}}});
    Evaluator evaluate = new_evaluator();
    const Evaluation first = evaluate(document, 1);
    for (const double frame : {2.0, 7.5, 13.0, 25.0, 40.0}) {
        const Evaluation now = evaluate(document, frame);
        const glm::dmat4 by = to_world(document_at(document, frame), host_id);
        EXPECT_LT(farthest(points_of(first, laid_id), points_of(now, laid_id), by), exact) << frame;
        EXPECT_FALSE(was_laid(now)) << frame;
    }
    EXPECT_EQ(digest(new_evaluator()(document, 13.0)), digest(evaluate(document, 13.0)));
}

TEST(Attaching, CarriesWhatLiesOnWhatIsCarried)
{
    AddTorus ring;
    ring.shape = {.radius = 0.1, .tube = 0.03, .segments = {24, 12}};
    Sketch sketch = small_sketch();
    for (StrokeSample& sample : sketch.samples) sample.p_px.x = 540 + (sample.p_px.x - 440) / 2;
    Document document = attached(pot_on_table(), laid_id);
    document = attached(after(after(document, ring), Place{3, sketch, {}, {laid_id}}), 3);
    const Transform t{.translation = {1, 2, 3}, .rotation_deg = {10, 50, 90}, .scale = {2, 2, 2}};
    expect_carried(document, SetTransform{host_id, t}, t.matrix(), 3);
    // A change below is met again, where it is.
    PlacementParameters higher;
    higher.height = 0.5;
    Evaluator evaluate = new_evaluator();
    const Document moved = after(document, SetTransform{host_id, t});
    const Evaluation there = evaluate(after(moved, EditPlacement{laid_id, higher, {}, {}})),
                     here = evaluate(after(document, EditPlacement{laid_id, higher, {}, {}}));
    EXPECT_THAT(there.objects.at(3)->rejected, IsEmpty());
    EXPECT_LT(farthest(points_of(here, 3), points_of(there, 3), t.matrix()), 1e-3);
}

TEST(Attaching, CarriesVolumesThatWereShaped)
{
    const Document document = after(
        attached(pot_on_table(), laid_id),
        MovePoints{.object = laid_id, .shift = {.points = {{3, 2, 3}}, .by = {0, 0.02, 0.05}}});
    const Transform t{.translation = {1, 0, 0}, .rotation_deg = {0, 30, 60}, .scale = {2, 2, 2}};
    expect_carried(document, SetTransform{host_id, t}, t.matrix());
}

TEST(Attaching, FindsTheContactAgainWhereTheHostIsStretched)
{
    const Document document = attached(pot_on_table(), laid_id);
    Evaluator evaluate = new_evaluator();
    for (const Transform& t : std::initializer_list<Transform>{
             {.scale = {2, 1, 1}}, {.translation = {0, 0, 1}, .scale = {1, 1, 4}}}) {
        const Evaluation now = evaluate(after(document, SetTransform{host_id, t}));
        const EvaluatedObject& object = *now.objects.at(laid_id);
        ASSERT_THAT(object.rejected, IsEmpty());
        EXPECT_LE(object.placement->report.penetration, 1e-3);
        const double top = now.objects.at(host_id)->bounds->hi.z;
        EXPECT_NEAR(object.bounds->lo.z, top, 0.01);
    }
}

TEST(Attaching, BridgesWhereHostsMoveApartAndSaysSo)
{
    Document document;
    for (const double x : {-1.0, 1.0})
        document = after(document, AddBox{.name = "Half",
                                          .shape = {.size = {2, 2, 0.5}},
                                          .transform = {.translation = {x, 0, 0}}});
    document = after(document, AddTeapot{});
    document = attached(after(document, Place{3, small_sketch(), {}, {1, 2}}), 3);
    const Attachment& attachment = *object(document, 3).stroke->attach;
    EXPECT_EQ(attachment.hosts.size(), 2u);
    Evaluator evaluate = new_evaluator();
    EXPECT_THAT(evaluate(document).objects.at(3)->notices,
                ::testing::Not(Contains(HasSubstr("apart"))));
    const Document apart = after(document, SetTransform{2, {.translation = {1.5, 0, 0}}});
    const EvaluatedObject now = *evaluate(apart).objects.at(3);
    EXPECT_THAT(now.rejected, IsEmpty());
    EXPECT_THAT(now.notices, Contains(HasSubstr("hosts have moved 0.")));
    EXPECT_GT(now.bounds->size().x, evaluate(document).objects.at(3)->bounds->size().x + 0.2);
    // Both together are one motion again.
    const Transform t{.translation = {0, 3, 1}};
    const Document both = after(after(document, SetTransform{1, {.translation = {-1, 3, 1}}}),
                                SetTransform{2, {.translation = {1, 3, 1}}});
    EXPECT_LT(farthest(points_of(evaluate(document), 3), points_of(evaluate(both), 3), t.matrix()),
              exact);
}

TEST(Attaching, LeavesAloneWhatMerelyStandsBeside)
{
    Document document =
        after(pot_on_table(), AddSphere{.shape = {}, .transform = {.translation = {0, 9, 0}}});
    PlacementStep step = *object(document, laid_id).stroke;
    document =
        after(document, EditPlacement{laid_id, step.parameters, {}, std::vector<Id>{host_id, 3}});
    document = attached(document, laid_id);
    const Attachment& attachment = *object(document, laid_id).stroke->attach;
    EXPECT_EQ(main_host(attachment), 0u);
    EXPECT_FALSE(attachment.hosts.at(1).touched);
    const Transform t{.translation = {0, 0, 2}};
    Evaluator evaluate = new_evaluator();
    const Evaluation before = evaluate(document),
                     now = evaluate(after(document, SetTransform{host_id, t}));
    EXPECT_LT(farthest(points_of(before, laid_id), points_of(now, laid_id), t.matrix()), exact);
}

TEST(Attaching, LastsThroughCopiesAndDeletions)
{
    const Document document = attached(pot_on_table(), laid_id);
    const Transform t{.translation = {0, 0, 2}};
    Document both = after(document, Duplicate{{host_id, laid_id}, {0, 5, 0}}); // 3 and 4
    EXPECT_EQ(object(both, 4).stroke->attach->hosts.front().object, 3);
    Evaluator evaluate = new_evaluator();
    EXPECT_LT(farthest(points_of(evaluate(both), laid_id), points_of(evaluate(both), 4),
                       glm::translate(glm::dmat4(1), {0, 5, 0})),
              exact);
    Document pasted = after(document, copied(document, {host_id, laid_id}, "/"));
    EXPECT_EQ(object(pasted, 4).stroke->attach->hosts.front().object, 3);
    const Document moved = after(pasted, SetTransform{3, t});
    EXPECT_LT(
        farthest(points_of(evaluate(moved), laid_id), points_of(evaluate(moved), 4), t.matrix()),
        exact);
    const Document gone = after(both, Delete{{host_id}});
    EXPECT_FALSE(object(gone, laid_id).stroke->attach);
    EXPECT_TRUE(object(gone, 4).stroke->attach);
    EXPECT_FALSE(evaluate(gone).objects.at(laid_id)->rejected.empty());
    // A new stroke is in the world.
    const Document drawn = after(document, EditPlacement{laid_id, {}, small_sketch(), {}});
    EXPECT_FALSE(object(drawn, laid_id).stroke->attach);
}

TEST(Attaching, WithoutAnchorsTakesAllThatStandsByItself)
{
    const Document document = after(pot_on_table(), Attach{laid_id, {}});
    const Transform t{.translation = {1, 2, 3}, .rotation_deg = {0, 0, 90}};
    expect_carried(document, SetTransform{host_id, t}, t.matrix());
    EXPECT_EQ(digest(new_evaluator()(document)), digest(new_evaluator()(pot_on_table())));
}

TEST(Attaching, ReadsBackAsItWasWrittenAndCountsInTheDigest)
{
    const Document document = attached(pot_on_table(), laid_id);
    const Command command = Attach{laid_id, object(document, laid_id).stroke->attach};
    EXPECT_EQ(command_from_json_line(to_json_line(command)), command);
    EXPECT_NE(digest(document), digest(pot_on_table()));
    const Document again = after(pot_on_table(), command_from_json_line(to_json_line(command)));
    EXPECT_EQ(digest(again), digest(document));
}

void expect_refused(const Document& document, const Command& command, const std::string& why)
{
    try {
        after(document, command);
        ADD_FAILURE() << verb(command) << " was taken";
    } catch (const Rejected& error) {
        EXPECT_THAT(error.what(), HasSubstr(why));
    }
}

TEST(Attaching, RefusesWhatCannotBe)
{
    const Document document = attached(pot_on_table(), laid_id);
    Attachment attachment = *object(document, laid_id).stroke->attach;
    expect_refused(document, Attach{host_id, {}}, "is not placed");
    Attachment other = attachment;
    other.hosts.front().object = 7;
    expect_refused(document, Attach{laid_id, other}, "does not lie on");
    other = attachment;
    other.samples.pop_back();
    expect_refused(document, Attach{laid_id, other}, "samples but the stroke has");
    other = attachment;
    other.samples.front().host = 3;
    expect_refused(document, Attach{laid_id, other}, "host number 3 of 1");
    other = attachment;
    other.hosts.front().z = {};
    expect_refused(document, Attach{laid_id, other}, "span no space");
    other.hosts.clear();
    expect_refused(document, Attach{laid_id, other}, "names no host");
}

TEST(SetParent, KeepsThePlaceAndGoesWithAnyObject)
{
    Document document =
        after(pot_on_table(), AddSphere{.shape = {}, .transform = {.translation = {1, 0, 2}}});
    document = after(document,
                     SetTransform{host_id, {.translation = {0, 0, 1}, .rotation_deg = {0, 0, 30}}});
    const Document parented = after(document, SetParent{{3}, host_id});
    const auto off = [](const glm::dmat4& a, const glm::dmat4& b) {
        double most = 0;
        for (int i = 0; i < 4; ++i) most = std::max(most, glm::length(a[i] - b[i]));
        return most;
    };
    EXPECT_LT(off(to_world(parented, 3), to_world(document, 3)), 1e-12);
    const Document moved = after(
        parented, SetTransform{host_id, {.translation = {0, 5, 1}, .rotation_deg = {0, 0, 30}}});
    EXPECT_NEAR(to_world(moved, 3)[3].y, to_world(document, 3)[3].y + 5, 1e-12);
    const Document freed = after(moved, SetParent{{3}, 0});
    EXPECT_LT(off(to_world(freed, 3), to_world(moved, 3)), 1e-12);
    // An attached object outlives its host; one in a group does not outlive the group.
    const Document gone = after(moved, Delete{{host_id}});
    EXPECT_LT(off(to_world(gone, 3), to_world(moved, 3)), 1e-12);
    expect_refused(parented, SetParent{{host_id}, 3}, "which is in it");
    expect_refused(parented, SetParent{{3}, 3}, "cannot be in itself");
    expect_refused(parented, SetParent{{3}, laid_id}, "lies on a stroke");
    expect_refused(parented, SetParent{{3}, 99}, "there is no object 99");
}

// A reptile 1 walks in place, or along a table 3, with a rod 2 along its back.
Document on_a_reptile(bool travels)
{
    ImportModel import;
    import.file.path = std::string(TRIVAR_BINARY_DIR) + "/assets/models/reptile.glb";
    Document document;
    const auto run = [&](const Command& command) { document = after(document, command); };
    run(import);
    run(AddCylinder{.name = "Rod",
                    .shape = {.radius = 0.02, .height = 0.4, .segments = 16, .stacks = 24},
                    .transform = {}});
    Camera above{.eye = {0.5, -0.02, 5}, .target = {0.5, 0, 0}};
    above.perspective = false;
    above.height_world = 1;
    if (travels) {
        run(AddBox{.name = "Table", .shape = {.size = {6, 2, 0.1}}, .transform = {}});
        Sketch way{above, {}};
        way.camera.height_world = 6;
        for (int i = 0; i <= 20; ++i)
            way.samples.push_back(
                {project(way.camera, {-2 + 0.2 * i, 0.2 * std::sin(0.3 * i), 0.05}).p_px, 0.05 * i,
                 1});
        run(Place{1, way, {.fill = 0.25}, {3}});
        run(SetTravel{{1}, {.speed = 0.2}});
    }
    run(PlayClip{{1}, {.clip = "walk", .foot_lock = travels}});
    Evaluator evaluate(std::make_shared<const AssetStore>("/"));
    const Box bounds = *evaluate(document).objects.at(1)->bounds;
    Sketch back{above, {}};
    back.camera.eye += glm::dvec3(bounds.center().x - 0.5, bounds.center().y, 0);
    back.camera.target += glm::dvec3(bounds.center().x - 0.5, bounds.center().y, 0);
    for (int i = 0; i <= 20; ++i) {
        const double x = bounds.lo.x + bounds.size().x * (0.4 + 0.012 * i);
        back.samples.push_back(
            {project(back.camera, {x, bounds.center().y, bounds.hi.z}).p_px, 0.05 * i, 1});
    }
    PlacementParameters p;
    p.width = 0.06;
    p.height = 0.05;
    p.along = LengthAxis::z;
    run(Place{2, back, p, {1}});
    return attached(document, 2);
}

TEST(Attaching, KeepsToTheBackOfWhatWalks)
{
    for (const bool travels : {false, true}) {
        const Document document = on_a_reptile(travels);
        Evaluator evaluate(std::make_shared<const AssetStore>("/"));
        const Evaluation first = evaluate(document, 1);
        EXPECT_FALSE(first.objects.at(2)->stroke_motion->moved());
        const std::vector<glm::dvec3> before = points_of(first, 1);
        const glm::dvec3 middle = evaluate_middle(*first.objects.at(2)->placement);
        std::vector<std::size_t> near;
        for (std::size_t v = 0; v < before.size(); ++v)
            if (glm::distance(before[v], middle) < 0.02) near.push_back(v);
        ASSERT_GT(near.size(), 3u);
        for (const double frame : {2.0, 6.0, 9.5, 13.0, 19.0, 24.0, 60.0}) {
            const Evaluation now = evaluate(document, frame);
            const EvaluatedObject& rod = *now.objects.at(2);
            ASSERT_THAT(rod.rejected, IsEmpty()) << frame;
            EXPECT_LE(rod.placement->report.penetration, 1e-3) << frame;
            const std::vector<glm::dvec3> points = points_of(now, 1);
            glm::dvec3 moved(0);
            for (const std::size_t v : near) moved += points[v] - before[v];
            moved /= static_cast<double>(near.size());
            EXPECT_LT(off_line(*rod.placement, middle + moved), 0.006)
                << frame << (travels ? " on its way" : " in place");
            if (travels && frame == 60) {
                EXPECT_GT(glm::length(moved), 0.3);
            }
        }
        EXPECT_EQ(digest(Evaluator(std::make_shared<const AssetStore>("/"))(document, 9.5)),
                  digest(evaluate(document, 9.5)));
    }
}

} // namespace
} // namespace trivar
