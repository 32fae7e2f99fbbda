// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/flatten.h"

#include "core/base/mistake.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

double angle_between(const glm::dvec2& a, const glm::dvec2& b)
{
    return std::abs(std::atan2(a.x * b.y - a.y * b.x, glm::dot(a, b)));
}

int chords(std::span<const glm::dvec2> p, double tolerance)
{
    constexpr int most = 200;
    constexpr double most_turn = 0.349; // radians
    const std::size_t degree = p.size() - 1;
    double second = 0, turned = 0;
    for (std::size_t i = 1; i < degree; ++i)
        second = std::max(second, glm::length(p[i - 1] - 2.0 * p[i] + p[i + 1]));
    glm::dvec2 last(0);
    for (std::size_t i = 0; i < degree; ++i) {
        const glm::dvec2 leg = p[i + 1] - p[i];
        if (leg == glm::dvec2(0)) continue;
        if (last != glm::dvec2(0)) turned += angle_between(last, leg);
        last = leg;
    }
    const double by_error =
        std::sqrt(second * static_cast<double>(degree * (degree - 1)) / (8 * tolerance));
    return std::clamp(static_cast<int>(std::ceil(std::max(by_error, turned / most_turn))), 1, most);
}

} // namespace

void append_curve(Loop& loop, std::span<const glm::dvec2> control, double tolerance)
{
    ensure(control.size() == 3 || control.size() == 4, "a curve is not of degree 2 or 3");
    const int n = chords(control, tolerance);
    for (int i = 1; i <= n; ++i) {
        const double t = double(i) / n;
        std::array<glm::dvec2, 4> p{}; // control points of de Casteljau's algorithm
        std::copy(control.begin(), control.end(), p.begin());
        for (std::size_t left = control.size() - 1; left > 0; --left)
            for (std::size_t k = 0; k < left; ++k) p[k] += (p[k + 1] - p[k]) * t;
        loop.emplace_back(glm::round(p[0]));
    }
}

} // namespace trivar
