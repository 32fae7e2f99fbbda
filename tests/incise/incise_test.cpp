// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/incise/incise.h"
#include "core/mesh/closed_body.h"

#include "core/mesh/primitives.h"

#include <gtest/gtest.h>

namespace trivar::testing {
namespace {

Mesh welded_by_place(Mesh mesh)
{
    if (mesh.points.empty()) mesh.points = points_by_position(mesh.positions);
    return mesh;
}

TEST(Incise, CutsASphere)
{
    const CutSkin skin(
        std::make_shared<const RayMesh>(make_ref(welded_by_place(sphere_mesh(1, 48, 24)))));
    Incision cut;
    for (int i = 0; i <= 20; ++i) {
        const double a = -0.5 + i / 20.0;
        const glm::dvec3 n(std::cos(a), std::sin(a), 0.1);
        cut.stroke.push_back({glm::normalize(n), glm::normalize(n)});
    }
    const IncisedMesh made = incise(skin, std::vector{cut});
    EXPECT_EQ(made.outcomes[0].refusal, "");
    EXPECT_GT(made.outcomes[0].widest, 0);
    EXPECT_NE(made.rest, made.original);
    EXPECT_TRUE(is_closed_body(*opened(made, std::vector<IncisionOpening>(1))));
}

} // namespace
} // namespace trivar::testing
