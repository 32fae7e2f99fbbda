// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/voxels/volume_summary.h"

#include <array>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace trivar {

// A TransferPoint says how a value of volume data looks.
struct TransferPoint {
    double value = 0;   // of the data, in their own unit
    glm::vec3 color{1}; // sRGB
    // Share of the light that is held back by a layer as thick as a voxel (the cube root of the
    // volume of one), 0 to 1. Data need no unit of length for it, and look the same at any scale.
    double opacity = 0;
    bool operator==(const TransferPoint&) const = default;
};

// Returns the transfer function of points at a value: straight lines between points, and beyond
// them the value of the outermost one. The points may be in any order; of two at one value the
// later one is above it. sRGB and opacity; nothing for no points.
glm::vec4 transfer_at(std::span<const TransferPoint> points, double value);

// The same at the middles of 256 equal parts of [least, greatest], for drawing it.
std::array<glm::vec4, 256> transfer_colors(std::span<const TransferPoint> points, double least,
                                           double greatest);

// Makes a transfer function from the histogram. The values below the one that divides all values
// best [Otsu 1979] are empty. The part above is divided once more: the lower part has a thin warm
// skin and is nearly clear within, the upper one is dense and pale.
std::vector<TransferPoint> usual_transfer(const VolumeSummary& summary, const VoxelGrid& grid);

} // namespace trivar
