// SPDX-License-Identifier: GPL-3.0-or-later
// What Trivar writes is read by OpenMesh, which shares no line with it.
#include "core/files/write_model.h"
#include "tests/files/sample_models.h"
#include "tests/support/fixtures.h"

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;

class OtherReader : public ::testing::TestWithParam<const char*> {};

TEST_P(OtherReader, FindsTheSameClosedSurface)
{
    const TemporaryFolder folder;
    const std::string path = folder.file(std::string("box") + GetParam());
    Mesh box = box_mesh({1, 2, 3}, {2, 3, 4});
    const bool keeps_points = std::string(GetParam()) != ".ply";
    const std::size_t points = keeps_points ? point_count(box) : box.vertex_count();
    const std::size_t faces =
        std::string(GetParam()) == ".stl" ? triangles(box).size() : box.face_count();
    write_model(single_mesh_model("box", std::move(box)), path);
    OpenMesh::PolyMesh_ArrayKernelT<> mesh;
    ASSERT_TRUE(OpenMesh::IO::read_mesh(mesh, path));
    EXPECT_EQ(mesh.n_vertices(), points);
    EXPECT_EQ(mesh.n_faces(), faces);
    if (!keeps_points) return;
    for (const auto vertex : mesh.vertices()) EXPECT_FALSE(mesh.is_boundary(vertex));
}
INSTANTIATE_TEST_SUITE_P(Formats, OtherReader, ::testing::Values(".obj", ".ply", ".stl", ".off"));

} // namespace
} // namespace trivar
