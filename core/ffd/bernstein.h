// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <glm/glm.hpp>
#include <vector>

namespace trivar {

// A Bernstein is a scalar polynomial over [0, 1]^3 in tensor-product Bernstein form. Its
// coefficients bound it, and the coefficients of the eight corners are its values there.
struct Bernstein {
    std::array<int, 3> degree{};
    std::vector<double> coefficients; // product of (degree + 1), last axis fastest
};

double value(const Bernstein& f, const glm::dvec3& x); // x in [0, 1]^3

// Both halves along one axis, each over [0, 1]^3 again (de Casteljau).
std::array<Bernstein, 2> halves(const Bernstein& f, std::size_t axis);

} // namespace trivar
