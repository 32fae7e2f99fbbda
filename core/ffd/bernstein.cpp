// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/bernstein.h"

#include <cassert>
#include <numeric>

namespace trivar {
namespace {

std::size_t size(const Bernstein& f, std::size_t axis)
{
    return static_cast<std::size_t>(f.degree[axis]) + 1;
}

std::size_t count(const Bernstein& f)
{
    return size(f, 0) * size(f, 1) * size(f, 2);
}

std::vector<double> binomials(int n)
{
    std::vector<double> row{1};
    for (int k = 1; k <= n; ++k) row.push_back(row.back() * (n - k + 1) / k);
    return row;
}

// Every coefficient times its three binomials, or divided by them. Scaled coefficients are those of
// powers of t / (1 - t), so a product is a convolution.
Bernstein scaled(Bernstein f, bool divide)
{
    const std::vector<double> u = binomials(f.degree[0]), v = binomials(f.degree[1]),
                              w = binomials(f.degree[2]);
    std::size_t at = 0;
    for (const double x : u)
        for (const double y : v)
            for (const double z : w) {
                const double factor = x * y * z;
                f.coefficients[at++] *= divide ? 1 / factor : factor;
            }
    return f;
}

// Adds factor a b to `sum`; all scaled.
Bernstein plus_product(Bernstein sum, const Bernstein& a, const Bernstein& b, double factor)
{
    if (sum.coefficients.empty()) {
        for (std::size_t x = 0; x < 3; ++x) sum.degree[x] = a.degree[x] + b.degree[x];
        sum.coefficients.assign(count(sum), 0);
    }
    for (std::size_t x = 0; x < 3; ++x) assert(sum.degree[x] == a.degree[x] + b.degree[x]);
    const std::size_t nv = size(sum, 1), nw = size(sum, 2), bw = size(b, 2);
    std::size_t from_a = 0;
    for (std::size_t i = 0; i < size(a, 0); ++i)
        for (std::size_t j = 0; j < size(a, 1); ++j)
            for (std::size_t k = 0; k < size(a, 2); ++k) {
                const double x = factor * a.coefficients[from_a++];
                const double* y = b.coefficients.data();
                for (std::size_t l = 0; l < size(b, 0); ++l)
                    for (std::size_t m = 0; m < size(b, 1); ++m, y += bw) {
                        double* to = sum.coefficients.data() + ((i + l) * nv + j + m) * nw + k;
                        for (std::size_t n = 0; n < bw; ++n) to[n] += x * y[n];
                    }
            }
    return sum;
}

} // namespace

Bernstein difference_of_products(const Bernstein& a, const Bernstein& b, const Bernstein& c,
                                 const Bernstein& d)
{
    const Bernstein first = plus_product({}, scaled(a, false), scaled(b, false), 1);
    return scaled(plus_product(first, scaled(c, false), scaled(d, false), -1), true);
}

Bernstein sum_of_products(const std::array<Bernstein, 3>& left,
                          const std::array<Bernstein, 3>& right)
{
    Bernstein sum;
    for (std::size_t i = 0; i < 3; ++i)
        sum = plus_product(std::move(sum), scaled(left[i], false), scaled(right[i], false), 1);
    return scaled(std::move(sum), true);
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
            // Round r of the triangle leaves its first value to the lower half, the last to the
            // upper one.
            for (std::size_t r = 1; r < n; ++r) {
                low[(r - 1) * inner] = high[0];
                for (std::size_t i = 0; i + r < n; ++i)
                    high[i * inner] = (high[i * inner] + high[(i + 1) * inner]) / 2;
            }
            low[(n - 1) * inner] = high[0];
        }
    return out;
}

double mean(const Bernstein& f)
{
    return std::accumulate(f.coefficients.begin(), f.coefficients.end(), 0.0) /
           static_cast<double>(f.coefficients.size());
}

} // namespace trivar
