// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/fold_limit.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace trivar {
namespace {

// This file bounds det = A + B z + C z^2 with A = (P_x x P_y) . N, B = (P_x x N_y + N_x x P_y) . N
// and C = (N_x x N_y) . N, of degree 8 along both axes. If each Bernstein coefficient of A + B z +
// C z^2 is positive for all z up to a height, so is the determinant: the limit is the least
// positive root of the coefficients, which are quadratic in z.

constexpr double infinity = std::numeric_limits<double>::infinity();

constexpr auto binomials = [] {
    std::array<std::array<double, 9>, 9> table{};
    for (std::size_t n = 0; n < 9; ++n) {
        table[n][0] = 1;
        for (std::size_t k = 1; k <= n; ++k)
            table[n][k] = table[n - 1][k - 1] + (k < n ? table[n - 1][k] : 0);
    }
    return table;
}();

// Vectors are the vector-valued Bernstein coefficients of a polynomial times their binomials, so
// that products are plain convolutions.
struct Vectors {
    std::size_t p, q; // degrees along x and y
    std::array<glm::dvec3, 36> c{};
};

Vectors scaled(const std::array<glm::dvec3, 16>& from, std::size_t dx, std::size_t dy)
{
    Vectors out{3 - dx, 3 - dy};
    for (std::size_t j = 0; j <= out.q; ++j)
        for (std::size_t i = 0; i <= out.p; ++i) {
            const glm::dvec3& at = from[4 * j + i];
            const glm::dvec3 value = dx   ? 3.0 * (from[4 * j + i + 1] - at)
                                     : dy ? 3.0 * (from[4 * (j + 1) + i] - at)
                                          : at;
            out.c[j * (out.p + 1) + i] = binomials[out.p][i] * binomials[out.q][j] * value;
        }
    return out;
}

template <class Product> void convolve(const Vectors& a, const Vectors& b, Product&& product)
{
    for (std::size_t j = 0; j <= a.q; ++j)
        for (std::size_t i = 0; i <= a.p; ++i)
            for (std::size_t l = 0; l <= b.q; ++l)
                for (std::size_t k = 0; k <= b.p; ++k)
                    product(i + k, j + l, a.c[j * (a.p + 1) + i], b.c[l * (b.p + 1) + k]);
}

void add_cross(const Vectors& a, const Vectors& b, Vectors& out)
{
    convolve(a, b, [&](std::size_t i, std::size_t j, const glm::dvec3& u, const glm::dvec3& v) {
        out.c[j * (out.p + 1) + i] += glm::cross(u, v);
    });
}

using Net = std::array<double, 81>; // plain Bernstein coefficients [9 j + i]

Net dotted(const Vectors& a, const Vectors& b)
{
    Net out{};
    convolve(a, b, [&](std::size_t i, std::size_t j, const glm::dvec3& u, const glm::dvec3& v) {
        out[9 * j + i] += glm::dot(u, v);
    });
    for (std::size_t j = 0; j < 9; ++j)
        for (std::size_t i = 0; i < 9; ++i) out[9 * j + i] /= binomials[8][i] * binomials[8][j];
    return out;
}

struct Determinant {
    Net a, b, c;
};

Determinant determinant_of(const TilePatch& patch)
{
    const Vectors px = scaled(patch.p, 1, 0), py = scaled(patch.p, 0, 1),
                  nx = scaled(patch.n, 1, 0), ny = scaled(patch.n, 0, 1), n = scaled(patch.n, 0, 0);
    Vectors a{5, 5}, b{5, 5}, c{5, 5};
    add_cross(px, py, a);
    add_cross(px, ny, b);
    add_cross(nx, py, b);
    add_cross(nx, ny, c);
    return {dotted(a, n), dotted(b, n), dotted(c, n)};
}

// Returns the least positive z with a + b z + c z^2 = 0; infinity if there is none, 0 if a <= 0.
double least_root(double a, double b, double c)
{
    if (!(a > 0)) return 0;
    const double d = b * b - 4 * a * c;
    if (!(d >= 0)) return infinity;
    const double q = -0.5 * (b + (b >= 0 ? 1 : -1) * std::sqrt(d));
    double least = infinity;
    if (q != 0 && a / q > 0) least = a / q;
    if (c != 0 && q / c > 0) least = std::min(least, q / c);
    return least;
}

// Coefficients that vanish are those of a side that is a single point.
bool vanishes(const Determinant& d, std::size_t i)
{
    return d.a[i] == 0 && d.b[i] == 0 && d.c[i] == 0;
}

double root_at(const Determinant& d, std::size_t i)
{
    return vanishes(d, i) ? infinity : least_root(d.a[i], d.b[i], d.c[i]);
}

double least_root(const Determinant& d)
{
    double least = infinity;
    for (std::size_t i = 0; i < 81; ++i) least = std::min(least, root_at(d, i));
    return least;
}

bool vanishes(const Determinant& d)
{
    for (std::size_t i = 0; i < 81; ++i)
        if (!vanishes(d, i)) return false;
    return true;
}

// Computes the coefficients over both halves of an axis, by de Casteljau's algorithm.
std::array<Net, 2> halves(const Net& in, bool along_x)
{
    std::array<Net, 2> out;
    for (std::size_t row = 0; row < 9; ++row) {
        const auto at = [&](std::size_t k) { return along_x ? 9 * row + k : 9 * k + row; };
        std::array<double, 9> t;
        for (std::size_t k = 0; k < 9; ++k) t[k] = in[at(k)];
        for (std::size_t step = 0; step < 9; ++step) {
            out[0][at(step)] = t[0];
            out[1][at(8 - step)] = t[8 - step];
            for (std::size_t k = 0; k + step < 8; ++k) t[k] = 0.5 * (t[k] + t[k + 1]);
        }
    }
    return out;
}

// A piece of the patch.
struct Piece {
    Determinant det;
    double limit; // by its coefficients
};

double least_at_corners(const Determinant& d)
{
    double least = infinity;
    for (const std::size_t i : {0, 8, 72, 80}) least = std::min(least, root_at(d, i));
    return least;
}

std::array<Piece, 4> quarters(const Determinant& d)
{
    std::array<Piece, 4> out;
    const auto ax = halves(d.a, true), bx = halves(d.b, true), cx = halves(d.c, true);
    for (std::size_t i = 0; i < 2; ++i) {
        const auto a = halves(ax[i], false), b = halves(bx[i], false), c = halves(cx[i], false);
        for (std::size_t j = 0; j < 2; ++j) {
            const Determinant part{a[j], b[j], c[j]};
            out[2 * i + j] = {part, least_root(part)};
        }
    }
    return out;
}

// Quarters the piece with the lowest limit until that is nearly a value at a corner, which no limit
// can be above.
double limit_of(const Determinant& whole, int most_quartered)
{
    const auto higher = [](const Piece& x, const Piece& y) { return x.limit > y.limit; };
    std::vector<Piece> heap{{whole, least_root(whole)}};
    double corner = least_at_corners(whole);
    for (int i = 0; i < most_quartered; ++i) {
        const double limit = heap.front().limit;
        if (limit == infinity || limit >= 0.995 * corner) break;
        std::ranges::pop_heap(heap, higher);
        const Determinant lowest = heap.back().det;
        heap.pop_back();
        for (const Piece& part : quarters(lowest)) {
            corner = std::min(corner, least_at_corners(part.det));
            heap.push_back(part);
            std::ranges::push_heap(heap, higher);
        }
    }
    return heap.front().limit;
}

} // namespace

double fold_limit(const TilePatch& patch, int most_quartered)
{
    const Determinant d = determinant_of(patch);
    return vanishes(d) ? 0 : limit_of(d, most_quartered);
}

} // namespace trivar
