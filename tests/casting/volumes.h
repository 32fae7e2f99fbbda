// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/casting/casting.h"

#include <functional>

namespace trivar::testing {

// Data with these values at the points of a grid, as they are read from a file.
Ref<VoxelGrid> grid_of(const glm::ivec3& size, const std::function<double(glm::dvec3)>& value);
// The same with a range of 0 to 200 in whole numbers of 8 bits.
Ref<VoxelGrid> bytes_of(const glm::ivec3& size, const std::function<double(glm::dvec3)>& value);

// A ball with dense and clear shells, 0 to 200.
double shells(const glm::dvec3& p, const glm::dvec3& middle);

Ref<VoxelField> field_of(const Ref<VoxelGrid>& grid, FieldOrder order = FieldOrder::cubic);

// Returns points from clear to a dense red and a denser blue, over 0 to 200.
std::vector<TransferPoint> red_and_blue();

} // namespace trivar::testing
