// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/refinement/displacement_cells.h"

namespace trivar {

// A short way to the composed net of a piece that is small in its cell: of the Taylor polynomial
// round its middle the terms up to third order, whose net has ten points (an edge's: four) and is
// cheap to cut up finely, and a bound of all that is left out.
class CubicError {
public:
    // Takes the cell's polynomial about the cell's middle.
    CubicError(const DisplacementCells::Cell& cell, const glm::ivec3& orders);

    struct Bound {
        double error = 0;    // of the terms up to third order
        double left_out = 0; // what the others may add
    };
    // Corners in the cell, 0 to 1 along each axis, and the linear function that the error is from.
    template <std::size_t corners>
    Bound operator()(const std::array<glm::dvec3, corners>& local,
                     const std::array<glm::dvec3, corners>& linear) const;

private:
    struct Taylor;
    Taylor round(const glm::dvec3& middle, const glm::dvec3& reach) const;

    glm::ivec3 orders_;
    std::array<glm::dvec4, max_order * max_order * max_order> power_; // w fastest
};

} // namespace trivar
