// SPDX-License-Identifier: GPL-3.0-or-later
// Files without normals: what shows as an edge, and what they are when they are written again.
#include "core/files/formats.h"
#include "core/files/write_model.h"
#include "core/mesh/primitives.h"
#include "tests/files/text_models.h"
#include "tests/support/fixtures.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace trivar {
namespace {

using namespace testing;

TextModel cube()
{
    return {{"0 0 0", "1 0 0", "1 1 0", "0 1 0", "0 0 1", "1 0 1", "1 1 1", "0 1 1"},
            {{3, 2, 1},
             {3, 1, 0},
             {4, 5, 6},
             {4, 6, 7},
             {0, 1, 5},
             {0, 5, 4},
             {1, 2, 6},
             {1, 6, 5},
             {2, 3, 7},
             {2, 7, 6},
             {3, 0, 4},
             {3, 4, 7}}};
}

// A round with 24 sides, and caps of triangles.
TextModel cylinder()
{
    TextModel out{{"0 0 0", "0 0 1"}, {}};
    const int sides = 24;
    for (int i = 0; i < sides; ++i) {
        const double a = 2 * std::numbers::pi * i / sides;
        for (const int z : {0, 1})
            out.vertices.push_back(fmt::format("{:.7f} {:.7f} {}", std::cos(a), std::sin(a), z));
        const int here = 2 + 2 * i, next = 2 + 2 * ((i + 1) % sides);
        out.faces.push_back({0, next, here});
        out.faces.push_back({1, here + 1, next + 1});
        out.faces.push_back({here, next, next + 1});
        out.faces.push_back({here, next + 1, here + 1});
    }
    return out;
}

// The greatest angle in degrees between a corner's normal and that of its face.
double off_the_faces(const Mesh& mesh)
{
    double least = 1;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c)
            least = std::min(least, glm::dot(glm::normalize(area_normal(mesh, f)),
                                             glm::dvec3(mesh.normals[mesh.corners[c]])));
    return glm::degrees(std::acos(std::clamp(least, -1.0, 1.0)));
}

double off_the_faces(const std::string& text, const std::string& extension)
{
    return off_the_faces(*read_text_model(text, extension).meshes.at(0));
}

std::string glb_without_normals(const TextModel& model)
{
    Model out = read_text_model(ply_text(model), ".ply");
    Mesh bare;
    bare.positions = out.meshes[0]->positions;
    bare.corners = out.meshes[0]->corners;
    bare.face_begin = out.meshes[0]->face_begin;
    out.meshes[0] = make_ref(std::move(bare));
    return write_glb(out);
}

TEST(MissingNormals, OfACubeAreThoseOfItsFacesInEveryFormat)
{
    for (const std::string extension : {".stl", ".obj", ".ply", ".off"})
        EXPECT_LT(off_the_faces(text_of(cube(), extension), extension), 0.05) << extension;
    EXPECT_LT(off_the_faces(glb_without_normals(cube()), ".glb"), 0.05);
}

TEST(MissingNormals, OfStlAndGltfAreFacetsAndRoundOtherwise)
{
    EXPECT_LT(off_the_faces(stl_text(cylinder()), ".stl"), 0.05);
    EXPECT_LT(off_the_faces(glb_without_normals(cylinder()), ".glb"), 0.05);
    // Half of the turn of 15 degrees from side to side, weighted by the halves of one.
    for (const std::string extension : {".obj", ".ply", ".off"}) {
        EXPECT_GT(off_the_faces(text_of(cylinder(), extension), extension), 4) << extension;
        EXPECT_LT(off_the_faces(text_of(cylinder(), extension), extension), 11) << extension;
    }
}

TEST(MissingNormals, OfAnObjFollowItsSmoothingGroups)
{
    const std::string text = obj_text(cube());
    for (const std::string flat : {"s off\n", "s 0\n"})
        EXPECT_LT(off_the_faces(flat + obj_text(cylinder()), ".obj"), 0.05) << flat;
    // One group over all: as a pillow, since the file says so.
    const Mesh pillow = *read_text_model("s 1\n" + text, ".obj").meshes[0];
    EXPECT_EQ(pillow.vertex_count(), 8u);
    EXPECT_GT(off_the_faces(pillow), 30);
    // The top and the bottom have none; the sides are round.
    std::string parted = text;
    std::size_t at = 0;
    for (int faces = 0; faces < 4; ++faces) at = parted.find("\nf ", at + 1);
    parted.insert(parted.find("\nf ", at + 1) + 1, "s 3\n");
    const Mesh sides = *read_text_model(parted, ".obj").meshes[0];
    for (std::size_t f = 0; f < sides.face_count(); ++f)
        for (std::uint32_t c = sides.face_begin[f]; c < sides.face_begin[f + 1]; ++c)
            EXPECT_NEAR(std::abs(sides.normals[sides.corners[c]].y), f < 4 ? 1 : 0, 1e-6);
}

TEST(MissingNormals, LeaveWhatIsClosedClosedAndItsPointsOnce)
{
    for (const std::string extension : {".stl", ".obj", ".ply", ".off"}) {
        const Mesh mesh = *read_text_model(text_of(cube(), extension), extension).meshes[0];
        EXPECT_EQ(point_count(mesh), 8u) << extension;
        EXPECT_EQ(mesh.vertex_count(), 24u) << extension;
    }
}

TEST(MissingNormals, AreWrittenAsTheyAreShownAndFilesWithoutThemHaveEachPointOnce)
{
    const Model read = read_text_model(stl_text(cube()), ".stl");
    const TemporaryFolder folder;
    for (const std::string name : {"a.glb", "a.obj", "a.ply"}) {
        write_model(read, folder.file(name));
        const Model again = read_model(folder.file(name));
        EXPECT_LT(off_the_faces(*again.meshes.at(0)), 0.05) << name;
    }
    EXPECT_EQ(write_off(read).substr(0, 11), "OFF\n8 12 0\n");
}

TEST(MissingNormals, AreNotThereWhereTheVerticesOfTheFileAreAskedFor)
{
    const Model read = read_model_bytes(stl_text(cube()), "a.stl", "", {.normals_of_faces = false});
    EXPECT_EQ(read.meshes[0]->vertex_count(), 8u);
}

} // namespace
} // namespace trivar
