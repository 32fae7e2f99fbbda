// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/files/curves.h"

#include "core/files/formats.h"
#include "core/files/gltf/glb_chunks.h"
#include "core/files/write_model.h"
#include "tests/files/gltf_texts.h"
#include "tests/files/text_models.h"
#include "tests/support/fixtures.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using namespace testing;
using ::testing::ElementsAre, ::testing::HasSubstr, ::testing::IsEmpty;

const std::string four_points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

Model read_obj_lines(const std::string& text)
{
    return read_model_bytes(text, "a.obj", "", {.up = UpAxis::z});
}

TEST(Curves, OfAnObjAreItsLinesPointByPoint)
{
    const Model model = read_obj_lines("l 1/1 2/2 3 1\n" + four_points + "l -1 -4\n");
    EXPECT_THAT(lines_of(model), ElementsAre(Line{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 0, 0}},
                                             Line{{0, 1, 0}, {0, 0, 0}}));
    EXPECT_THAT(model.notices, IsEmpty());
    EXPECT_EQ(model.nodes.front().mesh, -1) << "there are no faces";
}

TEST(Curves, StandBesideTheFacesOfTheirFile)
{
    const Model model = read_obj_lines(four_points + "f 1 2 3\nl 3 4\n");
    EXPECT_EQ(model.meshes[0]->vertex_count(), 3u) << "the fourth is of the line alone";
    EXPECT_THAT(lines_of(model), ElementsAre(Line{{1, 1, 0}, {0, 1, 0}}));
    EXPECT_THAT(model.notices, IsEmpty());
}

TEST(Curves, HaveTheMaterialThatWasNamedBeforeThem)
{
    const Model model = read_obj_lines(four_points + "l 1 2\nusemtl a\nf 1 2 3\nl 1 9\nl 2 3\n" +
                                       "usemtl b\nl 3 4\n");
    std::vector<std::string> names;
    for (const std::uint32_t m : model.curves[0]->material)
        names.push_back(model.materials[m].name);
    EXPECT_THAT(names, ElementsAre("", "a", "b"));
}

TEST(Curves, HaveTheColoursOfTheirVertices)
{
    const Model model = read_obj_lines("v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nl 1 2\n");
    EXPECT_THAT(model.curves[0]->points->colors,
                ElementsAre(glm::vec4(1, 0, 0, 1), glm::vec4(0, 1, 0, 1)));
}

// Lines follow the same rules as faces.
TEST(Curves, ThatNameNoVerticesOrOneAreLeftOutAndSaidOnce)
{
    const Model model =
        read_obj_lines(four_points + "l 1 2\nl\nl 3\nl 1 9\nl 1 x 2\nl 0 1\nl -9 1\n");
    EXPECT_EQ(lines_of(model).size(), 1u);
    EXPECT_THAT(model.notices,
                ElementsAre("a.obj: 6 lines were left out, for they name fewer than two vertices "
                            "or one that is not there (the first: line 6)"));
    EXPECT_THAT(refusal_of(four_points + "l 1\n", ".obj"), HasSubstr("no faces and no lines"));
}

