// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/ffd/lattice.h"
#include "core/spline/bezier_cell.h"

#include <optional>

namespace trivar {

struct ParameterBox {
    glm::dvec3 lo, hi; // uvw; flat where they are equal
};

// A lattice in world space with closed axes unrolled: over two turns, so that a box may lie across
// the seam. The second turn of a twisted axis has the other two mirrored.
class UnrolledMap {
public:
    // Makes the map; nothing if it jumps: inside, or at a seam because `rest` does not close.
    static std::optional<UnrolledMap> of(const Lattice& lattice);

    const ParameterBox& domain() const { return domain_; } // the first turn
    bool closed(int axis) const { return closed_[axis]; }
    // The same points a turn further on.
    ParameterBox turned(ParameterBox box, int axis) const;
    // A Cut is the plane at which a box is best halved, across its longest axis: at a break if one
    // lies inside.
    struct Cut {
        int axis;
        double t;
    };
    std::optional<Cut> cut(const ParameterBox& box, int halvings) const; // none: small enough

    Jet<glm::dvec3> jet(const glm::dvec3& uvw) const { return evaluate(map_, uvw, 1); }
    Box bounds(const ParameterBox& box) const;
    // Control points in whose hull the box lies; empty where it is of many cells.
    std::vector<glm::dvec3> hull(const ParameterBox& box) const;
    // Proven that no two points of the box meet: J = A (I + E) there with |E| < 1.
    bool nearly_affine(const ParameterBox& box) const;

private:
    UnrolledMap(Trivariate<glm::dvec3> map, const ParameterBox& domain, glm::bvec3 closed,
                int twisted);
    std::array<std::array<int, 2>, 3> cells_of(const ParameterBox& box) const;
    std::vector<BezierCell> parts(const ParameterBox& box) const;

    Trivariate<glm::dvec3> map_;
    ParameterBox domain_;
    glm::bvec3 closed_;
    int twisted_; // axis, or -1
    std::array<std::vector<double>, 3> breaks_;
    std::vector<BezierCell> cells_;
    std::vector<Box> bounds_;
};

} // namespace trivar
