// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace trivar::testing {

// Samples of a function in n x n x n points, with a level worth looking at.
struct SampledField {
    glm::ivec3 size;
    std::vector<double> samples; // x fastest
    double level;
    double spacing; // of samples, in the units of the function
};
// "sphere" and "torus" over [-1.2, 1.2]^3, "gauss" (20 bumps, which do not reach the border) over
// [0, 1]^3, "waves" over [-1, 1]^3 [Marschner, Lobb 1994], and "noise".
SampledField sampled(const std::string& function, int n);

std::vector<float> in_single_precision(const std::vector<double>& samples);

} // namespace trivar::testing