TEST(Curves, BeyondAMillionPointsAreLeftOutAndSaid)
{
    std::string text = four_points;
    for (int i = 0; i < 500'003; ++i) text += "l 1 2\n";
    const Model model = read_obj_lines(text);
    EXPECT_EQ(line_count(model), 500'000u);
    EXPECT_THAT(model.notices, ElementsAre("a.obj: 3 lines were left out: the curves of a file "
                                           "have at most 1000000 points"));
}

TEST(Curves, OfAGltfAreListsStripsAndLoops)
{
    GltfText text = triangle_gltf();
    const auto read = [&](int mode) {
        text["meshes"][0]["primitives"][0]["mode"] = mode;
        return read_model_bytes(text.dump(), "a.gltf", "", {.up = UpAxis::z});
    };
    const glm::vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
    EXPECT_THAT(lines_of(read(1)), ElementsAre(Line{a, b}));
    EXPECT_THAT(read(1).notices, ElementsAre(HasSubstr("a line with one end")));
    EXPECT_THAT(lines_of(read(2)), ElementsAre(Line{a, b, c, a}));
    EXPECT_THAT(lines_of(read(3)), ElementsAre(Line{a, b, c}));
    EXPECT_THAT(read(3).notices, IsEmpty());
}

// A file of a few lines of text may hang the same curves on as many nodes.
TEST(Curves, OnTheNodesOfAGltfHaveFourMillionPointsAtMost)
{
    std::string text = four_points + "l";
    for (int i = 0; i < 450'000; ++i) text += " 1 2";
    GlbChunks chunks = glb_chunks(write_glb(read_obj_lines(text + "\n")));
    GltfText json = GltfText::parse(chunks.json);
    for (int n = 1; n < 10; ++n) {
        json["nodes"].push_back(json["nodes"][0]);
        json["scenes"][0]["nodes"].push_back(n);
    }
    chunks.json = json.dump();
    const Model model = read_model_bytes(glb_container(chunks), "a.glb", "");
    EXPECT_EQ(line_count(model), 4u);
    EXPECT_THAT(model.notices, ElementsAre("a.glb: the lines of 6 nodes were left out: those of "
                                           "all nodes have too many points"));
}

TEST(Curves, OfAPlyAreItsEdgesJoinedWhereOneGoesOnWithTheOther)
{
    const std::string header =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
        "property float z\nelement edge 4\nproperty int vertex1\nproperty int vertex2\n"
        "end_header\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
    const Model model = read_text_model(header + "0 1\n1 2\n3 0\n1 7\n", ".ply");
    EXPECT_THAT(lines_of(model),
                ElementsAre(Line{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, Line{{0, 1, 0}, {0, 0, 0}}));
    EXPECT_THAT(model.notices, ElementsAre(HasSubstr("1 edge names a vertex that is not there")));
}

TEST(Curves, AreReadAsTheyWereWritten)
{
    const TemporaryFolder folder;
    const Model model = curves_model();
    for (const char* name : {"a.glb", "a.obj"}) {
        write_model(model, folder.file(name));
        const Model back = read_model(folder.file(name));
        EXPECT_EQ(lines_of(back), lines_of(model)) << name;
        EXPECT_EQ(back.nodes.front().name, std::string(name) == "a.glb" ? "wires" : "a");
        for (std::size_t l = 0; l < 4; ++l)
            EXPECT_EQ(back.materials.at(back.curves[0]->material_of(l)).name, l ? "blue" : "red");
    }
}

TEST(Curves, OnANodeWithAMeshAreWrittenBesideIt)
{
    const TemporaryFolder folder;
    Model model = box_model();
    model.curves = curves_model().curves;
    model.nodes.front().curves = 0;
    for (const char* name : {"a.glb", "a.obj"}) {
        write_model(model, folder.file(name));
        const Model back = read_model(folder.file(name));
        EXPECT_EQ(lines_of(back), lines_of(model)) << name;
        EXPECT_EQ(back.meshes.size(), 1u);
    }
}

TEST(Curves, AreLeftOutByFormatsThatHaveNone)
{
    const TemporaryFolder folder;
    Model model = box_model();
    model.curves = curves_model().curves;
    model.nodes.front().curves = 0;
    EXPECT_EQ(what_is_lost(model, "a.glb"), "");
    EXPECT_EQ(what_is_lost(model, "a.stl"),
              ".stl files have no curves, and 4 lines were left out; .glb and .obj have them");
    EXPECT_THAT([&] { write_model(curves_model(), folder.file("a.ply")); },
                ::testing::ThrowsMessage<Rejected>(HasSubstr("no faces to write")));
}

} // namespace
} // namespace trivar
