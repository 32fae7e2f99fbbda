// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing here may be fused: products are rounded before they are added, so that both directions of
// a line give the same bits. The whole of core is compiled without contraction.
#include "core/tiles/covering.h"

#include <cmath>

namespace trivar {
namespace {

// The values and derivatives at 1 - t are those at t from behind, the derivatives' signs changed.
struct MirroredBasis {
    std::array<double, 4> value, derivative;
};

MirroredBasis mirrored_basis(double t)
{
    const double s = 1 - t, ss = s * s, tt = t * t, st = s * t;
    return {{ss * s, 3 * (ss * t), 3 * (tt * s), tt * t},
            {-3 * ss, 3 * (ss - 2 * st), 3 * (2 * st - tt), 3 * tt}};
}

glm::dvec3 mirrored_sum(const std::array<double, 4>& b, const std::array<glm::dvec3, 4>& c)
{
    return (b[0] * c[0] + b[3] * c[3]) + (b[1] * c[1] + b[2] * c[2]);
}

struct NetPoint {
    glm::dvec3 value, x, y;
};

NetPoint net_point(const std::array<glm::dvec3, 16>& c, const MirroredBasis& x,
                   const MirroredBasis& y)
{
    std::array<glm::dvec3, 4> rows{}, rows_x{};
    for (std::size_t j = 0; j < 4; ++j) {
        const std::array<glm::dvec3, 4> row{c[4 * j], c[4 * j + 1], c[4 * j + 2], c[4 * j + 3]};
        rows[j] = mirrored_sum(x.value, row);
        rows_x[j] = mirrored_sum(x.derivative, row);
    }
    return {mirrored_sum(y.value, rows), mirrored_sum(y.value, rows_x),
            mirrored_sum(y.derivative, rows)};
}

} // namespace

double snapped(double t)
{
    constexpr double parts = 1 << 20;
    return std::round(t * parts) / parts;
}

TilePoint symmetric_tile_point(const TilePatch& patch, const glm::dvec3& p_tile)
{
    const MirroredBasis x = mirrored_basis(p_tile.x), y = mirrored_basis(p_tile.y);
    const NetPoint p = net_point(patch.p, x, y), n = net_point(patch.n, x, y);
    return {p.value + p_tile.z * n.value, p.x + p_tile.z * n.x, p.y + p_tile.z * n.y, n.value};
}

} // namespace trivar
