// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/read_model.h"
#include "core/mesh/subdivide.h"
#include "tests/support/fixtures.h"

#include <filesystem>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using testing::real_data_folder;

TEST(Cages, CarryTheirCreasesInTheObj)
{
    const Model model = read_model_bytes("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"
                                         "t crease 2/1/0 1 2 4.5\nt corner 1/1/0 3 10\n",
                                         "a.obj", "");
    const std::vector<Mesh::Crease> expected{{1, 2, 4.5f}, {3, 3, 10}};
    EXPECT_EQ(model.meshes[0]->creases, expected);
}

// Pixar's regression shapes and Spot's cage.
TEST(RealDataCages, SubdivideToSoundSurfacesInsideTheirCage)
{
    const std::string folder = real_data_folder();
    if (folder.empty()) GTEST_SKIP() << "no folder of real data";
    int tried = 0;
    for (const auto& entry : std::filesystem::directory_iterator(folder + "/cages")) {
        if (entry.path().extension() != ".obj") continue;
        SCOPED_TRACE(entry.path().filename().string());
        const Mesh cage = *read_model(entry.path().string()).meshes.at(0);
        const Mesh mesh = subdivide(cage, 2);
        EXPECT_NO_THROW(validate(mesh, "subdivided"));
        EXPECT_EQ(mesh.face_count(), cage.corners.size() * 4);
        EXPECT_EQ(mesh.uvs.size(), cage.uvs.size());
        // Every limit point is a convex combination of the cage's points.
        const Box inner = bounding_box(mesh), outer = bounding_box(cage);
        for (int i = 0; i < 3; ++i) {
            EXPECT_GE(inner.lo[i], outer.lo[i] - 1e-5);
            EXPECT_LE(inner.hi[i], outer.hi[i] + 1e-5);
        }
        for (const glm::vec3& n : mesh.normals) EXPECT_NEAR(glm::length(n), 1, 1e-4);
        ++tried;
    }
    EXPECT_EQ(tried, 7);
}

} // namespace
} // namespace trivar
