// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/volume_frame.h"

#include "core/base/finite.h"

namespace trivar {

bool spans_space(const VolumeFrame& frame)
{
    constexpr double largest = 1e12, least = 1e-12; // in units; between them products stay exact
    constexpr double flattest = 1e-6;               // volume of three unit steps
    if (!finite(frame.origin) || glm::length(frame.origin) > largest) return false;
    glm::dmat3 units;
    for (int k = 0; k < 3; ++k) {
        const double length = finite(frame.steps[k]) ? glm::length(frame.steps[k]) : 0;
        if (!(length >= least && length <= largest)) return false;
        units[k] = frame.steps[k] / length;
    }
    return glm::abs(glm::determinant(units)) > flattest;
}

glm::dmat4 to_metres_of(const VolumeFrame& frame, double metres_per_unit)
{
    glm::dmat4 matrix(1);
    for (int k = 0; k < 3; ++k) matrix[k] = glm::dvec4(frame.steps[k] * metres_per_unit, 0);
    matrix[3] = glm::dvec4(frame.origin * metres_per_unit, 1);
    return matrix;
}

} // namespace trivar
