// SPDX-License-Identifier: GPL-3.0-or-later
// What a refined mesh keeps of the one it came from.
#include "tests/mesh/edges.h"
#include "tests/refinement/bent.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;

// In the unit cube: hard edges as seams, which `points` closes.
Mesh box_with_seams()
{
    Mesh mesh = box_mesh({1, 1, 1}, {2, 2, 2});
    for (glm::vec3& p : mesh.positions) p += 0.5f;
    if (mesh.points.empty()) mesh.points = points_by_position(mesh.positions);
    return mesh;
}

TEST(RefinedMeshes, KeepSeamsAndHardEdgesClosed)
{
    const Mesh box = box_with_seams();
    ASSERT_GT(box.vertex_count(), point_count(box));
    const RefinementResult out = refine_one(box, one_cell(4, bend), {.tolerance_world = 0.003});
    const Mesh& mesh = *out.parts[0].mesh;
    EXPECT_NO_THROW(validate(mesh, "refined"));
    const EdgeCount edges = count_edges(mesh);
    EXPECT_EQ(edges.open + edges.crowded + edges.against, 0);
    // Every vertex has the normal of its side, and copies of a point stand at the same bits.
    std::vector<glm::vec3> position(point_count(mesh), glm::vec3(-1));
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        glm::vec3& known = position[mesh.points[v]];
        EXPECT_TRUE(known == glm::vec3(-1) || known == mesh.positions[v]);
        known = mesh.positions[v];
        const glm::vec3 n = glm::abs(mesh.normals[v]);
        EXPECT_EQ(std::max({n.x, n.y, n.z}), 1);
    }
}

TEST(RefinedMeshes, CarryWhatVerticesHaveLinearly)
{
    Mesh mesh = unit_cube();
    mesh.uvs.resize(1);
    mesh.morph_targets.resize(1);
    for (const glm::vec3& p : mesh.positions) {
        mesh.colors.emplace_back(p, 1);
        mesh.uvs[0].emplace_back(p.x + p.z, p.y);
        mesh.morph_targets[0].positions.push_back(2.0f * p);
        mesh.influences.push_back({{0, 1, 0, 0}, {1 - p.x, p.x, 0, 0}});
        mesh.tangents.emplace_back(1, 0, 0, -1);
        mesh.normals.emplace_back(0, 0, 1);
    }
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        mesh.face_material.push_back(static_cast<std::uint32_t>(f / 6));
        mesh.face_group.push_back(static_cast<std::uint32_t>(f % 2));
    }
    mesh.group_names = {"even", "odd"};
    const RefinementResult refined =
        refine_one(mesh, one_cell(4, twist), {.tolerance_world = 0.01});
    const Mesh& out = *refined.parts[0].mesh;
    ASSERT_GT(out.vertex_count(), 50u);
    for (std::size_t v = 0; v < out.vertex_count(); ++v) {
        const glm::vec3 p = out.positions[v];
        const auto near = [](const auto& a, const auto& b) { return glm::distance(a, b) < 2e-6f; };
        EXPECT_TRUE(near(out.colors[v], glm::vec4(p, 1)));
        EXPECT_TRUE(near(out.uvs[0][v], glm::vec2(p.x + p.z, p.y)));
        EXPECT_TRUE(near(out.morph_targets[0].positions[v], 2.0f * p));
        EXPECT_EQ(out.tangents[v], glm::vec4(1, 0, 0, -1));
        const Mesh::Influences& i = out.influences[v];
        float of_1 = 0;
        for (int n = 0; n < 4; ++n)
            if (i.joints[static_cast<std::size_t>(n)] == 1) of_1 += i.weights[n];
        EXPECT_NEAR(of_1, p.x, 2e-6);
    }
    // Each side keeps its material.
    ASSERT_EQ(out.face_material.size(), out.face_count());
    ASSERT_EQ(out.face_group.size(), out.face_count());
    std::array<double, 2> area{};
    for (std::size_t f = 0; f < out.face_count(); ++f)
        area[out.face_material[f]] += glm::length(area_normal(out, f)) / 2;
    EXPECT_NEAR(area[0], 3, 1e-5);
    EXPECT_NEAR(area[1], 3, 1e-5);
}

// Two meshes that meet along a boundary: what one splits there the other splits too.
TEST(RefinedMeshes, OfSeveralPartsMeetAtTheirBoundaries)
{
    const Mesh cube = unit_cube();
    Mesh lower, upper;
    lower.positions = upper.positions = cube.positions;
    for (std::size_t f = 0; f < cube.face_count(); ++f)
        add_face(f % 3 == 0 ? lower : upper,
                 std::span(cube.corners).subspan(cube.face_begin[f], 3));
    const Lattice lattice = one_cell(4, bend);
    const RefinementResult out = refine({{make_ref(without_loose_vertices(lower)), {}},
                                         {make_ref(without_loose_vertices(upper)), {}}},
                                        lattice, {.tolerance_world = 0.004});
    Mesh both = *out.parts[0].mesh;
    const Mesh& other = *out.parts[1].mesh;
    for (std::size_t f = 0; f < other.face_count(); ++f) {
        std::array<std::uint32_t, 3> corners;
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = static_cast<std::uint32_t>(other.corners[other.face_begin[f] + i] +
                                                    both.vertex_count());
        add_face(both, corners);
    }
    both.positions.insert(both.positions.end(), other.positions.begin(), other.positions.end());
    both.points = points_by_position(both.positions);
    const EdgeCount edges = count_edges(both);
    EXPECT_EQ(edges.open + edges.crowded + edges.against, 0);
    // And the same as if it had been one mesh.
    EXPECT_EQ(out.triangles(), refine_one(cube, lattice, {.tolerance_world = 0.004}).triangles());
}

TEST(RefinedMeshes, GoRoundClosedVolumes)
{
    const Knots across = Knots::uniform(3, 4);
    for (const Closure closure : {Closure::periodic, Closure::twisted}) {
        const Lattice lattice{
            random_volume({Knots::periodic(4, 10, 0, 1, closure), across, across}, 3, 0.2),
            glm::dmat4(1)};
        Mesh mesh = unit_cube();
        for (glm::vec3& p : mesh.positions) p.x = p.x * 1.7f - 0.4f; // more than once round
        const RefinementResult out = refine_one(mesh, lattice, {.tolerance_world = 0.02});
        EXPECT_LE(out.bound, 0.02);
        EXPECT_LE(drawn_error(*out.parts[0].mesh, {}, lattice), out.bound);
    }
}

} // namespace
} // namespace trivar
