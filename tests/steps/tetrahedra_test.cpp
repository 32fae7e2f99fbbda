// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/commands/objects/animate.h"
#include "core/commands/objects/arrange.h"
#include "core/commands/paste.h"
#include "core/commands/volumes/lattice.h"
#include "core/commands/volumes/tetrahedra.h"
#include "core/commands/volumes/warp.h"
#include "core/document/document_digest.h"
#include "core/evaluation/evaluate.h"
#include "core/placement/placement.h"
#include "core/tetrahedra/tetrahedra_shaper.h"
#include "tests/support/fixtures.h"
#include "tests/support/scenes/commands.h"

#include <gmock/gmock.h>
#include <map>

namespace trivar {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const TetrahedraEdit pulled{
    .pull = TetrahedraPull{.at = {0.2, 0, 0}, .radius = 0.5, .by = {0.1, 0, 0.05}}};

// A ball of radius 0.4 (object 1) in tetrahedra that fill a box of 1 x 1 x 1 (object 2).
Document ball_in_tetrahedra(const TetrahedraShape& shape = {})
{
    Document document = after(Document{}, AddSphere{.shape = {.radius = 0.4}});
    return after(document, AddTetrahedra{.objects = {1}, .shape = shape});
}

Evaluation all_of(const Document& document, double frame = 1)
{
    return Evaluator(std::make_shared<const AssetStore>(""))(document, frame);
}

std::vector<glm::vec3> points_of(const Evaluation& all, Id id)
{
    const Part part = all.objects.at(id)->parts.at(0);
    std::vector<glm::vec3> out;
    for (const glm::vec3& p : part.mesh()->positions)
        out.emplace_back(part.to_world * glm::dvec4(p, 1));
    return out;
}
std::vector<glm::vec3> points_of(const Document& document, Id id)
{
    return points_of(all_of(document), id);
}

TEST(TetrahedraInDocuments, AtRestLeaveWhatStandsInThemWhereItIs)
{
    const Document alone = after(Document{}, AddSphere{.shape = {.radius = 0.4}});
    EXPECT_EQ(points_of(ball_in_tetrahedra(), 1), points_of(alone, 1));
}

TEST(TetrahedraInDocuments, BendTheirContentsAsTheirSplineSays)
{
    const Document at_rest = ball_in_tetrahedra();
    const Document document = after(at_rest, EditTetrahedra{2, pulled});
    const Evaluation all = all_of(document);
    const EvaluatedObject& volume = *all.objects.at(2);
    ASSERT_TRUE(volume.tetrahedra);
    const std::vector<glm::vec3> before = points_of(at_rest, 1), after_it = points_of(all, 1);
    double most = 0;
    for (std::size_t i = 0; i < before.size(); ++i) {
        const glm::dvec3 expected = evaluate(*volume.tetrahedra->volume, before[i]).position;
        EXPECT_LE(glm::distance(glm::dvec3(after_it[i]), expected), 1e-6);
        most = std::max<double>(most, glm::distance(before[i], after_it[i]));
    }
    EXPECT_GE(most, 0.05);
}

TEST(TetrahedraInDocuments, BendToTheSameBitsForAnyNumberOfThreads)
{
    Document document =
        after(Document{}, AddSphere{.shape = {.radius = 0.4, .segments = 128, .rings = 64}});
    document = after(document, AddTetrahedra{.objects = {1}});
    document = after(document, EditTetrahedra{2, pulled});
    const auto mesh = [&](int threads) {
        const ThreadLimit limit(threads);
        return *all_of(document).objects.at(1)->parts.at(0).mesh();
    };
    EXPECT_EQ(mesh(1), mesh(4));
}

TEST(TetrahedraInDocuments, BendWhereTheyStand)
{
    SetTransform turned{.object = 2,
                        .transform = {.translation = {0.1, 0, 0}, .rotation_deg = {0, 0, 90}}};
    Document document = after(ball_in_tetrahedra(), EditTetrahedra{2, pulled});
    const std::vector<glm::vec3> before = points_of(document, 1);
    document = after(document, turned);
    const std::vector<glm::vec3> moved = points_of(document, 1);
    // the volume and its contents move as one
    for (std::size_t i = 0; i < before.size(); ++i)
        EXPECT_LE(glm::distance(moved[i], glm::vec3(0.1f - before[i].y, before[i].x, before[i].z)),
                  1e-6f);
}

TEST(TetrahedraInDocuments, NestWithLattices)
{
    Document document = after(ball_in_tetrahedra(), EditTetrahedra{2, pulled});
    const std::vector<glm::vec3> alone = points_of(document, 1);
    document = after(document, AddLattice{.objects = {2}, .shape = {.size = {2, 2, 2}}});
    EXPECT_EQ(points_of(document, 1), alone); // a lattice at rest
    document = after(document, WarpVolume{.object = 3, .warp = {.twist_deg = 40}});
    EXPECT_NE(points_of(document, 1), alone);
    // and a lattice inside of tetrahedra
    Document inner =
        after(after(Document{}, AddSphere{.shape = {.radius = 0.4}}), AddLattice{.objects = {1}});
    inner = after(inner, AddTetrahedra{.objects = {2}});
    inner = after(inner, EditTetrahedra{3, pulled});
    const std::vector<glm::vec3> bent = points_of(inner, 1);
    for (std::size_t i = 0; i < bent.size(); ++i)
        EXPECT_LE(glm::distance(bent[i], alone[i]), 1e-5f);
    EXPECT_NE(*all_of(inner).objects.at(2)->seen_cage(),
              all_of(inner).objects.at(2)->placement->volume);
}

TEST(TetrahedraInDocuments, FollowKeysOfTheirEdits)
{
    Document document = after(ball_in_tetrahedra(), EditTetrahedra{2, pulled});
    const Track track{.parameter = "shape.edits.0.pull.by.x",
                      .keys = {{.frame = 1, .value = 0}, {.frame = 11, .value = 0.2}}};
    document = after(document, Animate{.of = {{2, {track}}}});
    const std::vector<glm::vec3> first = points_of(all_of(document, 1), 1),
                                 last = points_of(all_of(document, 11), 1);
    EXPECT_NE(first, last);
}

// The faces of a box of 2 x 2 x 2 boxes about the origin that lie in the oblique plane x = y.
TetrahedraEdit oblique_cut(double size)
{
    TetrahedraCrease crease{.radius = 0.05 * size, .depth = 2};
    for (const double xy : {-0.5, 0.0})
        for (const double z : {-0.5, 0.0})
            for (const double t : {1.0 / 3, 2.0 / 3})
                crease.places.push_back(glm::dvec3(xy + t / 2, xy + t / 2, z + (1 - t) / 2) * size);
    return {.crease = crease};
}

TEST(TetrahedraInDocuments, PartTheirContentsAtACut)
{
    Document document = after(ball_in_tetrahedra(), EditTetrahedra{2, oblique_cut(1)});
    ASSERT_EQ(all_of(document).objects.at(2)->tetrahedra->volume->layers[0]->domain().cuts.size(),
              8U);
    document = after(document, EditTetrahedra{2,
                                              {.pull = TetrahedraPull{.at = {0.2, -0.2, 0},
                                                                      .radius = 2,
                                                                      .by = {0.1, -0.1, 0},
                                                                      .decay = Decay::box}}});
    const Evaluation all = all_of(document);
    const Mesh& mesh = *all.objects.at(1)->parts.at(0).mesh();
    // Nothing is left between the two halves, and both are closed.
    for (const glm::vec3& p : mesh.positions)
        EXPECT_TRUE(p.x - p.y < 1e-4f || p.x - p.y > 0.199f) << p.x - p.y;
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
            const std::uint32_t next = c + 1 == mesh.face_begin[f + 1] ? mesh.face_begin[f] : c + 1;
            const std::uint32_t a = mesh.point(mesh.corners[c]), b = mesh.point(mesh.corners[next]);
            ++edges[{std::min(a, b), std::max(a, b)}];
        }
    for (const auto& [edge, count] : edges) EXPECT_EQ(count, 2);
}

