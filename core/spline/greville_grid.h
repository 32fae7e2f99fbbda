// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/surface.h"

namespace trivar {

// A GrevilleGrid is the nodes of a surface with open axes, one at each pair of its Greville
// abscissae, made ready to interpolate and to evaluate there many times: work that does not depend
// on the points is done once.
class GrevilleGrid {
public:
    // Throws Rejected where an axis cannot be interpolated: two of its Greville abscissae coincide.
    explicit GrevilleGrid(std::array<Knots, 2> axes);

    // The surface through values at the nodes, v fastest. Banded, O(nodes x order).
    Surface<glm::dvec3> through(std::vector<glm::dvec3> values) const;

    // The jets of control points at the nodes; `derivatives` as for evaluate(). O(nodes x order).
    std::vector<SurfaceJet<glm::dvec3>> jets(const std::vector<glm::dvec3>& points,
                                             int derivatives) const;

private:
    // Basis functions at the abscissae, and the factors of their band: below the diagonal those of
    // the rows subtracted, above it the rows that are left. No pivots are needed: every leading
    // minor is positive. [de Boor and Pinkus 1977]
    struct Axis {
        Axis(const Knots& knots);
        double& at(int row, int column);
        double at(int row, int column) const;
        int order, count;
        std::vector<Basis> basis;
        std::vector<double> band; // count x (2 order - 1)
    };
    std::array<Knots, 2> axes_;
    std::array<Axis, 2> tables_;
};

} // namespace trivar
