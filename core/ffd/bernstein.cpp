// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/bernstein.h"

namespace trivar {
namespace {

std::size_t size(const Bernstein& f, std::size_t axis)
{
    return static_cast<std::size_t>(f.degree[axis]) + 1;
}

// Computes the Bernstein polynomials of a degree at x.
std::vector<double> basis_at(int degree, double x)
{
    std::vector<double> b{1};
    for (int d = 1; d <= degree; ++d) {
        b.push_back(0);
        for (std::size_t i = b.size(); i-- > 0;) b[i] = b[i] * (1 - x) + (i > 0 ? b[i - 1] * x : 0);
    }
    return b;
}

} // namespace

double value(const Bernstein& f, const glm::dvec3& x)
{
    const std::vector<double> u = basis_at(f.degree[0], x.x), v = basis_at(f.degree[1], x.y),
                              w = basis_at(f.degree[2], x.z);
    const double* c = f.coefficients.data();
    double sum = 0;
    for (const double a : u)
        for (const double b : v) {
            double row = 0;
            for (const double weight : w) row += weight * *c++;
            sum += a * b * row;
        }
    return sum;
}

std::array<Bernstein, 2> halves(const Bernstein& f, std::size_t axis)
{
    std::array<Bernstein, 2> out{f, f};
    std::size_t inner = 1;
    for (std::size_t x = axis + 1; x < 3; ++x) inner *= size(f, x);
    const std::size_t n = size(f, axis), outer = f.coefficients.size() / (n * inner);
    for (std::size_t a = 0; a < outer; ++a)
        for (std::size_t b = 0; b < inner; ++b) {
            double* low = out[0].coefficients.data() + a * n * inner + b;
            double* high = out[1].coefficients.data() + a * n * inner + b;
            // Round r of the triangle gives its first value to the lower half and its last to the
            // upper half.
            for (std::size_t r = 1; r < n; ++r) {
                low[(r - 1) * inner] = high[0];
                for (std::size_t i = 0; i + r < n; ++i)
                    high[i * inner] = (high[i * inner] + high[(i + 1) * inner]) / 2;
            }
            low[(n - 1) * inner] = high[0];
        }
    return out;
}

} // namespace trivar
