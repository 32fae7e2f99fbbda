// SPDX-License-Identifier: GPL-3.0-or-later
// Small files of other programs, and scenes of them, with what is right for each.
#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/export/animated_files.h"
#include "core/files/file_bytes.h"
#include "core/files/gltf/glb_chunks.h"
#include "core/files/read_model.h"
#include "core/files/write_model.h"
#include "core/scene/log.h"
#include "tests/mesh/edges.h"
#include "tests/support/fixtures.h"
#include "tests/support/scenes/commands.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <set>

namespace trivar {
namespace {

using ::testing::Contains, ::testing::ElementsAre, ::testing::HasSubstr;

class RealDataForeignFiles : public ::testing::Test {
protected:
    void SetUp() override
    {
        if (testing::real_data_folder().empty()) GTEST_SKIP() << "no real models are here";
    }
    static std::string file(const std::string& name)
    {
        return testing::real_data_folder() + "/found3/" + name;
    }
    static Document scene(const std::string& name)
    {
        return replay(read_log(read_text_file(file(name)), file(name))).document();
    }
    Evaluation evaluated(const std::string& name) { return Evaluator(assets_)(scene(name)); }
    Mesh first_mesh(const std::string& name)
    {
        const Evaluation all = evaluated(name);
        return *all.objects.at(1)->parts.at(0).mesh();
    }
    std::string written(const std::string& name, FrameRange frames, bool instances,
                        const char* extension)
    {
        const std::string path = folder_.file(std::string("a") + extension);
        write_animated(
            {.document = scene(name), .frames = frames, .log = {}, .instances = instances}, assets_,
            path);
        return path;
    }
    const testing::TemporaryFolder folder_;
    const Ref<AssetStore> assets_ =
        std::make_shared<const AssetStore>(testing::real_data_folder() + "/found3");
};

// The least cosine between the normal of a corner and that of its face.
double along_faces(const Mesh& mesh)
{
    double least = 1;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const glm::dvec3 normal = area_normal(mesh, f);
        if (!(glm::length(normal) > 1e-9)) continue;
        for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c)
            least = std::min(
                least, glm::dot(glm::normalize(normal), glm::dvec3(mesh.normals[mesh.corners[c]])));
    }
    return least;
}

// How many values the places of vertices have along each axis, up to a millimetre.
glm::ivec3 rows(const Part& part)
{
    std::array<std::set<long>, 3> values;
    for (const glm::vec3& p : part.mesh()->positions) {
        const glm::dvec3 at(part.to_world * glm::dvec4(p, 1));
        for (int i = 0; i < 3; ++i)
            values[static_cast<std::size_t>(i)].insert(std::lround(at[i] * 1e3));
    }
    return {values[0].size(), values[1].size(), values[2].size()};
}

TEST_F(RealDataForeignFiles, WithoutNormalsShowTheirEdges)
{
    const Evaluation all = evaluated("01_no_normals.trivar");
    EXPECT_GE(all.objects.size(), 6u);
    for (const auto& [id, object] : all.objects)
        for (const Part& part : object->parts) EXPECT_GT(along_faces(*part.mesh()), 0.999) << id;
}

TEST_F(RealDataForeignFiles, OfOddEndsAreReadOrAnswered)
{
    EXPECT_EQ(read_model(file("08_lfcr.ply")).meshes[0]->face_count(), 1u);
    try {
        read_model(file("10_points.ply"));
        ADD_FAILURE();
    } catch (const Rejected& refusal) {
        EXPECT_THAT(refusal.what(), HasSubstr("it is a point cloud, which is not shown"));
    }
}

TEST_F(RealDataForeignFiles, FarFromTheOriginKeepTheirRows)
{
    const glm::dvec3 size =
        bounding_box(read_model(file("11_two_quads.obj"), {.up = UpAxis::z})).size();
    EXPECT_NEAR(size.x, 0.3, 1e-6);
    EXPECT_NEAR(size.y, 0.5, 1e-6);
    for (const char* name : {"11_grid_double_ply.trivar", "11_grid_utm.trivar",
                             "11_node_far.trivar", "11_node_far_as_is.trivar"}) {
        const Evaluation all = evaluated(name);
        EXPECT_EQ(rows(all.objects.at(1)->parts.at(0)).y, 11) << name;
        EXPECT_EQ(triangles(*all.objects.at(1)->parts.at(0).mesh()).size(), 200u) << name;
    }
    const Evaluation utm = evaluated("utm.trivar");
    EXPECT_EQ(rows(utm.objects.at(1)->parts.at(0)).x, 40);
    EXPECT_EQ(rows(utm.objects.at(1)->parts.at(0)).y, 40);
}

