// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/mesh/primitives.h"
#include "tests/incise/bodies.h"
#include "tests/incise/cuts.h"

#include <gtest/gtest.h>
#include <map>
#include <set>

namespace trivar::testing {
namespace {

// A sphere with everything that a mesh may have.
Mesh rich_sphere()
{
    Mesh mesh = transformed(sphere_mesh(1, 48, 24), // turned half round: the seam lies behind
                            glm::dmat4({-1, 0, 0, 0}, {0, -1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}));
    mesh.points = points_by_position(mesh.positions);
    Mesh::MorphTarget target;
    for (const glm::vec3& p : mesh.positions) {
        mesh.colors.emplace_back(0.5f + 0.5f * p, 1.0f);
        const float share = 0.5f + 0.5f * p.z;
        mesh.influences.push_back({{0, 1, 0, 0}, {share, 1 - share, 0, 0}});
        target.positions.push_back(0.1f * p);
        target.normals.emplace_back(0);
    }
    mesh.morph_targets = {target};
    mesh.face_material.assign(mesh.face_count(), 3);
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const std::uint32_t* const corner = mesh.corners.data() + mesh.face_begin[f];
        mesh.creases.push_back({corner[0], corner[1], 2});
    }
    return mesh;
}

class RichSphere : public ::testing::Test {
protected:
    SlitSkin skin = skin_of(rich_sphere());
    const Mesh& before = *skin.mesh();
};

TEST_F(RichSphere, EveryArrayIsAsLongAsTheVerticesAndValid)
{
    const IncisedMesh made = incise(skin, crossing_cuts_on_sphere());
    const Mesh& mesh = *made.rest;
    validate(mesh, "cut");
    const std::size_t count = mesh.vertex_count();
    EXPECT_GT(count, before.vertex_count());
    EXPECT_EQ(mesh.normals.size(), count);
    EXPECT_EQ(mesh.colors.size(), count);
    EXPECT_EQ(mesh.points.size(), count);
    EXPECT_EQ(mesh.influences.size(), count);
    EXPECT_EQ(mesh.uvs[0].size(), count);
    EXPECT_EQ(mesh.morph_targets[0].positions.size(), count);
    EXPECT_EQ(mesh.morph_targets[0].normals.size(), count);
    EXPECT_EQ(mesh.face_material.size(), mesh.face_count());
}

TEST_F(RichSphere, NewVerticesOfTheSkinAreMeansOfItsAttributes)
{
    const IncisedMesh made = incise(skin, crossing_cuts_on_sphere());
    const Mesh& mesh = *made.rest;
    for (std::size_t v = before.vertex_count(); v < made.first_wall_vertex; ++v) {
        const glm::vec3 p = mesh.positions[v];
        EXPECT_LT(glm::distance(glm::vec3(mesh.colors[v]), 0.5f + 0.5f * p), 1e-5f);
        EXPECT_NEAR(mesh.influences[v].weights[0] + mesh.influences[v].weights[1], 1, 1e-5f);
        EXPECT_LT(glm::distance(mesh.morph_targets[0].positions[v], 0.1f * p), 1e-5f);
        EXPECT_GT(glm::dot(mesh.normals[v], p), 0.99f);
        EXPECT_NEAR(glm::length(mesh.normals[v]), 1, 1e-5f);
    }
}

// The pairs of vertices at which a point of the skin has several texture coordinates.
std::size_t seam_points(const Mesh& mesh, std::size_t vertices)
{
    std::map<std::uint32_t, std::vector<glm::vec2>> seen;
    std::size_t seams = 0;
    for (std::size_t v = 0; v < vertices; ++v) {
        std::vector<glm::vec2>& uvs = seen[mesh.point(static_cast<std::uint32_t>(v))];
        seams += !uvs.empty() && uvs.front() != mesh.uvs[0][v];
        uvs.push_back(mesh.uvs[0][v]);
    }
    return seams;
}

TEST_F(RichSphere, NoSeamIsMadeInTheSkin)
{
    const IncisedMesh made = incise(skin, crossing_cuts_on_sphere()); // away from the seam
    EXPECT_EQ(seam_points(*made.rest, made.first_wall_vertex),
              seam_points(before, before.vertex_count()));
}

TEST_F(RichSphere, ACutOverASeamKeepsItAndStaysClosed)
{
    // Where the texture begins again
    glm::dvec3 seam(0);
    std::map<std::uint32_t, glm::vec2> seen;
    for (std::uint32_t v = 0; v < before.vertex_count(); ++v) {
        const auto [known, fresh] = seen.emplace(before.point(v), before.uvs[0][v]);
        if (!fresh && known->second != before.uvs[0][v] && std::abs(before.positions[v].z) < 0.05f)
            seam = before.positions[v];
    }
    ASSERT_GT(glm::length(seam), 0.5);
    const glm::dvec3 across = glm::cross(glm::dvec3(0, 0, 1), seam);
    const IncisedMesh made = incise(
        skin,
        std::vector{cut_on_sphere({seam - 0.3 * across, seam + 0.3 * across}),
                    cut_on_sphere({seam - glm::dvec3(0, 0, 0.3), seam + glm::dvec3(0, 0, 0.3)})});
    EXPECT_EQ(made.outcomes[0].refusal + made.outcomes[1].refusal, "");
    // Every corner of the skin has texture coordinates near those of its face
    const Mesh& mesh = *made.rest;
    for (std::size_t f = 0; f < made.first_wall_face; ++f)
        for (std::uint32_t c = mesh.face_begin[f] + 1; c < mesh.face_begin[f + 1]; ++c)
            EXPECT_LT(glm::distance(mesh.uvs[0][mesh.corners[c]],
                                    mesh.uvs[0][mesh.corners[mesh.face_begin[f]]]),
                      0.2f);
}

TEST_F(RichSphere, EdgesThatStayWholeKeepTheirCrease)
{
    const IncisedMesh made = incise(skin, crossing_cuts_on_sphere());
    const Mesh& mesh = *made.rest;
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (std::size_t f = 0; f < made.first_wall_face; ++f)
        for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
            const std::uint32_t next = c + 1 < mesh.face_begin[f + 1] ? c + 1 : mesh.face_begin[f];
            edges.insert(std::minmax(mesh.point(mesh.corners[c]), mesh.point(mesh.corners[next])));
        }
    for (const Mesh::Crease& crease : mesh.creases)
        EXPECT_TRUE(edges.contains(std::minmax(mesh.point(crease.a), mesh.point(crease.b))));
    EXPECT_LT(mesh.creases.size(), before.creases.size());
    EXPECT_GT(mesh.creases.size(), before.creases.size() / 2);
}

