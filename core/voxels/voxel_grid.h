// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"

#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <variant>
#include <vector>

namespace trivar {

// A VoxelGrid is volume data: samples of a scalar on a regular grid, as they were read. Sample
// (i, j, k), x fastest, lies at the point (i, j, k) of voxel space; its value is
// slope * sample + intercept.
struct VoxelGrid {
    using Samples =
        std::variant<std::vector<std::uint8_t>, std::vector<std::int8_t>,
                     std::vector<std::uint16_t>, std::vector<std::int16_t>, std::vector<float>>;
    glm::ivec3 size{0}; // number of samples along each axis, at least 2
    Samples samples;
    double slope = 1, intercept = 0; // slope is not 0
    std::string value_unit;          // "HU" of CT data, or empty: unknown
    // Voxel space to metres: x to the patient's left, y to the back, z to the head where the file
    // tells (LPS, as in DICOM); else along the grid's axes. Its columns may be oblique.
    glm::dmat4 to_metres{1};
    // Sentences for the user on changes made while reading the file, and on doubts.
    std::vector<std::string> notices;

    std::size_t count() const
    {
        return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) *
               static_cast<std::size_t>(size.z);
    }
    std::size_t bytes() const
    {
        return std::visit([](const auto& all) { return all.size() * sizeof(all[0]); }, samples);
    }
    double value(double sample) const { return slope * sample + intercept; }
    double sample(double value) const { return (value - intercept) / slope; }
    bool operator==(const VoxelGrid&) const = default;
};

} // namespace trivar
