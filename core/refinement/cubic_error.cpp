// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/refinement/cubic_error.h"

#include "core/refinement/net_bisection.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

using Points = std::array<glm::dvec4, max_order * max_order * max_order>;

// Calls visit(first, stride) for every line of control points along an axis.
void each_line(const glm::ivec3& n, int axis, auto&& visit)
{
    const std::array<int, 3> stride{n.y * n.z, n.z, 1};
    const int a = axis == 0 ? 1 : 0, b = axis == 2 ? 1 : 2;
    for (int i = 0; i < n[a]; ++i)
        for (int j = 0; j < n[b]; ++j)
            visit(i * stride[at(a)] + j * stride[at(b)], stride[at(axis)]);
}

// Computes the coefficient of t^m in Bernstein polynomial i at t + 1/2, at [m][i].
using Powers = std::array<std::array<double, max_order>, max_order>;
Powers bernstein_powers(int order)
{
    Powers out{};
    for (int i = 0; i < order; ++i) {
        std::array<double, max_order> p{multinomial(order - 1, i, 0)};
        for (int f = 0; f < order - 1; ++f)
            for (int m = order - 1; m >= 0; --m)
                p[at(m)] = p[at(m)] / 2 + (m > 0 ? (f < i ? p[at(m - 1)] : -p[at(m - 1)]) : 0);
        for (int m = 0; m < order; ++m) out[at(m)][at(i)] = p[at(m)];
    }
    return out;
}

} // namespace

// A Taylor is the expansion up to the third order; the second and third order are symmetric forms.
struct CubicError::Taylor {
    glm::dvec4 value;
    std::array<glm::dvec4, 3> first;
    std::array<std::array<glm::dvec4, 3>, 3> second;
    std::array<std::array<std::array<glm::dvec4, 3>, 3>, 3> third;
    double left_out = 0;
};

CubicError::CubicError(const DisplacementCells::Cell& cell, const glm::ivec3& orders)
    : orders_(orders)
{
    std::copy_n(cell.points.begin(), orders.x * orders.y * orders.z, power_.begin());
    for (int a = 0; a < 3; ++a) {
        const Powers powers = bernstein_powers(orders[a]);
        each_line(orders, a, [&](int first, int stride) {
            std::array<glm::dvec4, max_order> row;
            for (int i = 0; i < orders[a]; ++i) row[at(i)] = power_[at(first + i * stride)];
            for (int m = 0; m < orders[a]; ++m) {
                glm::dvec4 sum(0);
                for (int i = 0; i < orders[a]; ++i) sum += row[at(i)] * powers[at(m)][at(i)];
                power_[at(first + m * stride)] = sum;
            }
        });
    }
}

CubicError::Taylor CubicError::round(const glm::dvec3& middle, const glm::dvec3& reach) const
{
    // Shifts the origin, p(t + middle), along each axis by repeated Horner's rule.
    Points p;
    std::copy_n(power_.begin(), orders_.x * orders_.y * orders_.z, p.begin());
    for (int a = 0; a < 3; ++a)
        each_line(orders_, a, [&](int first, int stride) {
            for (int s = 0; s < orders_[a] - 1; ++s)
                for (int m = orders_[a] - 2; m >= s; --m)
                    p[at(first + m * stride)] += p[at(first + (m + 1) * stride)] * middle[a];
        });
    Taylor out;
    out.first.fill(glm::dvec4(0));
    for (auto& row : out.second) row.fill(glm::dvec4(0));
    for (auto& plane : out.third)
        for (auto& row : plane) row.fill(glm::dvec4(0));
    std::array<std::array<double, max_order>, 3> power{};
    for (int a = 0; a < 3; ++a) {
        power[at(a)][0] = 1;
        for (int m = 1; m < orders_[a]; ++m)
            power[at(a)][at(m)] = power[at(a)][at(m - 1)] * reach[a];
    }
    const glm::dvec4* from = p.data();
    for (int i = 0; i < orders_.x; ++i)
        for (int j = 0; j < orders_.y; ++j)
            for (int k = 0; k < orders_.z; ++k, ++from) {
                const int total = i + j + k;
                if (total > 3) {
                    const glm::dvec4 size = glm::abs(*from); // at least its length
                    out.left_out += (size.x + size.y + size.z) * power[0][at(i)] * power[1][at(j)] *
                                    power[2][at(k)];
                    continue;
                }
                // Lists the axes of the term, with multiplicity.
                std::array<std::size_t, 3> axes{};
                int n = 0;
                for (int c = 0; c < i; ++c) axes[at(n++)] = 0;
                for (int c = 0; c < j; ++c) axes[at(n++)] = 1;
                for (int c = 0; c < k; ++c) axes[at(n++)] = 2;
                const auto [x, y, z] = axes;
                if (total == 0) out.value = *from;
                if (total == 1) out.first[x] = *from;
                if (total < 2) continue;
                if (total == 2) {
                    out.second[x][y] = out.second[y][x] = *from * (x == y ? 1 : 0.5);
                    continue;
                }
                const glm::dvec4 share = *from / (x == z ? 1.0 : x == y || y == z ? 3.0 : 6.0);
                out.third[x][y][z] = out.third[x][z][y] = out.third[y][x][z] = out.third[y][z][x] =
                    out.third[z][x][y] = out.third[z][y][x] = share;
            }
    return out;
}

