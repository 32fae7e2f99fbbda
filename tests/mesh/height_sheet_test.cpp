// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/mesh/height_sheet.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

GreyImage stripes()
{
    return {{4, 2}, {0.0f, 0.5f, 1.0f, 0.25f, 0.75f, 0.1f, 0.2f, 0.9f}};
}

TEST(HeightSheet, StandsAsHighAsThePictureIsBright)
{
    const HeightSheet sheet{.size = 2, .height = 3, .level = 0.5, .segments = 8};
    const Mesh mesh = height_sheet(stripes(), sheet);
    ASSERT_EQ(mesh.vertex_count(), 81u);
    ASSERT_EQ(mesh.face_count(), 64u);
    for (const glm::vec3& p : mesh.positions) {
        const glm::dvec2 uv = glm::dvec2(p) / 2.0 + 0.5;
        EXPECT_NEAR(p.z, 3 * (grey_at(stripes(), uv, ImageEdge::repeat) - 0.5), 1e-6);
    }
    for (const glm::vec3& n : mesh.normals) EXPECT_GT(n.z, 0);
}

TEST(HeightSheet, FitsItsCopiesWhereThePictureIsRepeated)
{
    const auto border_off = [](ImageEdge edge) {
        const Mesh mesh = height_sheet(stripes(), {.segments = 10, .edge = edge});
        float off = 0;
        for (int i = 0; i <= 10; ++i)
            for (const auto& [a, b] : {std::pair{i, 110 + i}, {11 * i, 11 * i + 10}})
                off = std::max({off, std::abs(mesh.positions[a].z - mesh.positions[b].z),
                                glm::distance(mesh.normals[a], mesh.normals[b])});
        return off;
    };
    EXPECT_LT(border_off(ImageEdge::repeat), 1e-6f);
    EXPECT_GT(border_off(ImageEdge::stay), 0.01f);
}

TEST(HeightSheet, OfASinglePixelIsLevel)
{
    const Mesh mesh = height_sheet({{1, 1}, {0.5f}}, {.height = 2, .segments = 3});
    for (const glm::vec3& p : mesh.positions) EXPECT_EQ(p.z, 1);
    for (const glm::vec3& n : mesh.normals) EXPECT_EQ(n, glm::vec3(0, 0, 1));
    EXPECT_THROW(height_sheet({}, {}), Rejected);
}

} // namespace
} // namespace trivar
