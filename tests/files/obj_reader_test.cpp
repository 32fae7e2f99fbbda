// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/files/text_models.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string obj_corners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

Mesh mesh_of(const std::string& text)
{
    return *read_text_model(text, ".obj").meshes[0];
}

TEST(ObjReader, ReadsFacesWithoutATextureCoordinateOrNormalThatIsNotThere)
{
    const Mesh expected = mesh_of(obj_corners + "f 1 2 3\nf 1 3 4\n");
    for (const char* faces : {"f 1/1 2/2 3/3\nf 1/1 3/2 4/3\n", "f 1//1 2//2 3//3\nf 1 3//-1 4\n",
                              "f 1/0/0 2/0/0 3/0/0\nf 1/9/9 3 4/999999999/-999999999\n"}) {
        const Model model = read_text_model(obj_corners + faces, ".obj");
        EXPECT_EQ(*model.meshes[0], expected) << faces;
        EXPECT_THAT(model.notices, ElementsAre(HasSubstr("a vt or vn that is not there"))) << faces;
    }
    EXPECT_THAT(read_text_model(obj_corners + "f 1/1 2 3\n\nf 1 3/1/1 4\n", ".obj").notices,
                ElementsAre("a.obj: 2 corners of faces name a vt or vn that is not there and were "
                            "read without it (the first: line 5)"));
}

// The others keep their numbers, so no face gets the coordinate of another.
TEST(ObjReader, ReadsFacesWithoutATextureCoordinateOrNormalThatIsNoNumber)
{
    const Mesh expected = mesh_of(obj_corners + "vt 0.5 0.5\nvn 1 0 0\nf 1 2/1/1 3\n");
    for (const char* bad :
         {"vt nan 0\nvn 0 nan 0\n", "vt 0 inf\nvn 0 0\n", "vt\nvn\n", "vt 1e99\nvn 1 2 x\n"}) {
        const Model model = read_text_model(
            obj_corners + bad + "vt 0.5 0.5\nvn 1 0 0\nf 1/1/1 2/2/2 3/-2/-2\n", ".obj");
        EXPECT_EQ(*model.meshes[0], expected) << bad;
        EXPECT_THAT(model.notices,
                    ElementsAre(HasSubstr("a.obj: 2 normals and texture coordinates were left out; "
                                          "on line 5, a number of vt")))
            << bad;
    }
    EXPECT_EQ(mesh_of(obj_corners + "vt 0.5\nf 1/1 2/1 3/1\n").uvs[0][0], glm::vec2(0.5f, 0));
}

TEST(ObjReader, LeavesOutFacesOfVerticesThatAreNotThereWithAllThatGoesWithThem)
{
    const std::string before = "mtllib none.mtl\n" + obj_corners + "usemtl a\ng one\n",
                      between = "usemtl b\ng two\n";
    const Model expected = read_text_model(before + "f 1 2 3\n" + between + "f 1 3 4\n", ".obj");
    const Model read = read_text_model(
        before + "f 1 2 5\nf 1 2 3\nf 9 9 9\n" + between + "f -5 1 2\nf 1 3 4\nf 1 2 99\n", ".obj");
    EXPECT_EQ(*read.meshes[0], *expected.meshes[0]);
    EXPECT_EQ(read.materials, expected.materials);
    EXPECT_THAT(read.notices.front(),
                "a.obj: 4 faces name vertices that are not there and were left out (the first: "
                "line 8); the file has 4 vertices");
}

TEST(ObjReader, RefusesAFileWhoseFacesAllNameVerticesThatAreNotThere)
{
    EXPECT_EQ(
        refusal_of("v 0 0 0\n\nf 1 2 3\nf 1 3 4\n", ".obj"),
        "a.obj: every face names a vertex that is not there (the first: line 3); the file has "
        "1 vertex");
}

TEST(ObjReader, KeepsCreasesOfFacesWithoutTheirDetailsAndSaysWhichTagsItLeftOut)
{
    const Model model = read_text_model(obj_corners + "f 1/1/1 2/2/2 3/3/3 4/4/4\n"
                                                      "t crease 2/1/0 1 2 4.7\nt corner 1/1/0 7 1\n"
                                                      "t crease 2/1/0 2 3\nt corner 1/1/0 0 2\n",
                                        ".obj");
    const std::vector<Mesh::Crease> expected{{1, 2, 4.7f}, {0, 0, 2}};
    EXPECT_EQ(model.meshes[0]->creases, expected);
    EXPECT_THAT(model.notices[1],
                "a.obj: 2 crease and corner tags were left out; the first, on line 7, names a "
                "vertex that is not there; tags count from 0");
}

TEST(ObjReader, SaysTheLineAndTheWordThatIsWrong)
{
    const auto refused = [](const std::string& text) { return refusal_of(text, ".obj"); };
    EXPECT_EQ(
        refused("v 0 0 0\nv 1 abc 0\n"),
        "a.obj: line 2: the y of a vertex is 'abc', which is not a number from -3.4e38 to 3.4e38");
    EXPECT_EQ(refused("v 0 0 0\nv 1 0\n"), "a.obj: line 2: the z of a vertex is missing");
    EXPECT_EQ(refused("v 1e39 0 0\n"),
              "a.obj: line 1: the x of a vertex is '1e39', which is not a number from -3.4e38 to "
              "3.4e38");
    EXPECT_EQ(refused(obj_corners + "f 1 2 \\\n3\nf 1 2 3/a/1\n"),
              "a.obj: line 7: a face has '3/a/1' where a corner such as 7, 7/8, 7//9 or 7/8/9 "
              "should be");
    EXPECT_EQ(refused(obj_corners + "f 0 1 2\n"),
              "a.obj: line 5: a face names vertex 0, but vertices are counted from 1");
    EXPECT_EQ(refused(obj_corners + "f 1 2\nf 1 1 3\n"),
              "a.obj: none of its faces has three different corners");
}

} // namespace
} // namespace trivar
