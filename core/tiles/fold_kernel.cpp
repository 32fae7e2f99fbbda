// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tiles/fold_kernel.h"

#include <algorithm>
#include <limits>

// This file is compiled once for each instruction set, as core/patches/tile_kernel.cpp is.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/tiles/fold_kernel.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace trivar {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// A lane holds a tile, or a coefficient of one.
using Lanes = hn::CappedTag<double, most_folded>;
using Numbers = hn::Vec<Lanes>;

constexpr auto binomials = [] {
    std::array<std::array<double, 9>, 9> table{};
    for (std::size_t n = 0; n < 9; ++n) {
        table[n][0] = 1;
        for (std::size_t k = 1; k <= n; ++k)
            table[n][k] = table[n - 1][k - 1] + (k < n ? table[n - 1][k] : 0);
    }
    return table;
}();

// The components of points, each for as many tiles as there are lanes.
using PointLanes = std::array<std::array<double, most_folded>, 3>;
using NetLanes = std::array<PointLanes, 16>;

// Vectors are the vector-valued Bernstein coefficients of a polynomial of degree (p, q) times their
// binomials, so that products are plain convolutions.
template <std::size_t p, std::size_t q> struct Vectors {
    static constexpr std::size_t p_degree = p, q_degree = q;
    alignas(64) std::array<PointLanes, (p + 1) * (q + 1)> c;
};

template <std::size_t dx, std::size_t dy>
HWY_INLINE Vectors<3 - dx, 3 - dy> scaled(const NetLanes& from)
{
    const Lanes d;
    Vectors<3 - dx, 3 - dy> out;
    for (std::size_t j = 0; j + dy < 4; ++j)
        for (std::size_t i = 0; i + dx < 4; ++i) {
            const Numbers factor = hn::Set(d, binomials[3 - dx][i] * binomials[3 - dy][j]);
            for (std::size_t k = 0; k < 3; ++k) {
                Numbers value = hn::LoadU(d, from[4 * j + i][k].data());
                if (dx + dy > 0)
                    value = hn::Mul(
                        hn::Set(d, 3.0),
                        hn::Sub(hn::LoadU(d, from[4 * (j + dy) + i + dx][k].data()), value));
                hn::StoreU(hn::Mul(factor, value), d, out.c[j * (4 - dx) + i][k].data());
            }
        }
    return out;
}

// Adds the coefficient (i, j) of the cross product of two polynomials.
template <class A, class B>
HWY_INLINE void add_cross(const A& a, const B& b, std::size_t i, std::size_t j, Numbers& x,
                          Numbers& y, Numbers& z)
{
    const Lanes d;
    for (std::size_t m = j > B::q_degree ? j - B::q_degree : 0; m <= std::min(j, A::q_degree); ++m)
        for (std::size_t l = i > B::p_degree ? i - B::p_degree : 0; l <= std::min(i, A::p_degree);
             ++l) {
            const PointLanes& u = a.c[m * (A::p_degree + 1) + l];
            const PointLanes& v = b.c[(j - m) * (B::p_degree + 1) + i - l];
            const Numbers ux = hn::LoadU(d, u[0].data()), uy = hn::LoadU(d, u[1].data()),
                          uz = hn::LoadU(d, u[2].data()), vx = hn::LoadU(d, v[0].data()),
                          vy = hn::LoadU(d, v[1].data()), vz = hn::LoadU(d, v[2].data());
            x = hn::Add(x, hn::Sub(hn::Mul(uy, vz), hn::Mul(vy, uz)));
            y = hn::Add(y, hn::Sub(hn::Mul(uz, vx), hn::Mul(vz, ux)));
            z = hn::Add(z, hn::Sub(hn::Mul(ux, vy), hn::Mul(vx, uy)));
        }
}

using Crossed = Vectors<5, 5>;

HWY_INLINE void put(Crossed& to, std::size_t i, std::size_t j, Numbers x, Numbers y, Numbers z)
{
    const Lanes d;
    PointLanes& c = to.c[6 * j + i];
    hn::StoreU(x, d, c[0].data());
    hn::StoreU(y, d, c[1].data());
    hn::StoreU(z, d, c[2].data());
}

// The least positive root of a + b z + c z^2; infinity where there is none or all are zero, 0 where
// a is not positive.
HWY_INLINE Numbers least_root(Numbers a, Numbers b, Numbers c)
{
    const Lanes d;
    const Numbers zero = hn::Zero(d), none = hn::Set(d, std::numeric_limits<double>::infinity());
    const Numbers inside = hn::Sub(hn::Mul(b, b), hn::Mul(hn::Mul(hn::Set(d, 4.0), a), c));
    const Numbers root = hn::Sqrt(inside);
    const Numbers q =
        hn::Mul(hn::Set(d, -0.5), hn::Add(b, hn::IfThenElse(hn::Ge(b, zero), root, hn::Neg(root))));
    const Numbers first = hn::Div(a, q), second = hn::Div(q, c);
    const auto has_first = hn::And(hn::Ne(q, zero), hn::Gt(first, zero));
    Numbers least = hn::IfThenElse(has_first, first, none);
    const auto has_second =
        hn::And(hn::And(hn::Ne(c, zero), hn::Gt(second, zero)), hn::Lt(second, least));
    least = hn::IfThenElse(has_second, second, least);
    least = hn::IfThenElse(hn::Ge(inside, zero), least, none);
    least = hn::IfThenElse(hn::Gt(a, zero), least, zero);
    const auto vanishes = hn::And(hn::And(hn::Eq(a, zero), hn::Eq(b, zero)), hn::Eq(c, zero));
    return hn::IfThenElse(vanishes, none, least);
}

