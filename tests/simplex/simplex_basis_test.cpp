// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/box_domain.h"
#include "core/simplex/clouds.h"
#include "core/simplex/simplex_basis.h"
#include "tests/simplex/exact_recursion.h"

#include <glm/gtx/component_wise.hpp>
#include <gtest/gtest.h>
#include <optional>
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
            const SimplexBasis<3> basis =
                of_box(degree, {.border = clamped ? CloudBorder::stacked : CloudBorder::outside});
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

// The values by function, summed by control point.
std::vector<double> dense(const SimplexBasis<3>& basis, const glm::dvec3& p)
{
    Values values;
    basis.values_at(p, false, values);
    std::vector<double> out(basis.point_count(), 0);
    for (const auto& v : values) out[static_cast<std::size_t>(v.point)] += v.value;
    return out;
}

double error_to_recursion(const SimplexBasis<3>& basis, const glm::dvec3& p)
{
    const std::size_t per_cell = multi_indices<3>(basis.domain().degree).size();
    const glm::dvec3 direction{0.7548776662466927, 0.5698402909980532, 0.3247179572447460};
    const std::vector<double> exact = ExactRecursion<3>(basis.domain()).values(p, direction);
    std::vector<double> out = dense(basis, p);
    for (std::size_t i = 0; i < exact.size(); ++i)
        out[static_cast<std::size_t>(basis.point_of(i / per_cell, i % per_cell))] -= exact[i];
    double worst = 0;
    for (const double each : out) worst = std::max(worst, std::abs(each));
    return worst;
}

TEST(SimplexBasis, AgreesWithTheRecursionInRationalNumbers)
{
    for (const bool clamped : {false, true})
        for (int degree = 1; degree <= 3; ++degree) {
            const SimplexBasis<3> basis = of_box(
                degree, {.border = clamped ? CloudBorder::stacked : CloudBorder::outside}, 1);
            double worst = 0;
            for (const glm::dvec3& p : points(degree == 3 ? 3 : 12))
                if (glm::compMax(glm::abs(p)) < 1) // the recursion ends where the border does
                    worst = std::max(worst, error_to_recursion(basis, p));
            EXPECT_LE(worst, 1e-10) << degree << clamped;
        }
}

// Central differences with steps h and h / 2 of the sum of functions times some values, combined so
// that they are exact for cubics; no value where the two show that a knot plane lies between.
std::optional<glm::dvec3> differences(const SimplexBasis<3>& basis, const glm::dvec3& p)
{
    const auto sum = [&](const glm::dvec3& at) {
        Values values;
        basis.values_at(at, false, values);
        double out = 0;
        for (const auto& v : values) out += v.value * std::sin(v.point);
        return out;
    };
    glm::dvec3 out;
    for (int axis = 0; axis < 3; ++axis) {
        glm::dvec3 step(0);
        step[axis] = 1e-4;
        const double coarse = (sum(p + step) - sum(p - step)) / 2e-4;
        const double fine = (sum(p + 0.5 * step) - sum(p - 0.5 * step)) / 1e-4;
        const double finest = (sum(p + 0.25 * step) - sum(p - 0.25 * step)) / 0.5e-4;
        out[axis] = (4 * finest - fine) / 3;
        if (std::abs(out[axis] - (4 * fine - coarse) / 3) > 1e-8) return {};
    }
    return out;
}

TEST(SimplexBasis, HasTheGradientsOfItsValues)
{
    for (int degree = 1; degree <= 3; ++degree) {
        const SimplexBasis<3> basis = of_box(degree);
        std::mt19937 random(3);
        std::uniform_real_distribution<double> anywhere(-0.9, 0.9);
        int seen = 0;
        for (int n = 0; n < 300; ++n) {
            const glm::dvec3 p{anywhere(random), anywhere(random), anywhere(random)};
            const std::optional<glm::dvec3> expected = differences(basis, p);
            if (!expected) continue;
            ++seen;
            Values values;
            basis.values_at(p, true, values);
            glm::dvec3 gradient(0);
            for (const auto& v : values) gradient += v.gradient * std::sin(v.point);
            EXPECT_LE(glm::distance(gradient, *expected), 1e-8) << degree;
        }
        EXPECT_GE(seen, 200) << degree;
    }
}

} // namespace
} // namespace trivar
