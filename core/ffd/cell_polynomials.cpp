// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/ffd/cell_polynomials.h"

#include "core/base/parallel.h"

#include <algorithm>
#include <cmath>

// This file is compiled once for each instruction set; see kernel.cpp.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/ffd/cell_polynomials.cpp"
#include <hwy/foreach_target.h>

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace trivar {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Tag = hn::CappedTag<double, 4>;
using Matrix = std::array<std::array<double, max_order>, max_order>;

// Returns sum_r matrix[m][r] in[r] for r < order.
template <int order>
HWY_INLINE hn::Vec<Tag> product(const Matrix& matrix, std::size_t m, const hn::Vec<Tag>* in)
{
    const Tag d;
    // The sum begins with +0, because then a sum of zeros is +0 whatever their signs.
    auto sum = hn::Zero(d);
    for (std::size_t r = 0; r < order; ++r) sum = hn::MulAdd(hn::Set(d, matrix[m][r]), in[r], sum);
    return sum;
}

// Computes out[m][x] = sum_r matrix[m][r] in[r][x] for x < length, a multiple of 4.
template <int order>
HWY_INLINE void contract_rows(const Matrix& matrix, const double* in, std::size_t in_stride,
                              std::size_t length, double* out, std::size_t out_stride)
{
    const Tag d;
    for (std::size_t x = 0; x < length; x += hn::Lanes(d)) {
        hn::Vec<Tag> row[order];
        HWY_UNROLL(6)
        for (std::size_t r = 0; r < order; ++r) row[r] = hn::LoadU(d, in + r * in_stride + x);
        HWY_UNROLL(6)
        for (std::size_t m = 0; m < order; ++m)
            hn::StoreU(product<order>(matrix, m, row), d, out + m * out_stride + x);
    }
}

HWY_ATTR void contract(int order, const Matrix& matrix, const double* in, std::size_t in_stride,
                       std::size_t length, double* out, std::size_t out_stride)
{
    switch (order) {
    case 2: return contract_rows<2>(matrix, in, in_stride, length, out, out_stride);
    case 3: return contract_rows<3>(matrix, in, in_stride, length, out, out_stride);
    case 4: return contract_rows<4>(matrix, in, in_stride, length, out, out_stride);
    case 5: return contract_rows<5>(matrix, in, in_stride, length, out, out_stride);
    default: return contract_rows<6>(matrix, in, in_stride, length, out, out_stride);
    }
}

// Computes the negated power form of one cell, highest powers first, in single precision. Returns
// the sum of the absolute values of all coefficients except the constants.
HWY_ATTR float to_power_form(const std::array<const AxisCells::Cell*, 3>& cell,
                             const std::array<int, 3>& order, const double* points,
                             const std::array<std::size_t, 2>& stride, float* out)
{
    constexpr std::size_t most = max_order * max_order * max_order * 4;
    HWY_ALIGN std::array<double, most> by_u, by_uv, by_uvw;
    const auto ou = static_cast<std::size_t>(order[0]), ov = static_cast<std::size_t>(order[1]),
               ow = static_cast<std::size_t>(order[2]);
    for (std::size_t j = 0; j < ov; ++j)
        contract(order[0], cell[0]->power, points + j * stride[1], stride[0], ow * 4,
                 by_u.data() + j * ow * 4, ov * ow * 4);
    for (std::size_t m = 0; m < ou; ++m)
        contract(order[1], cell[1]->power, by_u.data() + m * ov * ow * 4, ow * 4, ow * 4,
                 by_uv.data() + m * ov * ow * 4, ow * 4);
    for (std::size_t m = 0; m < ou * ov; ++m)
        contract(order[2], cell[2]->power, by_uv.data() + m * ow * 4, 4, 4,
                 by_uvw.data() + m * ow * 4, 4);

    const Tag d;
    const hn::Rebind<float, Tag> df;
    const std::size_t count = ou * ov * ow * 4;
    HWY_ALIGN std::array<float, 4> varying{};
    for (std::size_t lane = 0; lane < 4; lane += hn::Lanes(d)) {
        auto sum = hn::Zero(df);
        for (std::size_t i = 0; i < count; i += 4) {
            // 0 - x is +0 for both zeros; -x is not.
            const auto x = hn::Load(d, by_uvw.data() + count - 4 - i + lane);
            const auto negated = hn::DemoteTo(df, hn::Sub(hn::Zero(d), x));
            hn::StoreU(negated, df, out + i + lane);
            if (i + 4 < count) sum = hn::Add(sum, hn::Abs(negated));
        }
        hn::Store(sum, df, varying.data() + lane);
    }
    return varying[0] + varying[1] + varying[2];
}

} // namespace HWY_NAMESPACE
} // namespace trivar
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace trivar {
namespace {

HWY_EXPORT(to_power_form);

// UnwrappedPoints are control points by unwrapped index, four doubles each, so that cells need not
// wrap.
struct UnwrappedPoints {
    std::vector<double> points;
    std::array<std::size_t, 2> stride; // of u and v, in doubles
};

UnwrappedPoints unwrapped(const Trivariate<glm::dvec3>& f)
{
    const int nu = f.axes[0].unwrapped_count(), nv = f.axes[1].unwrapped_count(),
              nw = f.axes[2].unwrapped_count();
    const auto row = static_cast<std::size_t>(nw) * 4;
    UnwrappedPoints out{{}, {row * static_cast<std::size_t>(nv), row}};
    out.points.reserve(out.stride[0] * static_cast<std::size_t>(nu));
    for (int i = 0; i < nu; ++i)
        for (int j = 0; j < nv; ++j)
            for (int k = 0; k < nw; ++k) {
                const glm::dvec3& p = f.point(i, j, k);
                out.points.insert(out.points.end(), {p.x, p.y, p.z, 0.0});
            }
    return out;
}

CellPolynomials::Frame frame(const std::array<const AxisCells::Cell*, 3>& cell,
                             std::uint32_t mirrored, const Embedding& embedding, double varying)
{
    CellPolynomials::Frame out;
    out.still = varying == 0 && glm::dmat3(embedding.to_rest) == glm::dmat3(1);

    glm::dmat3 t_by_p(embedding.to_uvw);
    double steepest = 0, largest_rest = 0;
    for (int a = 0; a < 3; ++a)
        for (int x = 0; x < 3; ++x) {
            t_by_p[x][a] *=
                (mirrored >> a & 1 ? -1 : 1) * cell[static_cast<std::size_t>(a)]->per_unit;
            steepest = std::max(steepest, std::abs(t_by_p[x][a]));
            largest_rest = std::max(largest_rest, std::abs(embedding.to_rest[x][a]));
        }
    const double size = largest_rest + varying * steepest;
    const double scale = size > 0 && std::isfinite(size) ? std::exp2(-std::ilogb(size)) : 1;
    for (int a = 0; a < 3; ++a)
        for (int x = 0; x < 3; ++x) {
            const auto A = static_cast<std::size_t>(a), X = static_cast<std::size_t>(x);
            out.t_by_p[A][X] = static_cast<float>(t_by_p[x][a] * scale);
            out.rest[A][X] = static_cast<float>(embedding.to_rest[x][a] * scale);
        }
    return out;
}

} // namespace

CellPolynomials cell_polynomials(const Trivariate<glm::dvec3>& displacement,
                                 const std::array<AxisCells, 3>& axes,
                                 std::span<const SortedVertices::CellKey> cells,
                                 const Embedding& embedding)
{
    CellPolynomials out;
    for (std::size_t a = 0; a < 3; ++a) out.order[a] = displacement.axes[a].order();
    const std::size_t stride = out.stride();
    out.coefficients.resize(cells.size() * stride);
    out.frames.resize(cells.size());
    const UnwrappedPoints lattice = unwrapped(displacement);

    parallel_blocks(cells.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t c = begin; c < end; ++c) {
            std::array<const AxisCells::Cell*, 3> cell{};
            for (std::size_t a = 0; a < 3; ++a) cell[a] = &axes[a][cells[c].cell[a]];
            const double* first = lattice.points.data() +
                                  static_cast<std::size_t>(cell[0]->first) * lattice.stride[0] +
                                  static_cast<std::size_t>(cell[1]->first) * lattice.stride[1] +
                                  static_cast<std::size_t>(cell[2]->first) * 4;
            const float varying = HWY_DYNAMIC_DISPATCH(to_power_form)(
                cell, out.order, first, lattice.stride, out.coefficients.data() + c * stride);
            out.frames[c] = frame(cell, cells[c].mirrored, embedding, varying);
        }
    });
    return out;
}

} // namespace trivar
#endif
