// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/box_domain.h"
#include "core/simplex/clouds.h"
#include "core/simplex/simplex_basis.h"

#include <gtest/gtest.h>
#include <random>

namespace trivar {
namespace {

using Values = std::vector<BasisValue<3>>;

SimplexBasis<3> of_box(int degree, const CloudStyle& style = {}, int boxes = 2,
                       const std::vector<Crease<3>>& creases = {})
{
    SimplexMesh<3> mesh = box_cells(glm::dvec3(2), glm::ivec3(boxes));
    return SimplexBasis<3>(with_clouds<3>(mesh.vertices, mesh.cells, degree, style, creases));
}

// Points anywhere in the box [-1, 1]^3, and on its vertices, edges, faces and inner faces.
std::vector<glm::dvec3> points(std::size_t count)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> anywhere(-1, 1);
    std::vector<glm::dvec3> out;
    while (out.size() < count) {
        glm::dvec3 p{anywhere(random), anywhere(random), anywhere(random)};
        if (out.size() % 4 == 1) p.y = p.x;
        if (out.size() % 4 == 2) p = glm::round(p * 2.0) / 2.0;
        if (out.size() % 4 == 3) p.z = 0;
        out.push_back(p);
    }
    return out;
}

double sum_error(const SimplexBasis<3>& basis, const glm::dvec3& p)
{
    Values values;
    basis.values_at(p, false, values);
    double sum = 0;
    for (const auto& v : values) sum += v.value;
    return std::abs(sum - 1);
}

TEST(SimplexBasis, SumsToOneInTheWholeDomain)
{
    for (const bool clamped : {false, true})
        for (int degree = 1; degree <= 3; ++degree) {
            const SimplexBasis<3> basis = of_box(degree, {.clamped = clamped});
            double worst = 0;
            for (const glm::dvec3& p : points(degree == 3 ? 400 : 2000))
                worst = std::max(worst, sum_error(basis, p));
            EXPECT_LE(worst, 1e-12) << degree << clamped;
        }
}

TEST(SimplexBasis, GivesTheIdentityWithControlPointsAtRest)
{
    for (int degree = 1; degree <= 3; ++degree) {
        const SimplexBasis<3> basis = of_box(degree);
        double worst = 0;
        Values values;
        for (const glm::dvec3& p : points(200)) {
            basis.values_at(p, true, values);
            glm::dvec3 at(0);
            glm::dmat3 derivative(0);
            for (const auto& v : values) {
                at += basis.rest()[static_cast<std::size_t>(v.point)] * v.value;
                derivative +=
                    glm::outerProduct(basis.rest()[static_cast<std::size_t>(v.point)], v.gradient);
            }
            EXPECT_LE(glm::distance(at, p), 1e-12);
            for (int i = 0; i < 3; ++i)
                worst = std::max(worst, glm::distance(derivative[i], glm::dmat3(1)[i]));
        }
        EXPECT_LE(worst, 1e-9) << degree;
    }
}

} // namespace
} // namespace trivar
