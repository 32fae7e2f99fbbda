// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "core/simplex/simplex_basis.h"

namespace trivar {

// A SimplexField has a number at each point of its basis's domain: f(x) = sum_b N_b(x) c_b. It has
// degree - 1 continuous derivatives, but at creases, and jumps at cuts; beyond the domain it is 0.
struct SimplexField {
    Ref<SimplexBasis<3>> basis;
    std::vector<double> values; // of its control points
    bool operator==(const SimplexField&) const = default;
};

// f, and where asked for its gradient; about 5 us for degree 2. Thread-safe.
struct FieldPoint {
    double value = 0;
    glm::dvec3 gradient{0};
};
FieldPoint evaluate(const SimplexField& field, const glm::dvec3& x, bool gradient = false);

} // namespace trivar
