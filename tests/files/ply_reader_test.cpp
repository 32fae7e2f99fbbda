// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/files/text_models.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const std::string square_corners = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

// Four vertices and another element, declared and given.
std::string ply_with(const std::string& declared, const std::string& given)
{
    return "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
           "property float z\n" +
           declared + "end_header\n" + square_corners + given;
}

std::string with_strips(const std::string& strips, const std::string& number = "1")
{
    return ply_with("element tristrips " + number + "\nproperty list int int vertex_indices\n",
                    strips);
}

std::string with_uvs(const std::string& faces, const std::string& number)
{
    return ply_with("element face " + number +
                        "\nproperty list uchar int vertex_indices\n"
                        "property list uchar float texcoord\n",
                    faces);
}

Mesh ply_mesh(const std::string& text)
{
    return *read_text_model(text, ".ply").meshes[0];
}

TEST(PlyReader, TurnsEverySecondTriangleOfAStripRound)
{
    const Mesh mesh = ply_mesh(with_strips("4 0 1 3 2\n"));
    EXPECT_THAT(mesh.corners, ElementsAre(0, 1, 3, 3, 1, 2));
    for (std::size_t f = 0; f < 2; ++f) EXPECT_GT(area_normal(mesh, f).z, 0);
}

TEST(PlyReader, BeginsStripsAnewBelowZeroAndLeavesOutTheirTurns)
{
    const Mesh expected = ply_mesh(with_strips("4 0 1 3 2\n"));
    EXPECT_EQ(ply_mesh(with_strips("9 0 1 3 -1 -1 3 1 2 -1\n")), expected);
    EXPECT_EQ(ply_mesh(with_strips("3 0 1 3\n3 3 1 2\n", "2")), expected);
    // Triangles without an area lead from one strip to the next.
    const Model turned = read_text_model(with_strips("7 0 1 3 3 3 1 2\n"), ".ply");
    EXPECT_EQ(*turned.meshes[0], expected);
    EXPECT_THAT(turned.notices, IsEmpty());
    EXPECT_THAT(refusal_of(with_strips("4 0 1 -1 2\n"), ".ply"), HasSubstr("point cloud"));
}

TEST(PlyReader, SplitsVerticesWhereTheCornersOfFacesDifferInTheirTextureCoordinates)
{
    const Mesh mesh = ply_mesh(with_uvs("3 0 1 2 6 0 0 1 0 1 1\n3 0 2 3 6 0 0 0.5 0.5 0 1\n", "2"));
    EXPECT_EQ(mesh.vertex_count(), 5u);
    EXPECT_EQ(point_count(mesh), 4u) << "the surface stays whole";
    const std::vector<glm::vec2> expected{{0, 0}, {1, 0}, {1, 1}, {0, 0}, {0.5, 0.5}, {0, 1}};
    for (std::size_t c = 0; c < 6; ++c) EXPECT_EQ(mesh.uvs[0][mesh.corners[c]], expected[c]);
    EXPECT_THAT(mesh.points, ElementsAre(0, 1, 2, 2, 3));
}

TEST(PlyReader, GivesTheSameMeshForCoordinatesOfVerticesAndOfCornersWithoutASeam)
{
    std::string text = ply_text(square_model());
    text.insert(text.find("element face"), "property float s\nproperty float t\n");
    for (const char* row : {"0 0 0", "1 0 0", "1 1 0", "0 1 0"}) {
        const std::string uv(row, 3); // x y
        text.insert(text.find('\n', text.find(std::string("\n") + row) + 1), " " + uv);
    }
    const Mesh expected = ply_mesh(text);
    ASSERT_EQ(expected.uvs.size(), 1u);
    EXPECT_EQ(ply_mesh(with_uvs("3 0 1 2 6 0 0 1 0 1 1\n3 0 2 3 6 0 0 1 1 0 1\n", "2")), expected);
}

TEST(PlyReader, SaysWhatItLeftOutOfTextureCoordinatesAndPictures)
{
    std::string text = with_uvs("3 0 1 2 6 0 0 1 x 1 1\n3 0 2 3 4 0 0 1 1\n", "2");
    text.insert(text.find("element vertex"), "comment TextureFile my t.png\n");
    const Model model = read_text_model(text, ".ply");
    EXPECT_EQ(model.meshes[0]->uvs.size(), 1u);
    EXPECT_THAT(model.notices,
                ElementsAre("a.ply: 1 normal, colour or texture coordinate was no number from "
                            "-3.4e38 to 3.4e38 and became 0",
                            "a.ply: 1 list of texcoord was left out; they should have two numbers "
                            "for each corner of the face",
                            "a.ply: the header names 1 picture that was left out: my t.png; OBJ "
                            "and glTF bring their pictures"));
}

TEST(PlyReader, SkipsElementsAndPropertiesThatItDoesNotKnow)
{
    const std::string text =
        ply_with("property uchar quality\nproperty list uchar int rays\nelement edge 1\n"
                 "property int a\nelement face 1\nproperty uchar flags\n"
                 "property list uchar uchar vertex_index\nproperty list int float weights\n",
                 "");
    const std::string head = text.substr(0, text.find(square_corners));
    EXPECT_EQ(ply_mesh(head + "0 0 0 7 0\n1 0 0 7 2 5 5\n1 1 0 7 0\n0 1 0 7 1 1\n4\n"
                              "1 4 0 1 2 3 2 0.5 0.5\n"),
              ply_mesh(ply_text({square_model().vertices, {{0, 1, 2, 3}}})));
}

TEST(PlyReader, LeavesOutFacesOfVerticesThatAreNotThere)
{
    TextModel model = square_model();
    const Mesh expected = ply_mesh(ply_text(model));
    model.faces.insert(model.faces.begin() + 1, {{0, 1, 4}, {-1, 1, 2}});
    const Model read = read_text_model(ply_text(model), ".ply");
    EXPECT_EQ(*read.meshes[0], expected);
    EXPECT_THAT(read.notices,
                ElementsAre("a.ply: 2 faces name vertices that are not there and were left out "
                            "(the first: face 1, counted from 0); the file has 4 vertices"));
    EXPECT_THAT(refusal_of(with_strips("3 0 1 4\n"), ".ply"),
                HasSubstr("every face names a vertex that is not there"));
}

TEST(PlyReader, SaysTheElementAndTheWordThatIsWrong)
{
    const std::string text = ply_text(square_model());
    const auto with = [&](const std::string& was, const std::string& now) {
        std::string other = text;
        other.replace(other.rfind(was), was.size(), now);
        return refusal_of(other, ".ply");
    };
    EXPECT_EQ(with("1 1 0", "1 1e39 0"), "a.ply: vertex 2 of 4, counted from 0: its y is '1e39', "
                                         "which is not a number from -3.4e38 to "
                                         "3.4e38");
    EXPECT_EQ(with("3 0 2 3", "3 0 2"), "a.ply: face 1 of 2, counted from 0: the file ends here");
    EXPECT_EQ(
        with("3 0 2 3", "3 0 2.5 3"),
        "a.ply: face 1 of 2, counted from 0: it has '2.5' in place of the number of a vertex");
    EXPECT_EQ(with("end_header", "end"), "a.ply: line 9: 'end' does not belong in a PLY header");
    EXPECT_EQ(with("vertex_indices", "indices"),
              "a.ply: the element face has no list named vertex_indices");
}

} // namespace
} // namespace trivar
