// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/function_surface.h"

#include "core/simplex/box_domain.h"
#include "core/simplex/clouds.h"

#include <gtest/gtest.h>
#include <map>

namespace trivar {
namespace {

TEST(FunctionSurface, IsClosedAndLiesOnTheFunction)
{
    const SimplexMesh<3> cells = box_cells(glm::dvec3(1), glm::ivec3(2));
    const SimplexBasis<3> basis(with_clouds<3>(cells.vertices, cells.cells, 2));
    const int point = 57;
    const double value = greatest_value(basis, point) / 2;
    const Mesh mesh = function_surface(basis, point, value, 16);
    ASSERT_GT(mesh.face_count(), 50U);
    std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
    for (std::size_t f = 0; f < mesh.face_count(); ++f)
        for (std::size_t i = 0; i < 3; ++i)
            ++edges[{mesh.corners[3 * f + i], mesh.corners[3 * f + (i + 1) % 3]}];
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        EXPECT_TRUE(edges.contains({edge.second, edge.first}));
    }
    std::vector<BasisValue<3>> values;
    std::size_t on = 0;
    for (const glm::vec3& p : mesh.positions) {
        basis.values_at(p, false, values);
        double sum = 0;
        for (const auto& v : values) sum += v.point == point ? v.value : 0;
        on += std::abs(sum - value) < 1e-5 ? 1 : 0;
    }
    EXPECT_GE(on, mesh.positions.size() * 98 / 100);
    EXPECT_EQ(function_surface(basis, point, 2, 8).face_count(), 0U);
}

} // namespace
} // namespace trivar
