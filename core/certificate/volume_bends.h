// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"
#include "core/ffd/lattice.h"
#include "core/refinement/displacement_cells.h"

#include <map>
#include <memory>

namespace trivar {

// VolumeBends bounds how much a volume bends in boxes of its parameters, from the Bezier points of
// its cells; each cell is looked at once. Units are world units per unit of u, v and w. Not
// thread-safe.
class VolumeBends {
public:
    explicit VolumeBends(const Lattice& lattice);

    struct Bend {
        std::array<double, 6> second{}; // lengths of F_uu, F_vv, F_ww, F_uv, F_vw, F_wu
        glm::dvec3 kink{0};             // sum of the changes of F_u, F_v, F_w where cells meet
        // The largest distance of F from its chord on a straight line in the box, where the line is
        // at most `step` long in u, v and w.
        double off_chord(const glm::dvec3& step) const;
        // The same for a whole triangle; p and q are its edges from one of its corners: 1/8 (M1 + 2
        // M2 + M3), and a quarter of a kink times its extent.
        double off_triangle(const glm::dvec3& p, const glm::dvec3& q) const;
    };
    // infinite where the map jumps, or where the box covers very many cells
    Bend over(const Box& uvw);

    const glm::dvec3& slopes() const { return slopes_; } // largest derivative of F by u, v and w

private:
    const std::array<double, 6>& cell(const glm::ivec3& slabs);
    double kink(int axis, const glm::ivec3& slabs);

    DisplacementCells cells_;
    glm::dvec3 slopes_{0};
    std::map<std::array<int, 3>, std::array<double, 6>> known_;
    std::map<std::array<int, 4>, double> kinks_; // by axis and the slabs that follow it
};

// Returns a bend at least as large as both, and so as any mean of the two.
VolumeBends::Bend greater(const VolumeBends::Bend& a, const VolumeBends::Bend& b);

} // namespace trivar
