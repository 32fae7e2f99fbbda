// SPDX-License-Identifier: GPL-3.0-or-later
// The ways to the nodes of charts beside the exact shortest ways over the same triangles.
#include "core/mesh/primitives.h"
#include "core/tiles/straightest.h"
#include "tests/tiles/bases.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <gmock/gmock.h>

namespace trivar::testing {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = CGAL::Surface_mesh<Kernel::Point_3>;
using ShortestPaths =
    CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Triangles>>;

Triangles triangles_of(const TileBase& base)
{
    Triangles out;
    for (const glm::dvec3& p : base.points()) out.add_vertex({p.x, p.y, p.z});
    for (std::uint32_t t = 0; t < base.triangle_count(); ++t) {
        const glm::uvec3& v = base.triangle(t);
        out.add_face(Triangles::Vertex_index(v.x), Triangles::Vertex_index(v.y),
                     Triangles::Vertex_index(v.z));
    }
    return out;
}

ShortestPaths::Face_location location(const TileBase& base, const Triangles& mesh,
                                      const SurfacePlace& at)
{
    const Triangles::Face_index face(at.triangle);
    // Weights belong to the corners in the order in which the other library walks round the face.
    const Triangles::Halfedge_index first = mesh.halfedge(face);
    const std::array<Triangles::Vertex_index, 3> corners{mesh.source(first), mesh.target(first),
                                                         mesh.target(mesh.next(first))};
    ShortestPaths::Barycentric_coordinates weights;
    for (std::size_t k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i)
            if (base.triangle(at.triangle)[i] == corners[k].idx()) weights[k] = at.weights[i];
    return {face, weights};
}

struct Case {
    const char* name;
    Mesh mesh;
    double radius; // of the ways: that times the root of the curvature is about 1
};

TEST(StraightestWays, AreAsLongAsTheShortestOnesAre)
{
    std::mt19937 random(11);
    std::vector<Case> cases;
    cases.push_back({"a sphere", sphere_mesh(1, 96, 48), 1});
    cases.push_back({"a torus", torus_mesh(1, 0.4, {128, 64}), 0.5}); // K is at most 1.8, -4.2
    for (const Case& each : cases) {
        SCOPED_TRACE(each.name);
        const TileBase base = base_of(each.mesh);
        const Triangles mesh = triangles_of(base);
        for (int round = 0; round < 2; ++round) {
            const SurfacePlace at = random_place(base, random);
            ShortestPaths paths(mesh);
            const auto from = location(base, mesh, at);
            paths.add_source_point(from.first, from.second);
            for (int k = 0; k < 16; ++k) {
                const SurfaceRay ray =
                    straightest(base, at, each.radius * random_tangent(base, at, random));
                ASSERT_EQ(ray.left, 0);
                const auto to = location(base, mesh, inside(ray.at));
                const double shortest =
                    paths.shortest_distance_to_source_points(to.first, to.second).first;
                EXPECT_NEAR(shortest / each.radius, 1, 1e-3);
            }
        }
    }
}

} // namespace
} // namespace trivar::testing
