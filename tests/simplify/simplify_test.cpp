// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/mesh/shading.h"
#include "tests/mesh/edges.h"
#include "tests/simplify/meshes.h"

#include <gtest/gtest.h>

namespace trivar::testing {
namespace {

int euler(const Mesh& mesh)
{
    const EdgeCount count = count_edges(mesh);
    return count.points - count.edges + static_cast<int>(mesh.face_count());
}

} // namespace

TEST(Simplify, ReachesTheNumberOfTriangles)
{
    const Mesh torus = bumpy_torus({60, 30});
    for (const std::size_t n : {3000, 1001, 200}) {
        const SimplifiedMesh less = to_number(torus, n);
        EXPECT_LE(less.triangles, n);
        EXPECT_GE(less.triangles, n - 2);
        EXPECT_EQ(less.triangles, triangles(*less.mesh).size());
        EXPECT_EQ(less.triangles_before, 3600u);
    }
}

TEST(Simplify, GivesBackTheMeshThatNothingIsToBeDoneTo)
{
    const Ref<Mesh> torus = make_ref(torus_mesh(2, 0.7, {20, 10}));
    EXPECT_EQ(simplified(torus, {}).mesh, torus);
    EXPECT_EQ(simplified(torus, {.triangles = 400, .error = {}, .poses = {}}).mesh, torus);
    EXPECT_EQ(simplified(torus, {.triangles = {}, .error = 1e-9, .poses = {}}).mesh, torus);
    const Ref<Mesh> triangle = make_ref([] {
        Mesh mesh;
        mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        add_face(mesh, std::array{0u, 1u, 2u});
        return mesh;
    }());
    EXPECT_EQ(simplified(triangle, {.triangles = 0, .error = {}, .poses = {}}).mesh, triangle);
}

TEST(Simplify, KeepsAClosedMeshClosedAndTurnedOutwards)
{
    for (const Mesh& mesh :
         {sphere_mesh(1, 48, 24), bumpy_torus({48, 24}), box_mesh({1, 2, 3}, {8, 8, 8})})
        for (const std::size_t n : {800, 300, 0}) {
            const Mesh less = *to_number(mesh, n).mesh;
            const EdgeCount count = count_edges(less);
            EXPECT_EQ(count.open, 0);
            EXPECT_EQ(count.against, 0);
            EXPECT_EQ(count.crowded, 0);
            if (n > 0) {
                EXPECT_NEAR(volume(less), volume(mesh), 0.1 * volume(mesh));
            }
        }
}

TEST(Simplify, LeavesTheEulerCharacteristicAsItIs)
{
    const Mesh moebius = moebius_mesh(1, 0.4, {64, 8});
    for (const std::size_t n : {300, 100, 0}) {
        EXPECT_EQ(euler(*to_number(sphere_mesh(1, 48, 24), n).mesh), 2);
        EXPECT_EQ(euler(*to_number(bumpy_torus({48, 24}), n).mesh), 0);
        EXPECT_EQ(euler(*to_number(plane_mesh({1, 1}, {12, 12}), n).mesh), 1);
        EXPECT_EQ(euler(*to_number(moebius, n).mesh), 0);
        EXPECT_GT(count_edges(*to_number(moebius, n).mesh).open, 2);
    }
}

TEST(Simplify, KeepsABoxABoxOfTwelveTriangles)
{
    const Mesh box = box_mesh({1, 2, 3}, {6, 7, 8});
    const SimplifiedMesh less = to_error(box, 0);
    EXPECT_EQ(less.triangles, 12u);
    EXPECT_EQ(less.mesh->vertex_count(), 24u); // three to a corner
    EXPECT_NEAR(volume(*less.mesh), 6, 1e-6);
    EXPECT_TRUE(has_vertices_of(*less.mesh, box));
    for (std::size_t f = 0; f < less.mesh->face_count(); ++f)
        for (std::uint32_t c = 3 * static_cast<std::uint32_t>(f); c < 3 * f + 3; ++c)
            EXPECT_NEAR(glm::dot(glm::dvec3(less.mesh->normals[less.mesh->corners[c]]),
                                 glm::normalize(area_normal(*less.mesh, f))),
                        1, 1e-6);
}

TEST(Simplify, ReachesItsShareWhereFacetsOfNoiseAreHardEdges)
{
    Mesh scan = bumpy_torus({80, 40});
    for (std::size_t v = 0; v < scan.vertex_count(); ++v) // rough as the noise of a scanner
        scan.positions[v] += 0.03f * float(std::sin(12.9898 * scan.points[v])) * scan.normals[v];
    const Mesh facets = shaded(scan, 0);
    const std::size_t third = triangles(scan).size() / 3;
    const SimplifiedMesh less = to_number(facets, third);
    EXPECT_LE(less.triangles, third);
    EXPECT_EQ(euler(*less.mesh), 0);
    EXPECT_EQ(shading_of(*less.mesh), 0.0f);
}

TEST(Simplify, LeavesPolygonsThatAreNotTouchedAsTheyAre)
{
    Mesh mesh = plane_mesh({8, 1}, {8, 1}); // flat on the left, a zigzag on the right
    for (glm::vec3& p : mesh.positions)
        if (p.x > 0.5f) p.z = std::lround(p.x) % 2 == 0 ? 1.0f : 0.0f;
    mesh.normals = smooth_normals(mesh);
    const Mesh less = *to_error(mesh, 0.01).mesh;
    std::size_t quads = 0;
    for (std::size_t f = 0; f < less.face_count(); ++f)
        quads += less.face_begin[f + 1] - less.face_begin[f] == 4;
    EXPECT_GE(quads, 3u);
    EXPECT_LT(less.face_count(), mesh.face_count());
    EXPECT_NO_THROW(validate(less, "less"));
}

TEST(Simplify, GivesTheSameBitsForAnyNumberOfThreads)
{
    const Mesh mesh = bumpy_torus({80, 40});
    const SimplifiedMesh several = to_error(mesh, 0.01);
    const ThreadLimit one(1);
    EXPECT_EQ(*to_error(mesh, 0.01).mesh, *several.mesh);
    EXPECT_EQ(*to_number(mesh, 500).mesh, *to_number(mesh, 500).mesh);
}

TEST(Simplify, ReportsItsProgressAndCanBeCancelled)
{
    const Ref<Mesh> mesh = make_ref(bumpy_torus({120, 60}));
    const SimplifyOptions options{.triangles = 100, .error = {}, .poses = {}};
    double last = 0;
    (void)simplified(mesh, options, [&](double done, std::string_view) {
        EXPECT_GE(done, last);
        EXPECT_LE(done, 1);
        last = done;
    });
    EXPECT_GT(last, 0.5);
    EXPECT_THROW(
        (void)simplified(mesh, options, [](double, std::string_view) { throw Cancelled(); }),
        Cancelled);
}

TEST(Simplify, RefusesWhatIsNoErrorAndPosesOfAnotherMesh)
{
    const Ref<Mesh> mesh = make_ref(torus_mesh(2, 0.7, {8, 8}));
    for (const double error : {-1.0, std::nan(""), 1e300 * 1e300})
        EXPECT_THROW((void)simplified(mesh, {.triangles = {}, .error = error, .poses = {}}),
                     Rejected);
    EXPECT_THROW((void)simplified(mesh, {.triangles = 5, .error = {}, .poses = {{{0, 0, 0}}}}),
                 Rejected);
}

} // namespace trivar::testing
