// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/ffd/deform.h"
#include "tests/refinement/bent.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;

// How far the vertices of a mesh are written from where the volume takes them.
double furthest_vertex(const Mesh& mesh, const Lattice& lattice)
{
    const Mesh placed = deform(mesh, {}, lattice);
    double most = 0;
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v)
        most = std::max(
            most, glm::distance(glm::dvec3(placed.positions[v]),
                                deform(glm::dvec3(mesh.positions[v]), {}, lattice).position_world));
    return most;
}

// Control points that go to and fro cost the most digits, those of one cell and those of many.
Lattice jagged(int order, int count, double height)
{
    const Knots knots = Knots::uniform(order, count);
    Lattice lattice = lattice_at_rest({knots, knots, knots}, glm::dmat4(1));
    Noise noise(static_cast<unsigned>(order * count));
    for (std::size_t i = 0; i < lattice.displacement.points.size(); ++i)
        lattice.displacement.points[i] =
            (i % 2 == 0 ? height : -height) * (1.0 + 0.1 * noise.vec3());
    return lattice;
}

Mesh sphere_in_the_middle()
{
    Mesh mesh = sphere_mesh(0.49, 24, 16);
    for (glm::vec3& p : mesh.positions) p += 0.5f;
    return mesh;
}

TEST(SinglePrecision, IsMeasuredAtEveryVertexForAllOrders)
{
    const Mesh mesh = sphere_in_the_middle();
    for (int order = 2; order <= max_order; ++order)
        for (const int count : {order, order + 5})
            for (const double height : {0.01, 1000.0}) {
                const Lattice lattice = jagged(order, count, height);
                const RefinementResult out =
                    bounded({{make_ref(mesh), {}}}, lattice, {.tolerance_world = 1e6});
                const double furthest = furthest_vertex(mesh, lattice);
                EXPECT_GT(furthest, 0);
                EXPECT_LE(furthest, out.rounding * (1 + 1e-6)) << order << " " << count;
                EXPECT_LE(out.rounding, 4 * furthest) << "measured, not guessed";
            }
}

TEST(SinglePrecision, IsPartOfTheBoundForAllOrders)
{
    const Mesh mesh = sphere_in_the_middle();
    for (int order = 2; order <= max_order; ++order) {
        const Lattice lattice = jagged(order, order + 2, 0.3);
        const RefinementResult out = refine_one(mesh, lattice, {.tolerance_world = 0.02});
        EXPECT_EQ(out.not_certified(), 0u) << order;
        EXPECT_LE(out.bound, 0.02);
        EXPECT_LE(furthest_vertex(*out.parts[0].mesh, lattice), out.rounding * (1 + 1e-6));
        EXPECT_LE(drawn_error(*out.parts[0].mesh, {}, lattice, 6), out.bound) << order;
    }
}

TEST(SinglePrecision, RefusesAToleranceFinerThanItself)
{
    const Lattice lattice = jagged(4, 6, 1000);
    EXPECT_THROW(refine_one(sphere_in_the_middle(), lattice, {.tolerance_world = 1e-4}), Rejected);
}

} // namespace
} // namespace trivar