bool is_corner(std::size_t i)
{
    return i == 0 || i == 8 || i == 72 || i == 80;
}

// At most as many tiles as there are lanes.
HWY_NOINLINE void fold_lanes(std::span<const TilePatch> patches, std::span<FoldPiece> out)
{
    const Lanes d;
    alignas(64) NetLanes p, n;
    for (std::size_t lane = 0; lane < hn::Lanes(d); ++lane) {
        const TilePatch& patch = patches[std::min(lane, patches.size() - 1)];
        for (std::size_t i = 0; i < 16; ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                p[i][k][lane] = patch.p[i][static_cast<int>(k)];
                n[i][k][lane] = patch.n[i][static_cast<int>(k)];
            }
    }
    const auto px = scaled<1, 0>(p), nx = scaled<1, 0>(n);
    const auto py = scaled<0, 1>(p), ny = scaled<0, 1>(n);
    const auto up = scaled<0, 0>(n);
    Crossed a, b, c;
    for (std::size_t j = 0; j < 6; ++j)
        for (std::size_t i = 0; i < 6; ++i) {
            Numbers x = hn::Zero(d), y = hn::Zero(d), z = hn::Zero(d);
            add_cross(px, py, i, j, x, y, z);
            put(a, i, j, x, y, z);
            x = y = z = hn::Zero(d);
            add_cross(px, ny, i, j, x, y, z);
            add_cross(nx, py, i, j, x, y, z);
            put(b, i, j, x, y, z);
            x = y = z = hn::Zero(d);
            add_cross(nx, ny, i, j, x, y, z);
            put(c, i, j, x, y, z);
        }
    const Numbers none = hn::Set(d, std::numeric_limits<double>::infinity());
    Numbers limit = none, corner = none, largest = hn::Zero(d);
    alignas(64) std::array<std::array<std::array<double, most_folded>, FoldNet::count>, 3> nets;
    for (std::size_t j = 0; j < 9; ++j)
        for (std::size_t i = 0; i < 9; ++i) {
            Numbers sums[3] = {hn::Zero(d), hn::Zero(d), hn::Zero(d)};
            for (std::size_t m = j > 3 ? j - 3 : 0; m <= std::min<std::size_t>(j, 5); ++m)
                for (std::size_t l = i > 3 ? i - 3 : 0; l <= std::min<std::size_t>(i, 5); ++l) {
                    const PointLanes& v = up.c[4 * (j - m) + i - l];
                    const Numbers vx = hn::LoadU(d, v[0].data()), vy = hn::LoadU(d, v[1].data()),
                                  vz = hn::LoadU(d, v[2].data());
                    const auto dotted = [&](const Crossed& of) HWY_ATTR {
                        const PointLanes& u = of.c[6 * m + l];
                        return hn::Add(hn::Add(hn::Mul(hn::LoadU(d, u[0].data()), vx),
                                               hn::Mul(hn::LoadU(d, u[1].data()), vy)),
                                       hn::Mul(hn::LoadU(d, u[2].data()), vz));
                    };
                    sums[0] = hn::Add(sums[0], dotted(a));
                    sums[1] = hn::Add(sums[1], dotted(b));
                    sums[2] = hn::Add(sums[2], dotted(c));
                }
            const Numbers scale = hn::Set(d, binomials[8][i] * binomials[8][j]);
            const std::size_t at = 9 * j + i;
            for (std::size_t k = 0; k < 3; ++k) {
                sums[k] = hn::Div(sums[k], scale);
                largest = hn::IfThenElse(hn::Eq(sums[k], hn::Zero(d)), largest, hn::Set(d, 1.0));
                hn::StoreU(sums[k], d, nets[k][at].data());
            }
            const Numbers root = least_root(sums[0], sums[1], sums[2]);
            limit = hn::IfThenElse(hn::Lt(root, limit), root, limit);
            if (is_corner(at)) corner = hn::IfThenElse(hn::Lt(root, corner), root, corner);
        }
    alignas(64) std::array<double, most_folded> limits, corners, any;
    hn::StoreU(limit, d, limits.data());
    hn::StoreU(corner, d, corners.data());
    hn::StoreU(largest, d, any.data());
    for (std::size_t lane = 0; lane < patches.size(); ++lane) {
        FoldPiece& piece = out[lane];
        piece.limit = limits[lane];
        piece.corner = corners[lane];
        piece.vanishes = any[lane] == 0;
        for (std::size_t i = 0; i < FoldNet::count; ++i) {
            piece.net.a[i] = nets[0][i][lane];
            piece.net.b[i] = nets[1][i][lane];
            piece.net.c[i] = nets[2][i][lane];
        }
    }
}

