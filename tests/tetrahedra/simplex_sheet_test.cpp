// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tetrahedra/simplex_sheet.h"

#include "core/simplex/box_domain.h"
#include "core/simplex/clouds.h"
#include "core/simplex/simplex_basis.h"

#include <gtest/gtest.h>
#include <random>

namespace trivar {
namespace {

TEST(SimplexSheet, SumsToOneOverTrianglesToo)
{
    const SimplexMesh<2> cells = rectangle_cells(glm::dvec2(2), glm::ivec2(2));
    std::mt19937 random(2);
    std::uniform_real_distribution<double> anywhere(-1, 1);
    for (const CloudBorder border : {CloudBorder::outside, CloudBorder::stacked})
        for (int degree = 1; degree <= 3; ++degree) {
            const SimplexBasis<2> basis(
                with_clouds<2>(cells.vertices, cells.cells, degree, {.border = border}));
            for (int n = 0; n < 500; ++n) {
                glm::dvec2 p(anywhere(random), anywhere(random));
                if (n % 3 == 0) p = glm::round(p * 2.0) / 2.0;
                if (n % 3 == 1) p.y = p.x;
                std::vector<BasisValue<2>> values;
                basis.values_at(p, false, values);
                double sum = -1;
                for (const auto& v : values) sum += v.value;
                EXPECT_LE(std::abs(sum), 1e-12) << degree << " " << p.x << " " << p.y;
            }
        }
}

TEST(SimplexSheet, IsFlatAtRestAndHasTheNormalsOfItsFaces)
{
    for (const glm::vec3& p : simplex_sheet({}).positions) EXPECT_EQ(p.z, 0);
    const Mesh mesh = simplex_sheet(
        {.clamped = false, .segments = 128, .lifts = {{.at = {0.2, 0.1}, .radius = 0.9}}});
    for (std::size_t f = 0; f < mesh.face_count(); ++f) {
        const std::uint32_t* c = &mesh.corners[mesh.face_begin[f]];
        const glm::vec3 normal =
            glm::normalize(glm::cross(mesh.positions[c[2]] - mesh.positions[c[0]],
                                      mesh.positions[c[3]] - mesh.positions[c[1]]));
        EXPECT_GE(glm::dot(normal, mesh.normals[c[0]]), 0.99f);
    }
}

} // namespace
} // namespace trivar