TEST_F(RichSphere, IsTheSameInTheMemoryOfAnother)
{
    RefPool<Mesh> meshes;
    incise(skin_of(icosphere(3)), crossing_cuts_on_sphere(), {}, meshes);
    EXPECT_EQ(*incise(skin, crossing_cuts_on_sphere(), {}, meshes).rest,
              *incise(skin, crossing_cuts_on_sphere()).rest);
}

TEST_F(RichSphere, WallsHaveTheMaterialOfTheirLayer)
{
    InciseOptions options;
    options.layers = {{0.02, 7}, {0.05, 8}, {1, 9}};
    const IncisedMesh made = incise(skin, crossing_cuts_on_sphere(), options);
    const Mesh& mesh = *made.rest;
    std::size_t straddle = 0;
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        if (f < made.first_wall_face) {
            EXPECT_EQ(mesh.face_material[f], 3u);
            continue;
        }
        const std::uint32_t material = mesh.face_material[f];
        const std::array<double, 4> borders{0, 0.02, 0.05, 0.2};
        for (std::uint32_t c = mesh.face_begin[f]; c < mesh.face_begin[f + 1]; ++c) {
            const double depth = mesh.uvs[0][mesh.corners[c]].y;
            straddle +=
                depth < borders[material - 7] - 1e-4 || depth > borders[material - 6] + 1e-4;
        }
    }
    EXPECT_LT(straddle, (mesh.face_count() - made.first_wall_face) / 10); // beside the ends
}

TEST_F(RichSphere, WallsHaveTheirLengthAndDepthAsTextureCoordinates)
{
    const std::vector<Incision> cuts{crossing_cuts_on_sphere()[0]};
    const IncisedMesh made = incise(skin, cuts);
    const Mesh& mesh = *made.rest;
    for (std::size_t v = made.first_wall_vertex; v < mesh.vertex_count(); ++v) {
        const glm::vec2 uv = mesh.uvs[0][v];
        EXPECT_GE(uv.x, 0);
        EXPECT_LE(uv.x, made.outcomes[0].length + 1e-5);
        EXPECT_NEAR(glm::length(mesh.positions[v]), 1 - uv.y, 0.01);
        EXPECT_EQ(mesh.colors[v], glm::vec4(1));
    }
}

TEST_F(RichSphere, NormalsOfWallsLookIntoTheGap)
{
    const std::vector<Incision> cuts{cut_on_sphere({{1, -0.4, 0.003}, {1, 0.4, 0.002}})};
    const IncisedMesh made = incise(skin, cuts);
    const Ref<Mesh> open = opened(made, std::vector<IncisionOpening>(1));
    for (std::size_t v = made.first_wall_vertex; v < open->vertex_count(); ++v) {
        const glm::vec3 p = open->positions[v], n = open->normals[v];
        EXPECT_NEAR(glm::length(n), 1, 1e-4f);
        if (std::abs(p.z) > 0.01f && std::abs(p.y) < 0.2f) {
            EXPECT_LT(n.z * p.z, 0);
        }
    }
}

} // namespace
} // namespace trivar::testing
