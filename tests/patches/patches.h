// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/patches/placed_tile.h"

#include <random>
#include <vector>

namespace trivar::testing {

// A patch of about that size near a place, moderately bent and turned: no two are alike.
PlacedTile random_tile(std::mt19937& random, const glm::dvec3& near, double size);
std::vector<PlacedTile> random_tiles(int count, const glm::dvec3& near = glm::dvec3(0),
                                     double size = 0.3);

// T at a point of the tile's unit cell, by the definition, with its exact normal for the normal n.
struct BentPoint {
    glm::dvec3 p, normal;
};
BentPoint bent_point(const PlacedTile& tile, const glm::dvec3& p_unit, const glm::dvec3& n);

} // namespace trivar::testing
