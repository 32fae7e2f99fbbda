// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/objects/animate.h"
#include "core/commands/volumes/tetrahedra.h"
#include "core/evaluation/evaluate.h"
#include "core/tetrahedra/pulled_layer.h"
#include "core/tetrahedra/tetrahedra_shaper.h"
#include "tests/support/fixtures.h"
#include "tests/support/scenes/commands.h"
#include "tests/support/scenes/world_points.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

// A ball of radius 0.4 (object 1) in tetrahedra that fill a box of 1 x 1 x 1 (object 2).
Document ball_with(std::vector<TetrahedraEdit> edits)
{
    Document document = after(Document{}, AddSphere{.shape = {.radius = 0.4}});
    return after(document, AddTetrahedra{.objects = {1}, .shape = {.edits = std::move(edits)}});
}

Ref<EvaluatedObject> shown(const Document& document, Id id)
{
    return Evaluator(std::make_shared<const AssetStore>(""))(document).objects.at(id);
}
std::vector<glm::vec3> ball_in(const Document& document)
{
    return testing::world_points(shown(document, 1)->parts.at(0));
}
const std::vector<TetrahedraEdit>& edits_of(const Document& document)
{
    return std::get<TetrahedraShape>(object(document, 2).source).edits;
}

TetrahedraEdit refined_at(double x)
{
    return {.refinement = TetrahedraRefinement{.places = {{x, 0, 0}}, .radius = 0.25, .edge = 0.1}};
}
TetrahedraEdit pulled_at(double x, int layer)
{
    return {.pull =
                TetrahedraPull{.layer = layer, .at = {x, 0, 0}, .radius = 0.2, .by = {0, 0, 0.02}}};
}

// Refinements of the left and the right half, and what is pulled there.
const std::vector<TetrahedraEdit> both_halves{refined_at(-0.3), refined_at(0.3), pulled_at(-0.3, 1),
                                              pulled_at(0.3, 2)};

TEST(EditsOfTetrahedra, KeepTheirRefinementsWhenOthersAreRemoved)
{
    const Document left = after(ball_with(both_halves), RemoveTetrahedraEdit{2, 2}),
                   right = after(ball_with(both_halves), RemoveTetrahedraEdit{2, 1});
    EXPECT_EQ(edits_of(left), (std::vector{refined_at(-0.3), pulled_at(-0.3, 1)}));
    EXPECT_EQ(edits_of(right), (std::vector{refined_at(0.3), pulled_at(0.3, 1)}));
    EXPECT_NE(ball_in(left), ball_in(right));
    const Document unpulled = after(ball_with(both_halves), RemoveTetrahedraEdit{2, 3});
    EXPECT_EQ(edits_of(unpulled),
              (std::vector{refined_at(-0.3), refined_at(0.3), pulled_at(0.3, 2)}));
}

TEST(EditsOfTetrahedra, KeepTheirKeysWhenOthersAreRemoved)
{
    Document keyed = ball_with(both_halves);
    for (const char* name : {"shape.edits.2.pull.by.x", "shape.edits.3.pull.by.z"})
        keyed = after(keyed, Animate{.of = {{2, {{.parameter = name, .keys = {{.value = 0.1}}}}}}});
    const Document left = after(keyed, RemoveTetrahedraEdit{2, 1});
    const std::vector<Track>& tracks = object(left, 2).tracks;
    ASSERT_EQ(tracks.size(), 1U);
    EXPECT_EQ(tracks[0].parameter, "shape.edits.1.pull.by.z");
}

TEST(EditsOfTetrahedra, AreRemovedWhereTheyAre)
{
    const auto refused = [](const Command& command, const char* why) {
        EXPECT_THAT([&] { (void)after(ball_with(both_halves), command); },
                    ThrowsMessage<Rejected>(HasSubstr(why)));
    };
    refused(RemoveTetrahedraEdit{2, 5}, "has 4 edits, and none of number 5");
    refused(RemoveTetrahedraEdit{1, 1}, "not a volume of tetrahedra");
}

// Across all faces whose middles are that near to a place.
TetrahedraEdit creased(const glm::dvec3& place, double radius, int depth)
{
    return {.crease = TetrahedraCrease{{place}, radius, depth}};
}

TEST(EditsOfTetrahedra, PaintFacesSmoothAgain)
{
    const auto domain = [](const std::vector<TetrahedraEdit>& edits) {
        return shown(ball_with(edits), 2)->tetrahedra->volume->layers[0]->domain();
    };
    const TetrahedraEdit cut = creased({0, 0, 0}, 0.4, 2), smooth = creased({0, 0, 0}, 0.4, 0),
                         crease = creased({0, 0, 0}, 0.4, 1);
    const SimplexDomain<3> whole = domain({}), parted = domain({cut});
    ASSERT_GE(parted.cuts.size(), 8U);
    for (const auto& edits : {std::vector{smooth}, {cut, smooth}, {crease, cut, smooth}}) {
        EXPECT_TRUE(domain(edits).cuts.empty());
        EXPECT_EQ(domain(edits).knots, whole.knots);
    }
    EXPECT_EQ(domain({cut, crease}).cuts, parted.cuts); // the deeper one counts
    EXPECT_EQ(domain({smooth, cut}).cuts, parted.cuts); // the later one
    EXPECT_EQ(domain({cut, smooth, crease}).knots, domain({crease}).knots);
    // a part of the faces alone
    const std::size_t left = domain({cut, creased({0.2, 0.2, 0.2}, 0.3, 0)}).cuts.size();
    EXPECT_GT(left, 0U);
    EXPECT_LT(left, parted.cuts.size());
}

TEST(EditsOfTetrahedra, NearACutAPullActsOnTheDomain)
{
    TetrahedraShape shape{.degree = 2, .edits = {refined_at(-0.2), refined_at(0.2)}};
    EXPECT_EQ(pulled_layer(shape, {0.2, 0, 0}, 0.1), 2);
    EXPECT_EQ(pulled_layer(shape, {-0.3, 0, 0}, 0.1), 1);
    EXPECT_EQ(pulled_layer(shape, {0, 0.5, 0}, 0.1), 0);
    shape.edits.push_back(
        {.crease = TetrahedraCrease{.places = {{0.5, 0, 0}}, .radius = 0.1, .depth = 2}});
    EXPECT_EQ(pulled_layer(shape, {0.2, 0, 0}, 0.1), 2);
    EXPECT_EQ(pulled_layer(shape, {0.2, 0, 0}, 0.25), 0);
    EXPECT_EQ(pulled_layer(shape, {-0.3, 0, 0}, 0.25), 1);
    shape.edits.back().crease->depth = 1; // they still meet there
    EXPECT_EQ(pulled_layer(shape, {0.2, 0, 0}, 0.25), 2);
}

} // namespace
} // namespace trivar
