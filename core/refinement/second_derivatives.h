// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/refinement/methods.h"
#include "core/refinement/simplex_net.h"

namespace trivar {

// SecondDerivatives computes those bounds that take the greatest second derivatives of the map over
// a simplex. The control points of the derivatives' nets bound them, piece by piece.
template <int corners> class SecondDerivatives {
public:
    SecondDerivatives(BoundMethod method, const std::array<glm::dvec3, corners>& uvw);

    // Whether a piece is large enough to keep digits. `weight` holds its corners in the whole
    // simplex, barycentric.
    bool worth_cutting(const std::array<glm::dvec3, corners>& weight) const;
    // Adds the net of a piece, whose points may be wrong by `doubt`.
    void add(const NetPoints<corners>& net, int degree,
             const std::array<glm::dvec3, corners>& weight, double doubt);
    double bound() const; // infinite where the method does not apply

private:
    BoundMethod method_;
    std::array<glm::dvec3, corners> uvw_;
    // The barycentric directions: the edges of a triangle, or two orthogonal unit directions; and
    // the greatest lengths of second derivatives for pairs of them: 00, 11, 22, 01, 12, 20.
    std::array<glm::dvec3, 3> along_{};
    int directions_ = 1;
    std::array<double, 6> greatest_{};
    double any_direction_ = 0; // over all unit directions of the plane
};

} // namespace trivar
