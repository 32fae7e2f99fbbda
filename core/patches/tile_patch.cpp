// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/patches/tile_patch.h"

namespace trivar {
namespace {

struct CubicBasis {
    std::array<double, 4> value, derivative;
};

constexpr CubicBasis cubic_basis(double t)
{
    const double s = 1 - t;
    return {{s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t},
            {-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t}};
}

using Rows = std::array<std::array<double, 4>, 4>;

// Row i gives control point i from the values at the nodes. The outer control points are values;
// the inner ones solve two equations.
constexpr Rows from_nodes()
{
    const auto a = cubic_basis(patch_nodes[1]).value, b = cubic_basis(patch_nodes[2]).value;
    const double w = 1 / (a[1] * b[2] - a[2] * b[1]);
    const double i00 = w * b[2], i01 = -w * a[2], i10 = -w * b[1], i11 = w * a[1];
    return {{{1, 0, 0, 0},
             {-i00 * a[0] - i01 * b[0], i00, i01, -i00 * a[3] - i01 * b[3]},
             {-i10 * a[0] - i11 * b[0], i10, i11, -i10 * a[3] - i11 * b[3]},
             {0, 0, 0, 1}}};
}

struct PatchPoint {
    glm::dvec3 value{0}, x{0}, y{0};
};

PatchPoint patch_point(const std::array<glm::dvec3, 16>& c, const CubicBasis& x,
                       const CubicBasis& y)
{
    PatchPoint out;
    for (std::size_t j = 0; j < 4; ++j) {
        glm::dvec3 row(0), row_x(0);
        for (std::size_t i = 0; i < 4; ++i) {
            row += x.value[i] * c[4 * j + i];
            row_x += x.derivative[i] * c[4 * j + i];
        }
        out.value += y.value[j] * row;
        out.x += y.value[j] * row_x;
        out.y += y.derivative[j] * row;
    }
    return out;
}

} // namespace

std::array<glm::dvec3, 16> through_nodes(const std::array<glm::dvec3, 16>& values)
{
    static constexpr Rows rows = from_nodes();
    std::array<glm::dvec3, 16> along_x{}, out{};
    for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t k = 0; k < 4; ++k)
                along_x[4 * j + i] += rows[i][k] * values[4 * j + k];
    for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t k = 0; k < 4; ++k) out[4 * j + i] += rows[j][k] * along_x[4 * k + i];
    return out;
}

TilePoint tile_point(const TilePatch& patch, const glm::dvec3& p_tile)
{
    const CubicBasis x = cubic_basis(p_tile.x), y = cubic_basis(p_tile.y);
    const PatchPoint p = patch_point(patch.p, x, y), n = patch_point(patch.n, x, y);
    return {p.value + p_tile.z * n.value, p.x + p_tile.z * n.x, p.y + p_tile.z * n.y, n.value};
}

} // namespace trivar
