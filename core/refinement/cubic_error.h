// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/refinement/displacement_cells.h"

namespace trivar {

// CubicError is a short way to the composed net of a piece that is small in its cell. It takes the
// terms up to third order of the Taylor polynomial about the piece's middle, whose net has ten
// points (four on an edge) and is cheap to cut up finely, and bounds the sum of all other terms.
class CubicError {
public:
    // Takes the cell's polynomial about the middle of the cell.
    CubicError(const DisplacementCells::Cell& cell, const glm::ivec3& orders);

    struct Bound {
        double error = 0;    // of the terms up to third order
        double left_out = 0; // the most that the other terms may add
    };
    // The corners lie in the cell, 0 to 1 along each axis. `linear` holds the corners of the linear
    // function from which the error is measured.
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