TEST(TetrahedraInDocuments, KeepKnotsThatWereMovedAndTheShapeAtRest)
{
    const TetrahedraCloud moved{.at = {0, 0, 0}, .knot = 2, .by = {0.05, 0, 0.02}};
    const Document document = after(ball_in_tetrahedra(), EditTetrahedra{2, {.cloud = moved}});
    EXPECT_EQ(points_of(document, 1), points_of(ball_in_tetrahedra(), 1));
    const auto knots_of = [](const Document& d) {
        return all_of(d).objects.at(2)->tetrahedra->volume->layers[0]->domain().knots;
    };
    EXPECT_NE(knots_of(document), knots_of(ball_in_tetrahedra()));
    const Document read =
        after(ball_in_tetrahedra(),
              command_from_json_line(to_json_line(EditTetrahedra{2, {.cloud = moved}})));
    EXPECT_EQ(digest(read), digest(document));
}

TEST(TetrahedraInDocuments, HoldDragsOfOneKnotAsOneEdit)
{
    const auto drag = [](int knot, const glm::dvec3& by, double factor = 1) {
        return EditTetrahedra{
            2,
            {.cloud = TetrahedraCloud{.at = {0, 0, 0}, .knot = knot, .by = by, .factor = factor}}};
    };
    const auto edits = [](const Document& d) {
        return std::get_if<TetrahedraShape>(&object(d, 2).source)->edits;
    };
    Document document = ball_in_tetrahedra();
    for (int n = 0; n < 8; ++n) document = after(document, drag(2, {0.0078125, 0, 0}));
    ASSERT_EQ(edits(document).size(), 1U);
    EXPECT_EQ(edits(document)[0].cloud->by, glm::dvec3(0.0625, 0, 0));
    document = after(document, drag(1, {0.01, 0, 0})); // another knot
    document = after(document, drag(0, {0, 0, 0}, 0.5));
    document = after(document, drag(0, {0, 0.01, 0}, 0.5));
    ASSERT_EQ(edits(document).size(), 3U);
    EXPECT_EQ(edits(document)[2].cloud->factor, 0.25);
    document = after(document, EditTetrahedra{2, pulled});
    document = after(document, drag(0, {0, 0, 0.01})); // not right after
    EXPECT_EQ(edits(document).size(), 5U);
    document = after(document, drag(0, {0, 0, -0.01})); // and back
    EXPECT_EQ(edits(document).size(), 4U);
}

