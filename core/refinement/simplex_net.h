// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/index.h"
#include "core/spline/knots.h"

#include <glm/glm.hpp>

namespace trivar {

// Polynomials on an edge (two corners) or a triangle (three), homogeneous in its barycentric
// coordinates l: the term l1^(N-r) l2^(r-c) l3^c stands at r (r + 1) / 2 + c, on an edge at r.

inline constexpr int max_net_degree = 3 * (max_order - 1);

template <int corners> constexpr int net_size(int degree)
{
    return corners == 2 ? degree + 1 : (degree + 1) * (degree + 2) / 2;
}
template <int corners> constexpr int net_index(int r, int c)
{
    return corners == 2 ? r : r * (r + 1) / 2 + c;
}

template <int corners>
using NetPoints = std::array<glm::dvec4, at(net_size<corners>(max_net_degree))>;

// Calls visit(index, r, c) for every term of a degree, in their order.
template <int corners> void each_term(int degree, auto&& visit)
{
    int index = 0;
    for (int r = 0; r <= degree; ++r)
        for (int c = 0; c <= (corners == 2 ? 0 : r); ++c) visit(index++, r, c);
}

// The multinomial coefficient N! / ((N-r)! (r-c)! c!).
inline double multinomial(int degree, int r, int c)
{
    constexpr auto factorial = [] {
        std::array<double, max_net_degree + 1> out{1};
        for (std::size_t i = 1; i < out.size(); ++i) out[i] = out[i - 1] * static_cast<double>(i);
        return out;
    }();
    return factorial[at(degree)] /
           (factorial[at(degree - r)] * factorial[at(r - c)] * factorial[at(c)]);
}

// Computes out += a b, for a with numbers and b with numbers or points as coefficients.
template <int corners, class Value>
void add_product(const double* a, int degree_a, const Value* b, int degree_b, Value* out)
{
    if constexpr (corners == 2) {
        for (int i = 0; i <= degree_a; ++i)
            for (int j = 0; j <= degree_b; ++j) out[i + j] += b[j] * a[i];
    } else {
        for (int r = 0; r <= degree_a; ++r)
            for (int c = 0; c <= r; ++c) {
                const double factor = a[net_index<3>(r, c)];
                for (int q = 0; q <= degree_b; ++q) {
                    Value* to = out + net_index<3>(r + q, c);
                    const Value* from = b + net_index<3>(q, 0);
                    for (int e = 0; e <= q; ++e) to[e] += from[e] * factor;
                }
            }
    }
}

// The Bernstein polynomials of one order at u(l), a form with value u[i] in corner i.
template <int corners>
using BasisOnSimplex =
    std::array<std::array<double, at(net_size<corners>(max_order - 1))>, at(max_order)>;
template <int corners>
BasisOnSimplex<corners> basis_on_simplex(int order, const std::array<double, corners>& u)
{
    const int degree = order - 1;
    std::array<double, corners> rest;
    for (std::size_t i = 0; i < corners; ++i) rest[i] = 1 - u[i];
    // The powers of u and of 1 - u; `power` includes the binomials.
    BasisOnSimplex<corners> power{}, rest_power{}, out{};
    power[0][0] = rest_power[0][0] = 1;
    for (int i = 1; i <= degree; ++i) {
        add_product<corners>(u.data(), 1, power[at(i - 1)].data(), i - 1, power[at(i)].data());
        add_product<corners>(rest.data(), 1, rest_power[at(i - 1)].data(), i - 1,
                             rest_power[at(i)].data());
    }
    for (int i = 0; i <= degree; ++i) {
        add_product<corners>(power[at(i)].data(), i, rest_power[at(degree - i)].data(), degree - i,
                             out[at(i)].data());
        const double binomial = multinomial(degree, i, 0);
        for (double& x : out[at(i)]) x *= binomial;
    }
    return out;
}

// The Bezier net of D(u(l), v(l), w(l)) for a cell of Bezier points, w fastest, and its degree.
// local[a][i] is parameter a of corner i in the cell, 0 to 1. After W. DeRose, "Composing Bezier
// simplexes", ACM TOG 7 (1988).
template <int corners>
int compose(const glm::dvec4* cell, const glm::ivec3& orders,
            const std::array<std::array<double, corners>, 3>& local, NetPoints<corners>& out)
{
    constexpr int most_1 = net_size<corners>(max_order - 1),
                  most_2 = net_size<corners>(2 * (max_order - 1));
    const int du = orders.x - 1, dv = orders.y - 1, dw = orders.z - 1;
    const auto u = basis_on_simplex<corners>(orders.x, local[0]),
               v = basis_on_simplex<corners>(orders.y, local[1]),
               w = basis_on_simplex<corners>(orders.z, local[2]);
    const int size_1 = net_size<corners>(du), size_2 = net_size<corners>(du + dv),
              degree = du + dv + dw, size = net_size<corners>(degree);
    std::fill_n(out.begin(), size, glm::dvec4(0));
    for (int k = 0; k < orders.z; ++k) {
        std::array<glm::dvec4, at(most_2)> plane;
        std::fill_n(plane.begin(), size_2, glm::dvec4(0));
        for (int j = 0; j < orders.y; ++j) {
            std::array<glm::dvec4, at(most_1)> line;
            std::fill_n(line.begin(), size_1, glm::dvec4(0));
            for (int i = 0; i < orders.x; ++i) {
                const glm::dvec4& p = cell[(i * orders.y + j) * orders.z + k];
                for (int t = 0; t < size_1; ++t) line[at(t)] += p * u[at(i)][at(t)];
            }
            add_product<corners>(v[at(j)].data(), dv, line.data(), du, plane.data());
        }
        add_product<corners>(w[at(k)].data(), dw, plane.data(), du + dv, out.data());
    }
    each_term<corners>(
        degree, [&](int index, int r, int c) { out[at(index)] /= multinomial(degree, r, c); });
    return degree;
}

} // namespace trivar
