// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/patches/placed_tile.h"

#include <algorithm>
#include <cmath>

namespace trivar {
namespace {

using Net = std::array<glm::dvec3, 16>;
using Matrix4 = std::array<std::array<double, 4>, 4>;

// The rows of a matrix times the control points, along both axes.
Net along_both(const Matrix4& x, const Matrix4& y, const Net& net)
{
    Net along_x{}, out{};
    for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t k = 0; k < 4; ++k) along_x[4 * j + i] += x[i][k] * net[4 * j + k];
    for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t k = 0; k < 4; ++k) out[4 * j + i] += y[j][k] * along_x[4 * k + i];
    return out;
}

constexpr Matrix4 to_powers{{{1, 0, 0, 0}, {-3, 3, 0, 0}, {3, -6, 3, 0}, {-1, 3, -3, 1}}};

// Row k gives control point k of a cubic over [lo, hi] from those over [0, 1]: the value of its
// polar form at 3 - k times lo and k times hi.
Matrix4 over_interval(double lo, double hi)
{
    Matrix4 out{};
    for (std::size_t k = 0; k < 4; ++k) {
        std::array<double, 4> weights{1, 0, 0, 0};
        for (std::size_t step = 0; step < 3; ++step) {
            const double t = step < k ? hi : lo;
            std::array<double, 4> next{};
            for (std::size_t i = 0; i <= step; ++i) {
                next[i] += (1 - t) * weights[i];
                next[i + 1] += t * weights[i];
            }
            weights = next;
        }
        out[k] = weights;
    }
    return out;
}

// The patches of T(x, y, z) = p + z n.
struct Nets {
    Net p, n;
};

Nets with_height(const PlacedTile& tile)
{
    Nets out{tile.patch.p, tile.patch.n};
    for (std::size_t i = 0; i < 16; ++i) {
        out.p[i] += tile.base * tile.patch.n[i];
        out.n[i] *= tile.height;
    }
    return out;
}

Nets over(const PlacedTile& tile, const Box& unit)
{
    const Matrix4 x = over_interval(unit.lo.x, unit.hi.x), y = over_interval(unit.lo.y, unit.hi.y);
    const Nets whole = with_height(tile);
    return {along_both(x, y, whole.p), along_both(x, y, whole.n)};
}

double largest_step(const Net& net, std::size_t apart)
{
    double most = 0;
    for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t at = apart == 1 ? 4 * j + i : 4 * i + j;
            most = std::max(most, glm::length(net[at + apart] - net[at]));
        }
    return most;
}

} // namespace

TilePowers powers_of(const PlacedTile& tile)
{
    Nets nets = with_height(tile);
    TilePowers out;
    out.origin = nets.p[0];
    for (glm::dvec3& p : nets.p) p -= out.origin;
    const Net p = along_both(to_powers, to_powers, nets.p),
              n = along_both(to_powers, to_powers, nets.n);
    double most = 0;
    for (std::size_t i = 0; i < 16; ++i)
        for (int k = 0; k < 3; ++k)
            most = std::max({most, std::abs(nets.p[i][k]), std::abs(nets.n[i][k])});
    const int power = most > 0 && std::isfinite(most) ? std::clamp(std::ilogb(most), -120, 120) : 0;
    out.scale = std::ldexp(1.0f, power);
    const double smaller = std::ldexp(1.0, -power);
    for (std::size_t i = 0; i < 16; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            out.c[k][i] = static_cast<float>(smaller * p[i][static_cast<int>(k)]);
            out.c[3 + k][i] = static_cast<float>(smaller * n[i][static_cast<int>(k)]);
        }
    return out;
}

Box hull_box(const PlacedTile& tile, const Box& unit)
{
    Box out;
    if (unit.empty()) return out;
    const Nets nets = over(tile, unit);
    Box p, n;
    for (std::size_t i = 0; i < 16; ++i) {
        p.add(nets.p[i]);
        n.add(nets.n[i]);
    }
    const glm::dvec3 a = unit.lo.z * n.lo, b = unit.lo.z * n.hi, c = unit.hi.z * n.lo,
                     d = unit.hi.z * n.hi;
    out.lo = p.lo + glm::min(glm::min(a, b), glm::min(c, d));
    out.hi = p.hi + glm::max(glm::max(a, b), glm::max(c, d));
    // Single precision of the tile, and of where it stands.
    const glm::dvec3 slack =
        1e-6 * (out.hi - out.lo) + 1e-7 * glm::max(glm::abs(out.lo), glm::abs(out.hi));
    out.lo -= slack;
    out.hi += slack;
    return out;
}

double stretch_bound(const PlacedTile& tile, const Box& unit)
{
    if (unit.empty()) return 0;
    const Nets nets = over(tile, unit);
    const glm::dvec3 size = glm::max(unit.hi - unit.lo, glm::dvec3(1e-9));
    const double high = std::max(std::abs(unit.lo.z), std::abs(unit.hi.z));
    const double x = 3 * (largest_step(nets.p, 1) + high * largest_step(nets.n, 1)) / size.x;
    const double y = 3 * (largest_step(nets.p, 4) + high * largest_step(nets.n, 4)) / size.y;
    double z = 0;
    for (const glm::dvec3& n : nets.n) z = std::max(z, glm::length(n));
    return std::sqrt(x * x + y * y + z * z);
}

} // namespace trivar
