// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "core/refinement/cubic_error.h"
#include "core/refinement/methods.h"

#include <optional>

namespace trivar {

// ErrorBounds gives certified bounds in world units. Their promise holds for exact arithmetic, and
// each bound is raised by the rounding of its own computation. A bound is infinite where a method
// does not apply: for all methods where the map jumps inside, for those by second derivatives also
// where it has a kink (a knot of an axis of order 2, the end of an open axis). It remembers the
// last cell, so each thread needs one of its own.
class ErrorBounds {
public:
    explicit ErrorBounds(Ref<DisplacementCells> cells) : cells_(std::move(cells)) {}

    // A Corner is a point with the displacement there: evaluate(displacement, uvw).value.
    struct Corner {
        glm::dvec3 uvw, displacement;
    };
    Corner corner(const glm::dvec3& uvw) const;
    double triangle(const std::array<Corner, 3>& corners, BoundMethod method);
    double edge(const std::array<Corner, 2>& corners, BoundMethod method);

    // An EdgePiece is a piece of an edge, with the displacement along it as a Bezier net.
    struct EdgePiece {
        double from, to; // of the edge, 0 to 1
        int degree;
        std::array<glm::dvec4, 16> net;
    };
    std::vector<EdgePiece> edge_pieces(const std::array<Corner, 2>& corners);

    const DisplacementCells& cells() const { return *cells_; }

private:
    template <int corners> struct Piece;
    template <int corners> struct Work;
    const DisplacementCells::Cell& cell(const glm::ivec3& slabs);

    Ref<DisplacementCells> cells_;
    DisplacementCells::Cell cell_;
    bool loaded_ = false;
    std::optional<CubicError> cubic_; // of the remembered cell
};

// The radii of the smallest circle round a triangle, and of the circle through its corners, in the
// units of p.
double least_circle_radius(const std::array<glm::dvec3, 3>& p);
double circumradius(const std::array<glm::dvec3, 3>& p);

} // namespace trivar
