// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"
#include "core/ffd/lattice.h"
#include "core/refinement/displacement_cells.h"

#include <map>
#include <memory>

namespace trivar {

// How much a volume bends in boxes of its parameters, at most: from the Bezier points of its cells,
// each looked at once. World units by units of u, v and w. Not thread-safe.
class VolumeBends {
public:
    explicit VolumeBends(const Lattice& lattice);

    struct Bend {
        std::array<double, 6> second{}; // lengths of F_uu, F_vv, F_ww, F_uv, F_vw, F_wu
        glm::dvec3 kink{0}; // how much F_u, F_v, F_w change where cells meet, all of them together
        // How far F on a straight way in the box is from the chord of its ends, a way that is no
        // longer than `step` by u, v and w.
        double off_chord(const glm::dvec3& step) const;
        // The same for all of a triangle with such edges from one of its corners: 1/8 (M1 + 2 M2 +
        // M3), and a quarter of a kink times its extent.
        double off_triangle(const glm::dvec3& p, const glm::dvec3& q) const;
    };
    Bend over(const Box& uvw); // infinite where the map jumps, or over very many cells

    const glm::dvec3& slopes() const { return slopes_; } // of F by u, v, w, at most

private:
    const std::array<double, 6>& cell(const glm::ivec3& slabs);
    double kink(int axis, const glm::ivec3& slabs);

    DisplacementCells cells_;
    glm::dvec3 slopes_{0};
    std::map<std::array<int, 3>, std::array<double, 6>> known_;
    std::map<std::array<int, 4>, double> kinks_; // by axis and the slabs after it
};

// No less than both, and than any mean of the two.
VolumeBends::Bend greater(const VolumeBends::Bend& a, const VolumeBends::Bend& b);

} // namespace trivar
