// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/volume_change.h"

#include "tests/ffd/samples.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;

const Knots knots = Knots::uniform(3, 6);
const std::array<Knots, 3> cube_axes{knots, knots, knots};

// The lattice that takes the unit cube through a linear map.
Lattice through(const glm::dmat3& linear)
{
    Lattice lattice = lattice_at_rest(cube_axes, glm::dmat4(1));
    const Lattice mapped = lattice_at_rest(cube_axes, glm::dmat4(linear));
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j)
            for (int k = 0; k < 6; ++k)
                lattice.displacement.points[lattice.displacement.index(i, j, k)] =
                    control_point(mapped, i, j, k) - control_point(lattice, i, j, k);
    return lattice;
}

TEST(VolumeChange, AtRestIsThatOfTheMapThatPutsTheMeshThere)
{
    const Mesh mesh = scattered_points(500);
    const Embedding embedding{glm::dmat4(1), some_affine_map()};
    const auto whole = static_cast<float>(glm::determinant(glm::dmat3(some_affine_map())));
    for (const float ratio :
         volume_change(mesh, embedding, lattice_at_rest(cube_axes, glm::dmat4(1))))
        EXPECT_EQ(ratio, whole);
}

TEST(VolumeChange, OfALinearMapIsItsDeterminantAndNegativeWhereItMirrors)
{
    const Mesh mesh = scattered_points(500);
    glm::dmat3 sheared(2, 0, 0, 0.5, 0.75, 0, 0.2, 0.1, 1);
    for (const double sign : {1.0, -1.0}) {
        sheared[2] *= sign;
        for (const float ratio : volume_change(mesh, {}, through(sheared)))
            EXPECT_NEAR(ratio, 1.5 * sign, 1e-5);
    }
}

// The volume of a small parallelepiped at each vertex, before and after.
TEST(VolumeChange, IsWhatHappensToASmallPieceAtEachVertex)
{
    const Mesh mesh = scattered_points(300, 0.1f, 0.9f);
    const Lattice lattice = random_lattice(cube_axes, 0.1);
    const std::vector<float> ratios = volume_change(mesh, {}, lattice);
    const double h = 1e-5;
    for (std::size_t v = 0; v < ratios.size(); ++v) {
        const glm::dvec3 p(mesh.positions[v]);
        glm::dmat3 edges;
        for (int a = 0; a < 3; ++a) {
            glm::dvec3 step(0);
            step[a] = h;
            edges[a] = (deform(p + step, {}, lattice).position_world -
                        deform(p - step, {}, lattice).position_world) /
                       (2 * h);
        }
        EXPECT_NEAR(ratios[v], glm::determinant(edges), 1e-4);
    }
}

} // namespace
} // namespace trivar