void fold_pieces_on_target(std::span<const TilePatch> patches, std::span<FoldPiece> out)
{
    const std::size_t lanes = hn::Lanes(Lanes());
    for (std::size_t i = 0; i < patches.size(); i += lanes) {
        const std::size_t count = std::min(lanes, patches.size() - i);
        fold_lanes(patches.subspan(i, count), out.subspan(i, count));
    }
}

// The three nets side by side, so that a step of de Casteljau's algorithm works on whole rows.
constexpr std::size_t width = 32;
using Rows = std::array<std::array<double, width>, 9>;

struct RowHalves {
    Rows lower, upper;
};

HWY_INLINE RowHalves halves(const Rows& in)
{
    const Lanes d;
    const Numbers half = hn::Set(d, 0.5);
    RowHalves out;
    for (std::size_t at = 0; at < width; at += hn::Lanes(d)) {
        Numbers t[9];
        for (std::size_t k = 0; k < 9; ++k) t[k] = hn::LoadU(d, in[k].data() + at);
        HWY_UNROLL(9)
        for (std::size_t step = 0; step < 9; ++step) {
            hn::StoreU(t[0], d, out.lower[step].data() + at);
            hn::StoreU(t[8 - step], d, out.upper[8 - step].data() + at);
            for (std::size_t k = 0; k + step < 8; ++k)
                t[k] = hn::Mul(half, hn::Add(t[k], t[k + 1]));
        }
    }
    return out;
}

// Rows become columns, in each of the nets.
HWY_INLINE Rows transposed(const Rows& in)
{
    Rows out{};
    for (std::size_t net = 0; net < 3; ++net)
        for (std::size_t j = 0; j < 9; ++j)
            for (std::size_t i = 0; i < 9; ++i) out[i][9 * net + j] = in[j][9 * net + i];
    return out;
}

HWY_INLINE void take(const Rows& rows, FoldPiece& out)
{
    for (std::size_t j = 0; j < 9; ++j) {
        std::copy_n(rows[j].data(), 9, out.net.a.data() + 9 * j);
        std::copy_n(rows[j].data() + 9, 9, out.net.b.data() + 9 * j);
        std::copy_n(rows[j].data() + 18, 9, out.net.c.data() + 9 * j);
    }
    const Lanes d;
    Numbers limit = hn::Set(d, std::numeric_limits<double>::infinity());
    alignas(64) std::array<double, FoldNet::room> roots;
    for (std::size_t i = 0; i < FoldNet::room; i += hn::Lanes(d)) {
        const Numbers root =
            least_root(hn::LoadU(d, out.net.a.data() + i), hn::LoadU(d, out.net.b.data() + i),
                       hn::LoadU(d, out.net.c.data() + i));
        hn::StoreU(root, d, roots.data() + i);
        limit = hn::IfThenElse(hn::Lt(root, limit), root, limit);
    }
    alignas(64) std::array<double, most_folded> limits;
    hn::StoreU(limit, d, limits.data());
    out.limit = *std::min_element(limits.begin(), limits.begin() + hn::Lanes(d));
    out.corner = std::min({roots[0], roots[8], roots[72], roots[80]});
}

void quarters_on_target(const FoldNet& net, std::array<FoldPiece, 4>& out)
{
    Rows along_x{};
    for (std::size_t j = 0; j < 9; ++j)
        for (std::size_t i = 0; i < 9; ++i) {
            along_x[i][j] = net.a[9 * j + i];
            along_x[i][9 + j] = net.b[9 * j + i];
            along_x[i][18 + j] = net.c[9 * j + i];
        }
    const RowHalves sides = halves(along_x);
    for (std::size_t i = 0; i < 2; ++i) {
        const RowHalves parts = halves(transposed(i == 0 ? sides.lower : sides.upper));
        take(parts.lower, out[2 * i]);
        take(parts.upper, out[2 * i + 1]);
    }
}

} // namespace HWY_NAMESPACE
} // namespace trivar
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace trivar {

HWY_EXPORT(fold_pieces_on_target);
HWY_EXPORT(quarters_on_target);

void fold_pieces(std::span<const TilePatch> patches, std::span<FoldPiece> out)
{
    HWY_DYNAMIC_DISPATCH(fold_pieces_on_target)(patches, out);
}

std::array<FoldPiece, 4> quarters(const FoldNet& net)
{
    std::array<FoldPiece, 4> out;
    HWY_DYNAMIC_DISPATCH(quarters_on_target)(net, out);
    return out;
}

} // namespace trivar
#endif
