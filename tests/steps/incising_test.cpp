// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/commands/cutting/incise.h"
#include "core/commands/objects/animate.h"
#include "core/commands/objects/group.h"
#include "core/commands/objects/import.h"
#include "core/commands/objects/primitives.h"
#include "core/document/document_digest.h"
#include "core/document/parameters.h"
#include "core/files/read_model.h"
#include "core/files/write_model.h"
#include "core/mesh/closed_body.h"
#include "core/mesh/primitives.h"
#include "tests/support/fixtures.h"
#include "tests/support/rigged.h"
#include "tests/support/scenes/commands.h"
#include "tests/support/scenes/incised_ball.h"

#include <algorithm>
#include <gmock/gmock.h>

namespace trivar {
namespace {

using testing::across_the_front;
using testing::ball_in;
using testing::ball_to_incise;
using testing::effects_of;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::incised_ball;
using ::testing::IsEmpty;
using testing::new_evaluator;
using testing::over_ball;
using testing::TemporaryFolder;
using ::testing::ThrowsMessage;

TEST(Incising, OpensABallThatStaysClosed)
{
    const Ref<EvaluatedObject> whole = ball_in(ball_to_incise()), ball = ball_in(incised_ball());
    EXPECT_THAT(ball->notices, IsEmpty());
    ASSERT_EQ(ball->incisions.size(), 1u);
    EXPECT_NEAR(ball->incisions[0].depth, 0.15, 1e-6);
    EXPECT_NEAR(ball->incisions[0].length, 0.88, 0.05);
    ASSERT_EQ(ball->parts.size(), 1u);
    EXPECT_TRUE(is_closed_body(*ball->parts[0].mesh()));
    EXPECT_GT(ball->parts[0].mesh()->face_count(), whole->parts[0].mesh()->face_count());
}

TEST(Incising, IsUndoneToTheBit)
{
    const Document before = ball_to_incise();
    const Document cut = after(incised_ball(), Incise{1, over_ball({1, 0, -0.5}, {1, 0, 0.5})});
    EXPECT_NE(digest(cut), digest(before));
    const Document one = after(cut, RemoveIncision{1, 2});
    EXPECT_EQ(digest(one), digest(incised_ball()));
    EXPECT_EQ(digest(after(one, RemoveIncision{1, 1})), digest(before));
    EXPECT_EQ(digest(after(cut, ClearIncisions{{1}})), digest(before));
}

TEST(Incising, LeavesTheBitsOfWhatIsShut)
{
    const std::string whole = effects_of(ball_to_incise());
    EXPECT_EQ(effects_of(incised_ball(0)), whole);
    NamedIncision hidden = across_the_front();
    hidden.hidden = true;
    EXPECT_EQ(effects_of(after(ball_to_incise(), Incise{1, hidden})), whole);
    EXPECT_NE(effects_of(incised_ball()), whole);
}

TEST(Incising, OpensByKeysWithOneTopology)
{
    const Document document = after(
        incised_ball(), Animate{{{1,
                                  {{"incising.cuts.0.opening", {{1, 0, Tween::linear}, {11, 1}}},
                                   {"incising.cuts.0.to", {{1, 0, Tween::linear}, {6, 1}}}}}}});
    Evaluator evaluator = new_evaluator();
    const auto mesh_at = [&](double frame) {
        return evaluator(document, frame).objects.at(1)->parts.at(0).mesh();
    };
    const Ref<Mesh> shut = mesh_at(1), half = mesh_at(6), open = mesh_at(11);
    EXPECT_EQ(shut, evaluator(ball_to_incise(), 1).objects.at(1)->parts.at(0).mesh());
    EXPECT_EQ(half->corners, open->corners);
    EXPECT_NE(half->positions, open->positions);
    EXPECT_TRUE(is_closed_body(*mesh_at(3)));
    EXPECT_EQ(*open, *ball_in(incised_ball())->parts.at(0).mesh());
}

TEST(Incising, KeepsKeysWithTheIncisionsThatStay)
{
    Document document = after(incised_ball(), Incise{1, over_ball({1, 0, -0.5}, {1, 0, 0.5})});
    document = after(document, Animate{{{1, {{"incising.cuts.1.width", {{1, 0.1}}}}}}});
    document = after(document, RemoveIncision{1, 1});
    const Tracks& tracks = object(document, 1).tracks;
    ASSERT_EQ(tracks.size(), 1u);
    EXPECT_EQ(tracks.begin()->parameter, "incising.cuts.0.width");
    EXPECT_TRUE(object(after(document, ClearIncisions{{1}}), 1).tracks.empty());
}

TEST(Incising, ChangesOneOfSeveralAndKeepsItsStroke)
{
    NamedIncision deeper = across_the_front(0.5);
    deeper.cut.stroke.clear();
    deeper.cut.depth = 0.25;
    const Document document = after(incised_ball(), EditIncision{1, 1, deeper});
    const NamedIncision& changed = object(document, 1).incising->cuts.at(0);
    EXPECT_EQ(changed.cut.stroke, across_the_front().cut.stroke);
    EXPECT_EQ(changed.cut.depth, 0.25);
    EXPECT_NEAR(ball_in(document)->incisions.at(0).depth, 0.25, 1e-6);
    EXPECT_EQ(step_title(EditIncision{1, 1, deeper}, incised_ball(), document).words,
              "Depth and opening of incision 1 of Sphere");
}

TEST(Incising, ShowsItsLayersUnderOneMaterial)
{
    Document document =
        after(incised_ball(),
              LayerIncisions{{1},
                             {.cuts = {},
                              .layers = {{"skin", 0.03, {.base_color = {0.9, 0.6, 0.5, 1}}},
                                         {"flesh", 0, {.base_color = {0.5, 0.1, 0.1, 1}}}}}});
    const auto used = [&](std::size_t faces_from) {
        const Ref<EvaluatedObject> ball = ball_in(document);
        const std::vector<std::uint32_t>& all = ball->parts.at(0).mesh()->face_material;
        std::vector<std::uint32_t> out(all.begin() + static_cast<long>(faces_from), all.end());
        std::ranges::sort(out);
        out.erase(std::unique(out.begin(), out.end()), out.end());
        return out;
    };
    EXPECT_THAT(used(0), ElementsAre(0u, 1u, 2u));
    document = after(document, SetMaterial{{1}, {.base_color = {0, 1, 0, 1}}});
    const std::vector<Material>& shown = *ball_in(document)->materials;
    ASSERT_EQ(shown.size(), 3u);
    EXPECT_EQ(shown[0].base_color, glm::vec4(0, 1, 0, 1));
    EXPECT_EQ(shown[1].name, "skin");
    EXPECT_EQ(shown[2].base_color, glm::vec4(0.5, 0.1, 0.1, 1));
}

// Two balls of radius 1, each a mesh, the second one smaller and beside the first.
std::string two_balls(const TemporaryFolder& folder)
{
    Model model;
    model.meshes = {make_ref(sphere_mesh(1, 48, 24)), make_ref(sphere_mesh(1, 48, 24))};
    model.nodes.resize(2);
    model.nodes[0].mesh = 0;
    model.nodes[1].mesh = 1;
    model.nodes[1].to_parent = glm::dmat4(0.5);
    model.nodes[1].to_parent[3] = {1.5, 0, 0, 1};
    write_model(model, folder.file("balls.glb"));
    return "balls.glb";
}

TEST(Incising, CutsTheMeshUnderTheFirstPoint)
{
    const TemporaryFolder folder;
    ImportModel import;
    import.file.path = two_balls(folder);
    Evaluator evaluator(std::make_shared<const AssetStore>(folder.path().string()));
    const Document document = after(Document{}, import);
    const Ref<EvaluatedObject> whole = evaluator(document, 1).objects.at(1);
    ASSERT_EQ(whole->shape->meshes.size(), 2u);
    const glm::dmat4 to_model = whole->shape->meshes[1].to_model;
    NamedIncision second = across_the_front();
    for (SurfacePoint& each : second.cut.stroke)
        each.p = glm::dvec3(to_model * glm::dvec4(each.p, 1));
    second.cut.depth = 0.05;
    second.cut.width = 0.05;
    const Ref<EvaluatedObject> cut = evaluator(after(document, Incise{1, second}), 1).objects.at(1);
    EXPECT_EQ(cut->shape->meshes[0].rest, whole->shape->meshes[0].rest);
    EXPECT_NE(cut->shape->meshes[1].rest, whole->shape->meshes[1].rest);
    EXPECT_NEAR(cut->incisions.at(0).depth, 0.05, 1e-6); // metres on the model
}

TEST(Incising, CutsEachMeshThatAStrokeGoesOver)
{
    const TemporaryFolder folder;
    ImportModel import;
    import.file.path = two_balls(folder);
    Evaluator evaluator(std::make_shared<const AssetStore>(folder.path().string()));
    const Document document = after(Document{}, import);
    const auto shown = [&](const NamedIncision& incision) {
        return evaluator(after(document, Incise{1, incision}), 1).objects.at(1);
    };
    const std::vector<Shape::NodeMesh> whole = evaluator(document, 1).objects.at(1)->shape->meshes;
    const std::vector<SurfacePoint> stroke = across_the_front().cut.stroke;
    NamedIncision first = across_the_front(), second = first, both = first;
    for (SurfacePoint& each : second.cut.stroke) {
        each.p = glm::dvec3(whole[1].to_model * glm::dvec4(each.p, 1));
        both.cut.stroke.push_back(each);
    }
    const Ref<EvaluatedObject> cut = shown(both);
    EXPECT_NE(cut->shape->meshes[0].rest, whole[0].rest);
    EXPECT_NE(cut->shape->meshes[1].rest, whole[1].rest);
    EXPECT_NEAR(cut->incisions.at(0).length,
                shown(first)->incisions.at(0).length + shown(second)->incisions.at(0).length, 1e-6);
    EXPECT_THAT(cut->notices, ElementsAre(HasSubstr("it goes over several meshes")));
    both.opening.to = 0.2; // of both: the second one is shut
    const Ref<EvaluatedObject> begun = shown(both);
    EXPECT_NE(*begun->shape->meshes[0].rest, *whole[0].rest);
    const Ref<Mesh> shut = begun->shape->meshes[1].rest;
    const glm::vec3* const before = whole[1].rest->positions.data();
    EXPECT_TRUE(
        std::equal(before, before + whole[1].rest->vertex_count(), shut->positions.begin()));
}

// Round the top of a slab that is 0.1 thick.
NamedIncision round_a_slab()
{
    NamedIncision out;
    for (int i = 0; i <= 24; ++i) {
        const double a = 2 * 3.14159265358979 * (i % 24) / 24;
        out.cut.stroke.push_back({{0.3 * std::cos(a), 0.3 * std::sin(a), 0.05}, {0, 0, 1}});
    }
    out.cut.width = 0.02;
    out.cut.floor = Incision::Floor::through;
    return out;
}

TEST(Incising, CutsAHoleThroughASlab)
{
    const Document slab =
        after(Document{}, AddBox{.shape = {.size = {2, 2, 0.1}, .segments = {24, 24, 1}}});
    const auto cut = [&](Incision::Piece piece, double opening) {
        NamedIncision round = round_a_slab();
        round.cut.piece = piece;
        round.opening.share = opening;
        const Ref<EvaluatedObject> out = ball_in(after(slab, Incise{1, round}));
        EXPECT_THAT(out->notices, IsEmpty());
        EXPECT_TRUE(is_closed_body(*out->parts.at(0).mesh()));
        return out->parts.at(0).mesh();
    };
    const Ref<Mesh> whole = ball_in(slab)->parts.at(0).mesh();
    const auto faces_in_the_middle = [](const Mesh& mesh) {
        std::size_t count = 0;
        for (const std::uint32_t v : mesh.corners)
            count += glm::length(glm::vec2(mesh.positions[v])) < 0.2f;
        return count;
    };
    EXPECT_EQ(*cut(Incision::Piece::kept, 0), *whole);
    EXPECT_GT(faces_in_the_middle(*cut(Incision::Piece::kept, 1)), 0u);
    EXPECT_EQ(faces_in_the_middle(*cut(Incision::Piece::left_out, 1)), 0u);
    EXPECT_EQ(faces_in_the_middle(*cut(Incision::Piece::left_out, 0)), 0u);
}

TEST(Incising, SaysWhyACutHasAFloor)
{
    NamedIncision through = across_the_front(); // over a half of the ball, with no way through
    through.cut = over_ball({0.1, -1, 0}, {0.1, 1, 0}).cut;
    through.cut.floor = Incision::Floor::through;
    const Ref<EvaluatedObject> ball = ball_in(after(ball_to_incise(), Incise{1, through}));
    EXPECT_THAT(ball->notices, ElementsAre(HasSubstr("incision 1 does not go through: ")));
    EXPECT_NEAR(ball->incisions.at(0).depth, through.cut.depth, 1e-6);
    NamedIncision open = across_the_front();
    open.cut.piece = Incision::Piece::left_out;
    EXPECT_THAT(ball_in(after(ball_to_incise(), Incise{1, open}))->notices,
                ElementsAre(HasSubstr("incision 1 keeps its piece: ")));
}

TEST(Incising, CountsWhatCameLaterOnlyWhereItIsSet)
{
    const std::string plain = digest(incised_ball());
    NamedIncision cut = across_the_front();
    cut.cut.lean_deg = 20;
    EXPECT_NE(digest(after(ball_to_incise(), Incise{1, cut})), plain);
    EXPECT_NE(effects_of(after(ball_to_incise(), Incise{1, cut})), effects_of(incised_ball()));
    cut.cut.lean_deg = 0;
    EXPECT_EQ(digest(after(ball_to_incise(), Incise{1, cut})), plain);
    cut.cut.bevel = 0.01;
    cut.cut.roundness = 0.5;
    const Command command = Incise{1, cut};
    EXPECT_EQ(command_from_json_line(to_json_line(command)), command);
    EXPECT_NE(effects_of(after(ball_to_incise(), Incise{1, cut})), effects_of(incised_ball()));
}

TEST(Incising, SaysWhatItCannotCut)
{
    NamedIncision away = across_the_front();
    away.name = "Scar";
    for (SurfacePoint& each : away.cut.stroke) each.p *= 1.5;
    const Document document = after(incised_ball(), Incise{1, away});
    const Ref<EvaluatedObject> ball = ball_in(document);
    EXPECT_THAT(ball->notices, ElementsAre(HasSubstr("\"Scar\" is left out: ")));
    EXPECT_EQ(*ball->parts[0].mesh(), *ball_in(incised_ball())->parts[0].mesh());
}

TEST(Incising, RefusesBadInputInASentence)
{
    const auto refused = [](auto change) {
        NamedIncision cut = across_the_front();
        change(cut);
        return [cut] { after(ball_to_incise(), Incise{1, cut}); };
    };
    const auto says = [](const char* words) { return ThrowsMessage<Rejected>(HasSubstr(words)); };
    EXPECT_THAT(refused([](auto& c) { c.cut.stroke.resize(1); }), says("one point"));
    EXPECT_THAT(refused([](auto& c) { c.cut.stroke.clear(); }), says("no points"));
    EXPECT_THAT(refused([](auto& c) { c.cut.stroke[2].p.y = std::nan(""); }), says("stroke[2].p"));
    EXPECT_THAT(refused([](auto& c) { c.cut.stroke[3].normal *= 2; }),
                says("must have the length 1"));
    EXPECT_THAT(refused([](auto& c) { c.cut.stroke.resize(100'000, c.cut.stroke[0]); }),
                says("at most 10,000 are taken"));
    EXPECT_THAT(refused([](auto& c) { c.cut.width = 0; }), says("\"width\" is 0"));
    EXPECT_THAT(refused([](auto& c) { c.cut.depth = 0; }), says("\"depth\" is 0"));
    EXPECT_THAT(refused([](auto& c) { c.opening.share = 1.5; }), says("\"opening\" is 1.5"));
    EXPECT_THAT(refused([](auto& c) {
                    c.cut.depth_profile = {IncisionProfile::Shape::custom, {{0.5, 1}, {0.2, 1}}};
                }),
                says("go back"));
    const Document ball = ball_to_incise();
    EXPECT_THAT(
        [&] {
            after(ball, EditIncision{1, 1, across_the_front()});
        },
        says("has no incisions"));
    EXPECT_THAT([&] { after(incised_ball(), RemoveIncision{1, 2}); }, says("none of number 2"));
    EXPECT_THAT(
        [&] {
            after(after(ball, Group{.objects = {1}}), Incise{2, across_the_front()});
        },
        says("has no surface of its own"));
}

TEST(Incising, CrossesCutsToTheSameBitsForAnyNumberOfThreads)
{
    Document document = incised_ball();
    for (int k = 0; k < 4; ++k)
        document = after(document,
                         Incise{1, over_ball({1, 0.2 * k - 0.3, -0.5}, {1, 0.3 - 0.2 * k, 0.5})});
    std::string expected;
    for (const int threads : {1, 2}) {
        const ThreadLimit limit(threads);
        const Ref<EvaluatedObject> ball = ball_in(document);
        EXPECT_TRUE(is_closed_body(*ball->parts.at(0).mesh()));
        const std::string found = effects_of(document);
        if (threads == 1) expected = found;
        EXPECT_EQ(found, expected);
    }
}

} // namespace
} // namespace trivar