TEST(TetrahedraInDocuments, TakeTheSameKnotsFromOneEditAsFromTwo)
{
    const TetrahedraCloud first{.at = {0, 0, 0}, .by = {0.02, 0, 0.01}, .factor = 0.5},
        second{.at = {0, 0, 0}, .by = {0, -0.02, 0}, .factor = 0.75};
    const auto knots_of = [](const Document& d) {
        return all_of(d).objects.at(2)->tetrahedra->volume->layers[0]->domain().knots;
    };
    const std::vector<glm::dvec3> together =
        knots_of(after(after(ball_in_tetrahedra(), EditTetrahedra{2, {.cloud = first}}),
                       EditTetrahedra{2, {.cloud = second}}));
    const std::vector<glm::dvec3> apart = knots_of(after(
        ball_in_tetrahedra(), SetTetrahedra{2, {.edits = {{.cloud = first}, {.cloud = second}}}}));
    ASSERT_EQ(together.size(), apart.size());
    for (std::size_t k = 0; k < apart.size(); ++k)
        EXPECT_LE(glm::distance(together[k], apart[k]), 1e-15) << k;
}

TEST(TetrahedraInDocuments, HoldNoEditThatTheyWouldNotTakeAgain)
{
    const EditTetrahedra widened{2, {.cloud = TetrahedraCloud{.at = {9, 9, 9}, .factor = 100}}};
    const Document document = after(after(ball_in_tetrahedra(), widened), widened);
    const SetTetrahedra same = SetTetrahedra::as_it_is(object(document, 2), 2).value();
    EXPECT_EQ(digest(after(document, same)), digest(document));
    EXPECT_EQ(same.shape.edits.size(), 2U);
}

