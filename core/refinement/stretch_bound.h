// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/embedding.h"
#include "core/refinement/displacement_cells.h"

namespace trivar {

// A StretchBound holds, for every cell of a volume, a number that the spectral norm of the Jacobian
// of to_rest(p) + displacement(to_uvw(p)) by p exceeds nowhere in the cell. The greatest number of
// the cells of a box is a Lipschitz constant of the volume over that box.
//
// In a cell each derivative by u, v and w lies in the convex hull of the scaled differences of its
// Bezier points. With M the Jacobian that their means give and r_a the furthest distance of a
// difference along axis a from its mean,
//
//   |J| <= |M| + (sum_a (r_a |row a of to_uvw|)^2)^(1/2).
class StretchBound {
public:
    // O(number of cells), in parallel.
    StretchBound(const DisplacementCells& cells, const Embedding& embedding);

    // The greatest stretch over a box of parameters; infinite where the volume jumps inside of it.
    double over(const glm::dvec3& least_uvw, const glm::dvec3& most_uvw) const;
    double most() const { return most_; } // over all parameters, jumps left aside

private:
    // The slabs of an axis between which its stretch differs: those of an open axis with one
    // beyond either end, those of one period, or of two periods of a twisted axis.
    struct Axis {
        AxisSlabs slabs;
        int first, count;
    };
    static Axis axis_of(const AxisSlabs& slabs);

    std::array<Axis, 3> axes_;
    std::vector<double> stretch_; // by the cell's slabs from `first` on, w fastest
    double most_ = 0;
};

} // namespace trivar
