// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/patches/patches.h"

namespace trivar::testing {

PlacedTile random_tile(std::mt19937& random, const glm::dvec3& near, double size)
{
    std::normal_distribution<double> number;
    const auto some = [&] { return glm::dvec3(number(random), number(random), number(random)); };
    const glm::dvec3 z = glm::normalize(some()), x = glm::normalize(glm::cross(z, some())),
                     y = glm::cross(z, x);
    const glm::dvec3 at = near + 3 * size * some();
    PlacedTile out;
    for (std::size_t k = 0; k < 16; ++k) {
        const double u = static_cast<double>(k % 4) / 3, v = static_cast<double>(k / 4) / 3;
        out.patch.p[k] = at + size * (u * x + v * y + 0.05 * some());
        out.patch.n[k] = z + 0.15 * some();
    }
    out.height = 0.8 * size;
    out.base = -0.1 * size;
    return out;
}

std::vector<PlacedTile> random_tiles(int count, const glm::dvec3& near, double size)
{
    std::mt19937 random(7);
    std::vector<PlacedTile> out;
    for (int i = 0; i < count; ++i) out.push_back(random_tile(random, near, size));
    return out;
}

BentPoint bent_point(const PlacedTile& tile, const glm::dvec3& p_unit, const glm::dvec3& n)
{
    const TilePoint t =
        tile_point(tile.patch, {p_unit.x, p_unit.y, tile.height * p_unit.z + tile.base});
    const glm::dvec3 z = tile.height * t.z;
    return {t.p, glm::normalize(n.x * glm::cross(t.y, z) + n.y * glm::cross(z, t.x) +
                                n.z * glm::cross(t.x, t.y))};
}

} // namespace trivar::testing
