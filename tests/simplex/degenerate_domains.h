// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/simplex/simplex_domain.h"

#include <random>
#include <string>

namespace trivar {

// Convex domains of few cells, and points in them, that are as special as can be. Coordinates have
// so few bits that what is meant to lie on a face, on a vertex or in the plane of knots lies there
// exactly.

template <int S> struct DegenerateDomain {
    SimplexDomain<S> domain;
    std::string kind;
    // The volume of the least cell times S! over its longest edge to the power S.
    double flatness = 1;
};

// One cell, one that is parted at an inner point, or boxes; squeezed and sheared; with clouds as
// usual, stacked, on one point, on edges or in faces; so that the functions sum to 1 in the domain.
// Every simplex of knots has the least share of its cell or more.
template <int S>
DegenerateDomain<S> degenerate_domain(int degree, double least_share, std::mt19937& random);

enum class PointKind { anywhere, on_face, on_edge, on_vertex, on_knot_plane, on_knot, beside };
inline constexpr std::array<const char*, 7> point_kinds{
    "anywhere",  "on a face",    "on an edge", "on a vertex", "in a plane of knots",
    "on a knot", "beside a face"};

// A point of that kind, which may lie outside when it is one of knots.
template <int S>
glm::vec<S, double> special_point(const SimplexDomain<S>& domain, PointKind kind,
                                  std::mt19937& random);

} // namespace trivar
