// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplex/multi_index.h"

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace trivar {

// A CellInterpolation makes polynomials of a degree (1..3) in a tetrahedron from their values at
// nodes, one per multi-index b, at barycentric coordinates b / degree.
class CellInterpolation {
public:
    explicit CellInterpolation(int degree);

    // Barycentric coordinates of the nodes.
    const std::vector<glm::dvec4>& nodes() const { return nodes_; }
    // Bezier coefficients, by multi-index. O(number of nodes squared): 0.5 us for degree 3.
    std::vector<glm::dvec3> coefficients(std::span<const glm::dvec3> values) const;
    // The polar form of the polynomial with those coefficients at `degree` arguments, by their
    // barycentric coordinates: symmetric, affine in each, and the polynomial where all are equal.
    glm::dvec3 polar_form(std::span<const glm::dvec3> coefficients,
                          std::span<const glm::dvec4> arguments) const;

private:
    int degree_;
    std::vector<glm::dvec4> nodes_;
    std::vector<double> inverse_; // of Bernstein polynomials (columns) at nodes (rows)
};

} // namespace trivar