template <std::size_t corners>
CubicError::Bound CubicError::operator()(const std::array<glm::dvec3, corners>& local,
                                         const std::array<glm::dvec3, corners>& linear) const
{
    glm::dvec3 lo = local[0], hi = local[0];
    for (const glm::dvec3& x : local) {
        lo = glm::min(lo, x);
        hi = glm::max(hi, x);
    }
    const glm::dvec3 middle = (lo + hi) / 2.0;
    const Taylor f = round(middle - 0.5, (hi - lo) / 2.0);

    // With a_i the value and first order in corner i minus the linear function there, and the
    // symmetric forms B and T: e_ijk = (a_i + a_j + a_k + B_ij + B_jk + B_ki) / 3 + T_ijk.
    std::array<glm::dvec3, corners> x;
    for (std::size_t i = 0; i < corners; ++i) x[i] = local[i] - middle;
    std::array<std::array<glm::dvec4, corners>, corners> b;
    std::array<std::array<std::array<glm::dvec4, 3>, corners>, corners> t;
    for (std::size_t i = 0; i < corners; ++i) {
        std::array<glm::dvec4, 3> bx;
        std::array<std::array<glm::dvec4, 3>, 3> tx;
        const auto along = [&](const std::array<glm::dvec4, 3>& v) {
            return v[0] * x[i].x + v[1] * x[i].y + v[2] * x[i].z;
        };
        for (std::size_t p = 0; p < 3; ++p) {
            bx[p] = along(f.second[p]);
            for (std::size_t q = p; q < 3; ++q) tx[p][q] = tx[q][p] = along(f.third[p][q]);
        }
        for (std::size_t j = i; j < corners; ++j) {
            const glm::dvec3& y = x[j];
            b[i][j] = b[j][i] = bx[0] * y.x + bx[1] * y.y + bx[2] * y.z;
            for (std::size_t p = 0; p < 3; ++p)
                t[i][j][p] = t[j][i][p] = tx[0][p] * y.x + tx[1][p] * y.y + tx[2][p] * y.z;
        }
    }
    const auto third = [&](std::size_t i, std::size_t j, std::size_t k) {
        return t[i][j][0] * x[k].x + t[i][j][1] * x[k].y + t[i][j][2] * x[k].z;
    };
    std::array<glm::dvec4, corners> a;
    for (std::size_t i = 0; i < corners; ++i)
        a[i] = f.value + f.first[0] * x[i].x + f.first[1] * x[i].y + f.first[2] * x[i].z -
               glm::dvec4(linear[i], 0);
    constexpr std::integral_constant<int, 3> degree;
    std::array<glm::dvec4, at(net_size<int{corners}>(degree))> net;
    each_term<int{corners}>(degree, [&](int index, int r, int c) {
        // Index of corner 0 is 3 - r times, of corner 1 r - c times, of corner 2 c times.
        const auto corner = [&](int n) { return at((n >= 3 - r) + (n >= 3 - c)); };
        const std::size_t i = corner(0), j = corner(1), k = corner(2);
        net[at(index)] = (a[i] + a[j] + a[k] + b[i][j] + b[j][k] + b[k][i]) / 3.0 + third(i, j, k);
    });
    // With these levels the net is within some 3 % of the function.
    constexpr int levels = corners == 3 ? 4 : 2;
    return {std::sqrt(longest_squared<int{corners}>(net, degree, levels, 0)), f.left_out};
}

template CubicError::Bound CubicError::operator()(const std::array<glm::dvec3, 2>&,
                                                  const std::array<glm::dvec3, 2>&) const;
template CubicError::Bound CubicError::operator()(const std::array<glm::dvec3, 3>&,
                                                  const std::array<glm::dvec3, 3>&) const;

} // namespace trivar