TEST(TetrahedraInDocuments, RefuseMoreThanTheyCanHoldInAll)
{
    const auto refused = [](const Document& document, const Command& command, const char* why) {
        EXPECT_THAT([&] { (void)after(document, command); },
                    ThrowsMessage<Rejected>(HasSubstr(why)));
    };
    const Document document = ball_in_tetrahedra();
    const TetrahedraEdit fine{
        .refinement = TetrahedraRefinement{.places = {{0, 0, 0}}, .radius = 0.5, .edge = 0.0276}};
    refused(document, SetTetrahedra{2, {.edits = {fine, fine, fine}}}, "at most 400000 tetrahedra");
    const Document twice = after(document, SetTetrahedra{2, {.edits = {fine, fine}}});
    refused(twice, EditTetrahedra{2, fine}, "at most 400000 tetrahedra");
    const TetrahedraEdit long_stroke{
        .crease = TetrahedraCrease{.places = std::vector(60000, glm::dvec3(9))}};
    refused(document, SetTetrahedra{2, {.edits = {long_stroke, long_stroke}}},
            "at most 100,000 places");
    refused(after(document, EditTetrahedra{2, long_stroke}), EditTetrahedra{2, long_stroke},
            "at most 100,000 places");
    const TetrahedraEdit many_balls{.pull =
                                        TetrahedraPull{.also = std::vector(99000, glm::dvec3(9))}};
    refused(document, SetTetrahedra{2, {.edits = std::vector(11, many_balls)}},
            "at most 1,000,000 balls");
    refused(document, SetTetrahedra{2, {.functions = std::vector<TetrahedraFunction>(65)}},
            "at most 64 functions");
}

TEST(TetrahedraInDocuments, SayWhenTheyAreCutAlongMorePlanesThanTheirContents)
{
    const auto notices = [](const glm::ivec3& boxes) {
        const TetrahedraCrease everywhere{.places = {{0, 0, 0}}, .radius = 10, .depth = 1};
        const Document document =
            ball_in_tetrahedra({.boxes = boxes, .degree = 1, .edits = {{.crease = everywhere}}});
        return all_of(document).objects.at(2)->notices;
    };
    EXPECT_THAT(notices({30, 1, 1}), ElementsAre(HasSubstr("64 planes")));
    EXPECT_THAT(notices({2, 1, 1}), ElementsAre());
}

TEST(TetrahedraInDocuments, SayWhatOfTheirContentsTheyDoNotHold)
{
    Document document = after(ball_in_tetrahedra(), EditTetrahedra{2, pulled});
    EXPECT_THAT(all_of(document).objects.at(1)->notices, ElementsAre());
    document =
        after(document, SetTransform{.object = 1, .transform = {.translation = {0.5, 0, 0}}});
    EXPECT_THAT(all_of(document).objects.at(1)->notices,
                ElementsAre(HasSubstr("outside of the tetrahedra")));
}

TEST(TetrahedraInDocuments, SayWhyTheyDoNotBendWhereTheyLieOverEachOther)
{
    TetrahedraShape shape{.degree = 1};
    for (int n = 0; n < 4000; ++n) {
        for (const glm::dvec3& corner : {glm::dvec3(0), {1, 0, 0}, {0, 1, 0}, {0, 0, 1}})
            shape.vertices.push_back(corner + 1e-5 * n);
        shape.cells.push_back(glm::ivec4(0, 1, 2, 3) + 4 * n);
    }
    EXPECT_THAT(all_of(ball_in_tetrahedra(shape)).objects.at(2)->notices,
                ElementsAre(HasSubstr("lie over each other")));
}

