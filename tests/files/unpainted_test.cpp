// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/read_model.h"
#include "core/mesh/model.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

Material material_of(const std::string& text, const std::string& name)
{
    const Model model = read_model_bytes(text, name, "");
    EXPECT_EQ(model.materials.size(), 1u) << name;
    return model.materials.at(0);
}

const std::string off_faces = "3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", obj_face = "f 1 2 3\n",
                  stl = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                        "vertex 0 1 0\nendloop\nendfacet\nendsolid a\n",
                  ply_head = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                             "property float y\nproperty float z\n",
                  ply_rest = "element face 1\nproperty list uchar int vertex_indices\n"
                             "end_header\n";

// White would be all white in the light of the studio.
TEST(Unpainted, IsWhatAFileGetsThatDescribesNoMaterial)
{
    EXPECT_LT(unpainted().base_color.r, 0.5f);
    EXPECT_EQ(material_of("v 0 0 0\nv 1 0 0\nv 0 1 0\n" + obj_face, "a.obj"), unpainted());
    EXPECT_EQ(material_of("OFF\n" + off_faces, "a.off"), unpainted());
    EXPECT_EQ(material_of(stl, "a.stl"), unpainted());
    EXPECT_EQ(material_of(ply_head + ply_rest + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "a.ply"),
              unpainted());
}

TEST(Unpainted, LeavesColoursOfVerticesAsTheyAre)
{
    EXPECT_EQ(material_of("v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 0 1 0 1 0 0\n" + obj_face, "a.obj"),
              Material());
    EXPECT_EQ(material_of(ply_head +
                              "property uchar red\nproperty uchar green\n"
                              "property uchar blue\n" +
                              ply_rest + "0 0 0 255 0 0\n1 0 0 255 0 0\n0 1 0 255 0 0\n3 0 1 2\n",
                          "a.ply"),
              Material());
}

} // namespace
} // namespace trivar
