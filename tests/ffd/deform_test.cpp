// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/deform.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

Mesh square()
{
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.normals.assign(4, {0, 0, 1});
    mesh.corners = {0, 1, 2, 3};
    mesh.face_begin = {0, 4};
    return mesh;
}

TEST(Deform, ByALatticeOfZerosIsTheIdentity)
{
    const Knots knots = Knots::uniform(3, 5);
    const Lattice lattice = lattice_at_rest({knots, knots, knots}, glm::dmat4(1));
    EXPECT_EQ(deform(square(), {}, lattice), square());
}

} // namespace
} // namespace trivar
