// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/refinement/methods.h"
#include "core/refinement/simplex_net.h"

namespace trivar {

// The bounds that take the greatest second derivatives of the map over a simplex, which the
// control points of the derivatives' nets bound, piece by piece.
template <int corners> class SecondDerivatives {
public:
    SecondDerivatives(BoundMethod method, const std::array<glm::dvec3, corners>& uvw);

    // Whether a piece is fat enough to keep digits. weight: its corners in the whole, barycentric.
    bool worth_cutting(const std::array<glm::dvec3, corners>& weight) const;
    // The net of a piece; its points may be off by `doubt`.
    void add(const NetPoints<corners>& net, int degree,
             const std::array<glm::dvec3, corners>& weight, double doubt);
    double bound() const; // infinite where the method does not apply

private:
    BoundMethod method_;
    std::array<glm::dvec3, corners> uvw_;
    // Directions, barycentric: the edges of a triangle, or two unit ones that are orthogonal; and
    // the greatest lengths of second derivatives for pairs of them: 00, 11, 22, 01, 12, 20.
    std::array<glm::dvec3, 3> along_{};
    int directions_ = 1;
    std::array<double, 6> greatest_{};
    double any_direction_ = 0; // over all unit directions of the plane
};

} // namespace trivar
