// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "core/simplex/simplex_basis.h"

#include <optional>

namespace trivar {

// A SimplexVolume deforms points: F(x) = x + sum_b N_b(x) d_b over the functions of one or several
// layers, each with a domain of its own.
struct SimplexVolume {
    std::vector<Ref<SimplexBasis<3>>> layers; // at least one
    std::vector<glm::dvec3> displacements;    // of the control points of all layers in turn

    std::size_t first_point(std::size_t layer) const;
    bool operator==(const SimplexVolume&) const = default;
};

// F and, where asked for, its derivative. In double precision; about 5 us for degree 2.
struct SimplexPoint {
    glm::dvec3 position;
    glm::dmat3 jacobian{1};
};
SimplexPoint evaluate(const SimplexVolume& volume, const glm::dvec3& x, bool derivative = false);

// The point that F takes to p, by Newton's method with halved steps from p on; no value where that
// comes no nearer than `tolerance` in 50 steps.
std::optional<glm::dvec3> inverse(const SimplexVolume& volume, const glm::dvec3& p,
                                  double tolerance);

} // namespace trivar