TEST(TetrahedraInDocuments, SetASheetAsItWasMade)
{
    const SimplexSheetShape cubic{.degree = 3, .lifts = {{.by = {0, 0, 0.2}}}};
    const Document added = after(Document{}, AddSimplexSheet{.shape = cubic});
    const Document set = after(after(Document{}, AddSimplexSheet{}), SetSimplexSheet{1, cubic});
    EXPECT_EQ(points_of(set, 1), points_of(added, 1));
}

TEST(TetrahedraInDocuments, AreCopiedWithTheirEdits)
{
    const Document document = after(ball_in_tetrahedra(), EditTetrahedra{2, pulled});
    const Document copy = after(document, copied(document, {2, 1}, ""));
    const auto* shape = std::get_if<TetrahedraShape>(&object(copy, 3).source);
    ASSERT_TRUE(shape);
    EXPECT_EQ(shape->edits.size(), 1U);
}

TEST(TetrahedraInDocuments, RefuseWhatCannotBe)
{
    const auto refused = [](const Command& command, const char* why) {
        EXPECT_THAT([&] { (void)after(ball_in_tetrahedra(), command); },
                    ThrowsMessage<Rejected>(HasSubstr(why)));
    };
    refused(EditTetrahedra{1, pulled}, "not a volume of tetrahedra");
    refused(EditTetrahedra{2, {}}, "one of pull");
    const TetrahedraCloud across{.at = {0, 0, 0}, .knot = 2, .by = {0.9, 0.1, 0}};
    refused(EditTetrahedra{2, {.cloud = across}}, "The knot clouds at cell");
    refused(SetTetrahedra{2, {.edits = {{.cloud = across}}}}, "cross");
    refused(SetSimplexSheet{2, {}}, "not a surface of simplex splines");
    refused(AddTetrahedra{.objects = {}}, "no object");
    refused(AddTetrahedra{.objects = {1}, .shape = {.boxes = {100, 100, 100}}}, "at most 200,000");
    refused(AddTetrahedra{.objects = {1}, .shape = {.degree = 7}}, "between 1 and 3");
    refused(AddTetrahedra{.objects = {1}, .shape = {.degree = 0}}, "between 1 and 3");
    const TetrahedraShape million{.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                  .cells = std::vector<glm::ivec4>(1000000, {0, 1, 2, 3})};
    refused(AddTetrahedra{.objects = {1}, .shape = million}, "at most 100,000");
    refused(SetTetrahedra{2, million}, "at most 100,000");
    const TetrahedraRefinement fine{.places = {{0, 0, 0}}, .radius = 0.5, .edge = 0.0148};
    refused(EditTetrahedra{2, {.refinement = fine}}, "a refinement has at most 200,000 tetrahedra");
    const TetrahedraRefinement finest{.places = {{0, 0, 0}}, .radius = 0.5, .edge = 1e-4};
    refused(EditTetrahedra{2, {.refinement = finest}}, "too short");
    const TetrahedraRefinement far_away{
        .places = {{1e9, 0, 0}, {1e9, 0.01, 0}}, .radius = 1e-8, .edge = 1e-8};
    refused(EditTetrahedra{2, {.refinement = far_away}}, "too short");
    refused(
        SetTetrahedra{
            2, {.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, .cells = {{1, 0, 2, 3}}}},
        "flat or inverted");
    refused(
        SetTetrahedra{
            2, {.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, .cells = {{0, 1, 2, 3}}}},
        "flat or inverted");
    refused(
        SetTetrahedra{
            2, {.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}}, .cells = {{0, 1, 2, 3}}}},
        "same place");
    refused(SetTetrahedra{2, {.cells = {{0, 1, 2, 3}}}}, "vertex 0 of 0");
}

} // namespace
} // namespace trivar
