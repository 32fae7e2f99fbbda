// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/filling_colors.h"

#include "core/base/parallel.h"
#include "core/mesh/primitives.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace trivar {
namespace {

std::vector<Material> plain_and(Filling filling)
{
    std::vector<Material> out(2);
    out[1].filling = filling;
    out[1].base_color = {0.4f, 0.8f, 0.8f, 1};
    return out;
}

// A sheet of so many squares, which the second material fills where x > 0.
Mesh half_filled(int squares)
{
    Mesh mesh = plane_mesh({2, 2}, {squares, squares});
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        mesh.face_material.push_back(
            mesh.positions[mesh.corners[mesh.face_begin[f]]].x +
                        mesh.positions[mesh.corners[mesh.face_begin[f] + 2]].x >
                    0
                ? 1
                : 0);
    return mesh;
}

float spread(const Mesh& mesh, const std::vector<glm::vec4>& colors)
{
    float low = 1, high = 0;
    for (std::size_t v = 0; v < colors.size(); ++v)
        if (mesh.positions[v].x > 1e-3f) {
            low = std::min(low, colors[v].g);
            high = std::max(high, colors[v].g);
        }
    return high - low;
}

TEST(FillingColors, ArePatternsWhereFacesAreFilledAndWhiteElsewhere)
{
    const Mesh fine = half_filled(64), coarse = half_filled(4);
    for (const Filling filling : {Filling::wood, Filling::flesh, Filling::metal}) {
        const std::vector<Material> materials = plain_and(filling);
        const Box box = bounding_box(fine);
        const std::vector<glm::vec4> colors = filling_colors(fine, fine, box, materials);
        ASSERT_EQ(colors.size(), fine.vertex_count());
        for (std::size_t v = 0; v < colors.size(); ++v)
            if (fine.positions[v].x < 1e-3f) // whoever has a plain face too is plain
                EXPECT_EQ(colors[v], glm::vec4(1));
            else
                EXPECT_NE(colors[v], glm::vec4(1));
        EXPECT_GT(spread(fine, colors), 0.05f);
        EXPECT_LT(spread(coarse, filling_colors(coarse, coarse, box, materials)),
                  spread(fine, colors));
        const Material shown = without_filling(materials[1]);
        EXPECT_EQ(shown.filling, Filling::none);
        EXPECT_EQ(shown.base_color, glm::vec4(1));
        EXPECT_EQ(shown.metallic > 0.5f, filling == Filling::metal);
    }
}

TEST(FillingColors, FollowWhereThingsWereBefore)
{
    const Mesh rest = half_filled(16);
    Mesh moved = rest;
    for (glm::vec3& p : moved.positions) p = p * 3.0f + glm::vec3(p.y, 1, p.x * p.x);
    const std::vector<Material> materials = plain_and(Filling::wood);
    const Box box = bounding_box(rest);
    EXPECT_EQ(filling_colors(moved, rest, box, materials),
              filling_colors(rest, rest, box, materials));
}

TEST(FillingColors, TintColoursAndAreNoneWithoutAPattern)
{
    Mesh mesh = half_filled(16);
    const Box box = bounding_box(mesh);
    EXPECT_TRUE(filling_colors(mesh, mesh, box, plain_and(Filling::none)).empty());
    std::vector<Material> materials = plain_and(Filling::wood);
    const std::vector<glm::vec4> half = filling_colors(mesh, mesh, box, materials);
    materials[1].base_color = {0.8f, 0.8f, 0.8f, 1};
    const std::vector<glm::vec4> whole = filling_colors(mesh, mesh, box, materials);
    mesh.colors.assign(mesh.vertex_count(), {1, 1, 0, 0.5f});
    const std::vector<glm::vec4> tinted = filling_colors(mesh, mesh, box, materials);
    for (std::size_t v = 0; v < whole.size(); ++v) {
        if (mesh.positions[v].x < 1e-3f) continue;
        EXPECT_FLOAT_EQ(half[v].r, whole[v].r / 2);
        EXPECT_EQ(tinted[v], glm::vec4(whole[v].r, whole[v].g, 0, 0.5f));
    }
}

TEST(FillingColors, OfMetalGoRoundTheAxisOfWhatMayBeTurned)
{
    const auto axis_of = [](const glm::dvec3& size) {
        Box box;
        box.add(glm::dvec3(1, 2, 3));
        box.add(glm::dvec3(1, 2, 3) + size);
        return turning_axis(box);
    };
    EXPECT_EQ(axis_of({2, 0.3, 2.01}), 1); // a wheel
    EXPECT_EQ(axis_of({5, 1, 1}), 0);      // a shaft
    EXPECT_EQ(axis_of({1, 1, 1}), 2);
    EXPECT_EQ(axis_of({1, 1.01, 1}), 2);
    EXPECT_EQ(axis_of({0, 0, 0}), 2);
}

TEST(FillingColors, AreTheSameForAnyNumberOfThreads)
{
    const Mesh mesh = half_filled(80);
    const std::vector<Material> materials = plain_and(Filling::metal);
    const auto made = [&] { return filling_colors(mesh, mesh, bounding_box(mesh), materials); };
    const std::vector<glm::vec4> any = made();
    const ThreadLimit one(1);
    EXPECT_EQ(made(), any);
}

} // namespace
} // namespace trivar