TEST_F(RealDataForeignFiles, AreSimplifiedWithAllOfTheirShapeAndColours)
{
    const Evaluation sphere = evaluated("simplify_duplicates.trivar");
    EXPECT_THAT(sphere.objects.at(1)->notices,
                ElementsAre(HasSubstr("252 faces lay on others with the same corners")));
    EXPECT_EQ(sphere.objects.at(1)->triangles, 320u);
    EXPECT_EQ(testing::count_edges(first_mesh("simplify_duplicates.trivar")).open, 0);
    EXPECT_NEAR(testing::volume(first_mesh("simplify_duplicates.trivar")), 4.1, 0.2);

    const Mesh sheet = first_mesh("27_simplify_colours.trivar");
    EXPECT_GT(std::ranges::count_if(sheet.colors, [](const glm::vec4& c) { return c.x < 0.5f; }),
              3);
}

TEST_F(RealDataForeignFiles, OfCornersOneBitApartAreCutClosed)
{
    for (const char* name : {"47w_1ulp.trivar", "47w_exact.trivar"}) {
        const Evaluation all = evaluated(name);
        EXPECT_TRUE(all.objects.at(1)->notices.empty()) << name;
        write_model(model_of(all, scene(name)), folder_.file("a.stl"));
        EXPECT_EQ(testing::count_edges(*read_model(folder_.file("a.stl")).meshes[0]).open, 0)
            << name;
    }
}

TEST_F(RealDataForeignFiles, CutAlongAFaceGiveNoSkinWithoutThickness)
{
    for (const char* name : {"30_cut_top_face.trivar", "30_cut_top_face_keep_below.trivar"}) {
        const Evaluation all = evaluated(name);
        EXPECT_EQ(all.objects.at(1)->parts.size(), 1u) << name;
        EXPECT_THAT(all.objects.at(1)->notices, ElementsAre(HasSubstr("only touches it")));
    }
    for (const char* name :
         {"30_cut_top_face_keep_above.trivar", "30_cut_bottom_keep_below.trivar"}) {
        const Evaluation all = evaluated(name);
        EXPECT_TRUE(all.objects.at(1)->parts.empty()) << name;
        EXPECT_THAT(all.objects.at(1)->notices, Contains(HasSubstr("keep nothing of it")));
    }
    EXPECT_EQ(evaluated("30_cut_just_above.trivar").objects.at(1)->parts.size(), 1u);
}

TEST_F(RealDataForeignFiles, OfVolumeDataHaveALevelWhereNoneIsNamed)
{
    EXPECT_GT(first_mesh("no_levels.trivar").face_count(), 100u);
}

TEST_F(RealDataForeignFiles, IncisedToAStarOpenAll)
{
    const Evaluation all = evaluated("34_incise_neat_10.trivar");
    EXPECT_EQ(testing::count_edges(*all.objects.at(1)->parts.at(0).mesh()).open, 0);
}

TEST_F(RealDataForeignFiles, OfTrianglesAreCoveredByTilesThatAreLitAsTheyLie)
{
    for (const char* name : {"27_cover_one_triangle.trivar", "cover_triangles.trivar"}) {
        const Evaluation all = evaluated(name);
        for (const Part& part : all.objects.at(2)->parts)
            EXPECT_GT(along_faces(*part.mesh()), 0.8) << name;
    }
}

TEST_F(RealDataForeignFiles, BecomeAnimatedFilesThatOtherProgramsTake)
{
    const std::string usd = read_text_file(written("53_growth_12.trivar", {1, 12}, true, ".usda"));
    const std::size_t first = usd.find("def PointInstancer");
    ASSERT_NE(first, std::string::npos);
    EXPECT_EQ(usd.find("def PointInstancer", first + 1), std::string::npos);

    const auto json = nlohmann::json::parse(
        glb_chunks(read_bytes(written("morph_accessor.trivar", {1, 24}, false, ".glb"), 1 << 24))
            .json);
    std::set<int> in, out;
    for (const auto& animation : json.at("animations"))
        for (const auto& sampler : animation.at("samplers")) {
            in.insert(sampler.at("input").get<int>());
            out.insert(sampler.at("output").get<int>());
        }
    ASSERT_FALSE(in.empty());
    for (const int accessor : in) EXPECT_FALSE(out.contains(accessor));
}

} // namespace
} // namespace trivar
