// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simplex/field_fit.h"

#include "core/base/parallel.h"
#include "core/base/rejected.h"
#include "core/meshing/parted_cells.h"
#include "core/simplex/box_domain.h"
#include "core/simplex/clouds.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>

namespace trivar {
namespace {

PartedCells halves() // of a cube, parted at x = 0
{
    PartedCells out{box_cells(glm::dvec3(2), glm::ivec3(2)), {}};
    for (const auto& cell : out.mesh.cells) {
        double x = 0;
        for (const int v : cell) x += out.mesh.vertices[static_cast<std::size_t>(v)].x;
        out.inside.push_back(x > 0);
    }
    return out;
}

Ref<SimplexBasis<3>> basis_of(const PartedCells& cells, int degree, bool cut)
{
    return make_ref(SimplexBasis<3>(
        with_clouds<3>(cells.mesh.vertices, cells.mesh.cells, degree, {},
                       cut ? cuts_between(cells, degree) : std::vector<Crease<3>>{})));
}

// None lies in the planes of the cells' faces.
std::vector<FieldSample> samples_of(int n, const std::function<double(const glm::dvec3&)>& f)
{
    std::vector<FieldSample> out;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j)
            for (int k = 0; k < n; ++k) {
                const glm::dvec3 at =
                    (glm::dvec3(i, j, k) + glm::dvec3(0.51, 0.47, 0.53)) * (2.0 / n) - 1.0;
                out.push_back({at, f(at)});
            }
    return out;
}

double greatest_error(const SimplexField& field, const std::vector<FieldSample>& truth)
{
    double out = 0;
    for (const FieldSample& s : truth)
        out = std::max(out, std::abs(evaluate(field, s.at).value - s.value));
    return out;
}

double step(const glm::dvec3& p)
{
    return p.x > 0 ? 1000 : 0;
}

TEST(FieldFit, FindsPolynomialsOfItsDegreeAgain)
{
    for (const int degree : {1, 2, 3}) {
        const auto polynomial = [&](const glm::dvec3& p) {
            const double a = 1 + p.x - 2 * p.y + p.z, b = p.x + p.y;
            return std::pow(a, degree) + 3 * std::pow(b, degree - 1);
        };
        const FieldFit fit =
            fitted_field(basis_of(halves(), degree, false), samples_of(24, polynomial));
        EXPECT_EQ(fit.held, 0U) << degree;
        EXPECT_LT(greatest_error(fit.field, samples_of(11, polynomial)), 1e-9) << degree;
        EXPECT_LT(fit.rms, 1e-6) << degree;
    }
}

TEST(FieldFit, JumpsAtCutFacesWithoutOvershoot)
{
    for (const int degree : {1, 2, 3}) {
        const FieldFit cut = fitted_field(basis_of(halves(), degree, true), samples_of(16, step));
        EXPECT_LT(greatest_error(cut.field, samples_of(11, step)), 1e-6) << degree;
        const FieldFit whole =
            fitted_field(basis_of(halves(), degree, false), samples_of(16, step));
        EXPECT_GT(greatest_error(whole.field, samples_of(11, step)), 200) << degree;
    }
}

TEST(FieldFit, NeedsNoMoreUnknownsThanABezierNet)
{
    const Ref<SimplexBasis<3>> basis = basis_of(halves(), 2, false);
    // 27 vertices and 98 edges: 54 along the axes, 36 across faces and 8 across cubes
    EXPECT_EQ(fit_size(basis->domain()), 125U);
    EXPECT_EQ(fit_size(basis_of(halves(), 2, true)->domain()), 125U + 25U);
}

TEST(FieldFit, StaysNearTheSamplesWhereTheyAreFew)
{
    std::vector<FieldSample> samples = samples_of(16, step);
    std::erase_if(samples, [](const FieldSample& s) { return glm::length(s.at) < 0.9; });
    const FieldFit fit = fitted_field(basis_of(halves(), 2, true), samples);
    EXPECT_GT(fit.held, 0U);
    EXPECT_LT(greatest_error(fit.field, samples_of(11, step)), 1);
}

TEST(FieldFit, HasTheSameBitsForAnyNumberOfThreads)
{
    const Ref<SimplexBasis<3>> basis = basis_of(halves(), 2, true);
    const auto samples =
        samples_of(12, [](const glm::dvec3& p) { return std::sin(4 * p.x * p.y); });
    const ThreadLimit one(1);
    const FieldFit alone = fitted_field(basis, samples);
    const ThreadLimit more(7);
    EXPECT_EQ(fitted_field(basis, samples).field, alone.field);
}

TEST(FieldFit, RefusesWhatCannotBeFitted)
{
    const Ref<SimplexBasis<3>> basis = basis_of(halves(), 2, false);
    EXPECT_THROW(fitted_field(basis, samples_of(4, step)), Rejected);
    std::vector<FieldSample> beyond = samples_of(16, step);
    for (FieldSample& s : beyond) s.at += 10.0;
    EXPECT_THROW(fitted_field(basis, beyond), Rejected);
    std::vector<FieldSample> bad = samples_of(16, step);
    bad[3].value = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(fitted_field(basis, bad), Rejected);
}

} // namespace
} // namespace trivar
