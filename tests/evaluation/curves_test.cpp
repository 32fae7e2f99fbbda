// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/objects/arrange.h"
#include "core/commands/objects/import.h"
#include "core/commands/objects/shape.h"
#include "core/commands/placement/place.h"
#include "core/commands/placement/travel.h"
#include "core/commands/volumes/lattice.h"
#include "core/evaluation/evaluate.h"
#include "core/files/write_model.h"
#include "core/placement/shaper.h"
#include "tests/files/curves.h"
#include "tests/support/fixtures.h"
#include "tests/support/scenes/commands.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using namespace testing;
using ::testing::HasSubstr;

// A line upwards of eleven points, half a unit long, beside a triangle.
class CurvesOfObjects : public ::testing::Test {
protected:
    CurvesOfObjects()
    {
        std::string text = "v 0 0 0\nv 0.3 0 0\nv 0 0.3 0\n";
        for (int i = 0; i <= 10; ++i) text += "v 0 0 " + std::to_string(i * 0.05) + "\n";
        text += "l 4 5 6 7 8 9 10 11 12 13 14\n";
        write_file(folder_.file("line.obj"), text);
        write_file(folder_.file("both.obj"), text + "f 1 2 3\n");
    }
    Document with(const std::string& name, Document document = {}) const
    {
        ImportModel import;
        import.file.path = name;
        import.file.up = UpAxis::z;
        return after(document, import);
    }
    Evaluation shown(const Document& document) const
    {
        return Evaluator(std::make_shared<const AssetStore>(folder_.path().string()))(document);
    }
    Line line_in_world(const Document& document, Id id) const
    {
        return in_world(shown(document).objects.at(id)->curves.at(0)).points->positions;
    }
    TemporaryFolder folder_;
};

TEST_F(CurvesOfObjects, StandWhereTheirObjectStands)
{
    Document document = with("line.obj");
    document = after(document, SetTransform{.object = 1, .transform = {.translation = {1, 2, 3}}});
    const EvaluatedObject object = *shown(document).objects.at(1);
    EXPECT_TRUE(object.parts.empty());
    EXPECT_TRUE(object.notices.empty()) << "a mesh is not missing";
    EXPECT_EQ(line_in_world(document, 1).back(), glm::vec3(1, 2, 3.5f));
    EXPECT_EQ(object.bounds->lo, glm::dvec3(1, 2, 3));
    EXPECT_EQ(object.bounds->hi, glm::dvec3(1, 2, 3.5));
}

TEST_F(CurvesOfObjects, AreBentByALatticeAsVerticesAre)
{
    Document document = after(with("both.obj"), AddLattice{.objects = {1}});
    document = after(
        document,
        MovePoints{.object = 2, .shift = {.points = {{1, 1, 3}, {2, 2, 3}}, .by = {0.2, 0, 0.3}}});
    const Evaluation there = shown(document);
    const Lattice& volume = *there.objects.at(2)->shaped->volume->volume;
    const Embedding embedding{there.objects.at(2)->placement->embedding.to_uvw, glm::dmat4(1)};
    const Line line = line_in_world(document, 1);
    for (int i = 0; i <= 10; ++i) {
        const glm::dvec3 p =
            deform(glm::dvec3(0, 0, float(i * 0.05)), embedding, volume).position_world;
        EXPECT_LT(glm::distance(glm::dvec3(line[static_cast<std::size_t>(i)]), p), 1e-6);
    }
    EXPECT_NE(line, line_in_world(with("both.obj"), 1));
}

TEST_F(CurvesOfObjects, LieOnAStrokeLikeTheMeshBesideThem)
{
    const Document document =
        after(with("line.obj", small_document()), Place{5, small_sketch(), {}, {1}});
    const EvaluatedObject object = *shown(document).objects.at(5);
    EXPECT_EQ(object.rejected, "");
    ASSERT_TRUE(object.curves.at(0).points.bent);
    EXPECT_EQ(object.curves[0].points.mesh()->vertex_count(), 11u);
    EXPECT_GT(object.bounds->hi.z, 0.25) << "on the table";
}

TEST_F(CurvesOfObjects, GoWithEachOfAllThatFollowOneAnother)
{
    Document document =
        after(with("both.obj", small_document()), Place{5, small_sketch(), {.fill = 0.1}, {1}});
    document = after(document, SetTravel{{5}, {.ends = Ends::loop, .followers = 2}});
    const EvaluatedObject object = *shown(document).objects.at(5);
    ASSERT_EQ(object.curves.size(), object.parts.size());
    EXPECT_GT(object.curves.size(), 1u);
    for (std::size_t i = 0; i < object.curves.size(); ++i)
        EXPECT_EQ(object.curves[i].points.key.member, object.parts[i].key.member);
}

TEST_F(CurvesOfObjects, AreReadBackAsTheyWereExported)
{
    Document document = after(with("both.obj"), AddLattice{.objects = {1}});
    document = after(
        document, MovePoints{.object = 2, .shift = {.points = {{1, 1, 3}}, .by = {0.2, 0, 0.3}}});
    const Model model = model_of(shown(document), document);
    for (const char* name : {"out.obj", "out.glb"}) {
        write_model(model, folder_.file(name));
        EXPECT_EQ(lines_of(read_model(folder_.file(name))), lines_of(model)) << name;
    }
    EXPECT_EQ(lines_of(model), (std::vector<Line>{line_in_world(document, 1)}));
}

TEST_F(CurvesOfObjects, CountForTheDigestOfWhatIsShown)
{
    const Document document = with("both.obj");
    write_file(folder_.file("both.obj"), "v 0 0 0\nv 0.3 0 0\nv 0 0.3 0\nf 1 2 3\n");
    const std::string alone = digest(shown(document));
    write_file(folder_.file("both.obj"), "v 0 0 0\nv 0.3 0 0\nv 0 0.3 0\nf 1 2 3\nl 1 2\n");
    EXPECT_NE(digest(shown(document)), alone);
}

} // namespace
} // namespace trivar
