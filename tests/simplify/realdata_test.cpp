// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/read_model.h"
#include "tests/mesh/edges.h"
#include "tests/simplify/meshes.h"
#include "tests/support/fixtures.h"

#include <gtest/gtest.h>

namespace trivar::testing {
namespace {

class RealDataSimplify : public ::testing::TestWithParam<const char*> {
protected:
    void SetUp() override
    {
        if (real_data_folder().empty()) GTEST_SKIP() << "no folder of real models";
        mesh = read_model(real_data_folder() + "/meshes/" + GetParam()).meshes.front();
        triangles = trivar::triangles(*mesh).size();
        size = glm::length(bounding_box(*mesh).size());
    }
    Ref<Mesh> mesh;
    std::size_t triangles = 0;
    double size = 0;
};

} // namespace

TEST_P(RealDataSimplify, ATenthIsAsNearAsItsErrorSays)
{
    const SimplifiedMesh out =
        simplified(mesh, {.triangles = triangles / 10, .error = {}, .poses = {}, .measured = true});
    RecordProperty("triangles", static_cast<int>(out.triangles));
    RecordProperty("error_by_size", std::to_string(out.error / size));
    EXPECT_LE(out.triangles, triangles / 10);
    EXPECT_LE(out.error, 0.02 * size);
    EXPECT_LE(sampled_distance(*mesh, *out.mesh, 0), out.error);
    EXPECT_LE(sampled_distance(*out.mesh, *mesh, 4), out.error);
}

TEST_P(RealDataSimplify, OfAThousandthOfTheSizeIsNoFurtherAndClosedWhereItWas)
{
    const double error = 0.001 * size;
    const SimplifiedMesh out = simplified(mesh, {.triangles = {}, .error = error, .poses = {}});
    RecordProperty("triangles", static_cast<int>(out.triangles));
    EXPECT_LT(out.triangles, triangles);
    EXPECT_LE(sampled_distance(*mesh, *out.mesh, 0), error);
    EXPECT_LE(sampled_distance(*out.mesh, *mesh, 4), error);
    const EdgeCount before = count_edges(*mesh), after = count_edges(*out.mesh);
    EXPECT_TRUE(before.open + before.crowded > 0 || after.open + after.crowded == 0);
}

// Its patches have vertices of their own along the seams between them.
TEST(RealDataTeapot, HasNoSlitsAtATenthOfItsTriangles)
{
    if (real_data_folder().empty()) GTEST_SKIP() << "no folder of real models";
    const Ref<Mesh> pot = read_model(real_data_folder() + "/meshes/teapot.obj").meshes.front();
    const std::size_t triangles = trivar::triangles(*pot).size();
    const auto joined = [](Mesh mesh) {
        mesh.points = points_by_position(mesh.positions);
        return count_edges(mesh);
    };
    const SimplifiedMesh less = to_number(*pot, triangles / 10);
    EXPECT_LE(less.triangles, triangles / 5);
    EXPECT_LE(joined(*less.mesh).open, joined(*pot).open);
    EXPECT_EQ(joined(*less.mesh).crowded, 0);
    EXPECT_LE(sampled_distance(*less.mesh, *pot, 4), 0.03 * glm::length(bounding_box(*pot).size()));
}

INSTANTIATE_TEST_SUITE_P(RealData, RealDataSimplify, ::testing::Values("fandisk.obj", "spot.obj"));

} // namespace trivar::testing
