// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/field/fields.h"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

namespace trivar::testing {
namespace {

using Function = std::function<double(const glm::dvec3&)>;

SampledField over(double from, double to, int n, double level, const Function& function)
{
    SampledField out{glm::ivec3(n), {}, level, (to - from) / (n - 1)};
    for (int k = 0; k < n; ++k)
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
                out.samples.push_back(function(from + out.spacing * glm::dvec3(i, j, k)));
    return out;
}

Function bumps()
{
    struct Bump {
        glm::dvec3 at;
        double width, height;
    };
    std::minstd_rand random(3);
    std::uniform_real_distribution<double> share(0, 1);
    std::vector<Bump> all;
    for (int i = 0; i < 20; ++i) {
        Bump bump;
        for (int k = 0; k < 3; ++k) bump.at[k] = 0.25 + 0.5 * share(random);
        bump.width = 0.05 + 0.06 * share(random);
        bump.height = 0.5 + 0.5 * share(random);
        all.push_back(bump);
    }
    return [all](const glm::dvec3& p) {
        double sum = 0;
        for (const Bump& b : all)
            sum += b.height * std::exp(-glm::dot(p - b.at, p - b.at) / (2 * b.width * b.width));
        return sum;
    };
}

} // namespace

SampledField sampled(const std::string& function, int n)
{
    if (function == "sphere")
        return over(-1.2, 1.2, n, std::sqrt(0.7 * 0.7 + 0.04),
                    [](const glm::dvec3& p) { return std::sqrt(glm::dot(p, p) + 0.04); });
    if (function == "torus")
        return over(-1.2, 1.2, n, 0.0625, [](const glm::dvec3& p) {
            const double across = std::hypot(p.x, p.y) - 0.6;
            return across * across + p.z * p.z;
        });
    if (function == "gauss") return over(0, 1, n, 0.5, bumps());
    if (function == "waves")
        return over(-1, 1, n, 0.5, [](const glm::dvec3& p) {
            constexpr double pi = std::numbers::pi;
            const double wave = std::cos(2 * pi * 6 * std::cos(pi * std::hypot(p.x, p.y) / 2));
            return (1 - std::sin(pi * p.z / 2) + 0.25 * (1 + wave)) / 2.5;
        });
    std::minstd_rand random(5);
    return over(0, 1, n, 5, [&](const glm::dvec3&) { return static_cast<double>(random() % 11); });
}

std::vector<float> in_single_precision(const std::vector<double>& samples)
{
    return {samples.begin(), samples.end()};
}

} // namespace trivar::testing
