// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/objects/animate.h"
#include "core/commands/objects/shape.h"
#include "core/commands/volumes/convert_lattice.h"
#include "core/commands/volumes/lattice.h"
#include "core/commands/volumes/tetrahedra.h"
#include "core/evaluation/evaluate.h"
#include "core/simplex/simplex_volume.h"
#include "core/tetrahedra/from_lattice.h"
#include "core/tetrahedra/tetrahedra_shaper.h"
#include "tests/support/fixtures.h"
#include "tests/support/scenes/commands.h"
#include "tests/support/scenes/world_points.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

Evaluation evaluated(const Document& document)
{
    return Evaluator(std::make_shared<const AssetStore>(""))(document);
}

std::vector<glm::vec3> ball_in(const Document& document)
{
    return testing::world_points(evaluated(document).objects.at(1)->parts.at(0));
}

// A ball of radius 0.4 (object 1) in a lattice that is pulled up in one place (object 2).
Document pulled_lattice(int order, double by = 0.2)
{
    Document out = after(Document{}, AddSphere{.shape = {.radius = 0.4}});
    out = after(out, AddLattice{.objects = {1}, .shape = {.orders = glm::ivec3(order)}});
    return after(out,
                 MovePoints{.object = 2, .shift = {.points = {{1, 1, 3}}, .by = {by / 2, 0, by}}});
}

const TetrahedraShape& tetrahedra_of(const Document& document)
{
    return std::get<TetrahedraShape>(document.objects.at(2)->source);
}

TEST(ConvertedLattices, BendWhatIsInThemAsBefore)
{
    for (const int order : {2, 3, 4}) {
        const Document lattice = pulled_lattice(order);
        double last = 1;
        for (const int pieces : {1, 2, 3}) {
            const Document tetrahedra = after(lattice, ConvertLattice{2, pieces});
            const double off = testing::most_apart(ball_in(tetrahedra), ball_in(lattice)),
                         stated = tetrahedra_of(tetrahedra).deviation;
            EXPECT_LT(off, 1.3 * stated + 2e-6) << order << " in " << pieces;
            EXPECT_TRUE(stated < last || stated < 1e-9) << order << " in " << pieces;
            last = stated;
        }
        EXPECT_LT(last, order == 2 ? 1e-9 : 1e-3) << order;
    }
}

// Looked at on a grid within the box.
double furthest(const Document& a, const Document& b)
{
    const Evaluation here = evaluated(a), there = evaluated(b);
    double most = 0;
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 x = (glm::dvec3(i % 10, i / 10 % 10, i / 100) + 0.51) / 10.1 - 0.5;
        most = std::max(
            most, glm::distance(evaluate(*here.objects.at(2)->tetrahedra->volume, x).position,
                                evaluate(*there.objects.at(2)->tetrahedra->volume, x).position));
    }
    return most;
}

TEST(ConvertedLattices, KeepTheirShapeWhenTheyAreCutAndCloudsChange)
{
    const Document whole = after(pulled_lattice(4), ConvertLattice{2, 2}),
                   cut = after(whole, EditTetrahedra{
                                          2, {.crease = TetrahedraCrease{{{0, 0, 0.1}}, 0.4, 3}}});
    const double stated = tetrahedra_of(whole).deviation;
    EXPECT_LT(furthest(cut, whole), 2 * stated);
    TetrahedraShape wider = tetrahedra_of(whole);
    wider.spread = 0.25;
    EXPECT_LT(furthest(after(whole, SetTetrahedra{2, wider}), whole), 4 * stated);
    const Document lines = after(pulled_lattice(2), ConvertLattice{2, 1}),
                   torn = after(
                       lines,
                       EditTetrahedra{2,
                                      {.crease = TetrahedraCrease{
                                           {{0, 0, 1 / 6.0}}, 0.09, 3}}}); // two faces of a seam
    EXPECT_LT(furthest(torn, lines), 1e-9);
}

TEST(ConvertedLattices, AreOffByWhatTheyStateWhileTheyAreAsConverted)
{
    EXPECT_FALSE(is_as_converted({}));
    for (const int degree : {1, 2, 3}) {
        const Document converted =
            after(pulled_lattice(4), ConvertLattice{.object = 2, .pieces = 1, .degree = degree});
        TetrahedraShape shape = tetrahedra_of(converted);
        EXPECT_TRUE(is_as_converted(shape));
        shape.edits.push_back({.warp = Warp{}});
        EXPECT_TRUE(is_as_converted(shape));
        shape.spread = 0.2;
        EXPECT_FALSE(is_as_converted(shape));
        shape = tetrahedra_of(converted);
        ++shape.degree;
        EXPECT_FALSE(is_as_converted(shape));
    }
}

TEST(ConvertedLattices, RefuseWhatIsNoneAndWhatTheyCannotKeep)
{
    const Document lattice = pulled_lattice(4);
    const auto refused = [](const Document& document, const Command& command, const char* why) {
        EXPECT_THAT([&] { after(document, command); }, ThrowsMessage<Rejected>(HasSubstr(why)));
    };
    refused(lattice, ConvertLattice{1}, "is not a lattice");
    refused(lattice, ConvertLattice{2, 16}, "at most 5,000");
    const Document tetrahedra = after(lattice, ConvertLattice{2});
    TetrahedraShape lower = tetrahedra_of(tetrahedra);
    lower.degree = 2;
    refused(tetrahedra, SetTetrahedra{2, lower}, "keeps its tetrahedra");
    TetrahedraShape fewer = tetrahedra_of(tetrahedra);
    fewer.cells.pop_back();
    refused(tetrahedra, SetTetrahedra{2, fewer}, "keeps its tetrahedra");
}

TEST(ConvertedLattices, LoseKeysOfTheBoxAndKeepThoseOfTheirPlace)
{
    Document keyed = pulled_lattice(4);
    const auto track = [](const char* name) {
        return Track{.parameter = name, .keys = {{.frame = 1, .value = 1}}};
    };
    keyed = after(keyed, Animate{{{2, {track("shape.size.x"), track("transform.translation.x")}}}});
    const Tracks left = after(keyed, ConvertLattice{2}).objects.at(2)->tracks;
    ASSERT_EQ(left.size(), 1U);
    EXPECT_EQ(left.begin()->parameter, "transform.translation.x");
}

} // namespace
} // namespace trivar
