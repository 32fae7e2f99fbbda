// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tetrahedra/fold_guard.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace trivar {
namespace {

constexpr double least_det = 0.02;
constexpr std::size_t samples_of_a_cell = 5;
constexpr std::size_t most_samples = 100'000; // of 0.5 to 2 KB

std::vector<glm::vec3> samples(std::span<const Ref<SimplexBasis<3>>> layers)
{
    std::size_t cells = 0, number = 0;
    for (const Ref<SimplexBasis<3>>& layer : layers) cells += layer->domain().cells.size();
    const std::size_t every = 1 + cells / most_samples;
    std::vector<glm::vec3> out;
    for (const Ref<SimplexBasis<3>>& layer : layers)
        for (std::size_t c = 0; c < layer->domain().cells.size(); ++c, ++number) {
            if (number % every != 0) continue;
            const auto corner = corners(layer->domain(), c);
            const glm::dvec3 middle = (corner[0] + corner[1] + corner[2] + corner[3]) / 4.0;
            out.emplace_back(middle);
            if (samples_of_a_cell * cells > most_samples) continue;
            for (const glm::dvec3& each : corner) out.emplace_back(glm::mix(middle, each, 0.8));
        }
    return out;
}

// The coefficients of det(A + t B) by powers of t.
std::array<double, 4> determinant(const glm::dmat3& a, const glm::dmat3& b)
{
    const auto det = [](const glm::dvec3& x, const glm::dvec3& y, const glm::dvec3& z) {
        return glm::dot(x, glm::cross(y, z));
    };
    return {det(a[0], a[1], a[2]),
            det(b[0], a[1], a[2]) + det(a[0], b[1], a[2]) + det(a[0], a[1], b[2]),
            det(a[0], b[1], b[2]) + det(b[0], a[1], b[2]) + det(b[0], b[1], a[2]),
            det(b[0], b[1], b[2])};
}

// The greatest t <= most up to which the cubic stays at or above the least determinant.
double stays_until(const std::array<double, 4>& c, double most)
{
    const auto above = [&](double t) {
        return c[0] + t * (c[1] + t * (c[2] + t * c[3])) >= least_det;
    };
    // The turning points part the way into pieces on which the cubic goes one way.
    std::array<double, 3> ends{most, most, most};
    const double a = 3 * c[3], b = 2 * c[2];
    if (const double square = b * b - 4 * a * c[1]; square >= 0) {
        const double q = -(b + std::copysign(std::sqrt(square), b)) / 2;
        const double first = q != 0 ? c[1] / q : most, second = a != 0 ? q / a : most;
        ends = {first, second, most};
        std::sort(ends.begin(), ends.begin() + 2);
    }
    double from = 0;
    for (const double end : ends) {
        if (!(end > from)) continue;
        const double to = std::min(end, most);
        if (above(to)) {
            from = to;
            continue;
        }
        double lo = from, hi = to;
        for (int step = 0; step < 50; ++step) {
            const double middle = (lo + hi) / 2;
            (above(middle) ? lo : hi) = middle;
        }
        return lo;
    }
    return most;
}

} // namespace

FoldGuard::FoldGuard(std::span<const Ref<SimplexBasis<3>>> layers)
    : rows_(layers, samples(layers), true)
{
}

double FoldGuard::allowed(std::span<const glm::dvec3> displacements,
                          std::span<const glm::dvec3> change) const
{
    const DisplacedPoints now = rows_.displaced(displacements), then = rows_.displaced(change);
    double share = 1;
    for (std::size_t i = 0; i < now.jacobians.size(); ++i) {
        // the second one is I plus the derivative of the change
        const glm::dmat3 by = glm::dmat3(then.jacobians[i]) - glm::dmat3(1);
        const std::array<double, 4> c = determinant(glm::dmat3(now.jacobians[i]), by);
        if (c[0] > least_det) share = stays_until(c, share);
    }
    return share;
}

double FoldGuard::least(std::span<const glm::dvec3> displacements) const
{
    const DisplacedPoints now = rows_.displaced(displacements);
    double out = 1;
    for (const glm::mat3& jacobian : now.jacobians)
        out = std::min(out, glm::determinant(glm::dmat3(jacobian)));
    return out;
}

} // namespace trivar
