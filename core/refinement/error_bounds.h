// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ref.h"
#include "core/refinement/cubic_error.h"
#include "core/refinement/methods.h"

#include <optional>

namespace trivar {

// Certified bounds in world units: what they promise holds for exact arithmetic, and the bound is
// raised by what rounding may hide in its own computation. Infinite where a method says nothing:
// all where the map jumps inside, the ones by second derivatives also where it has a kink (a knot
// of an axis of order 2, the end of an open axis). Remembers the last cell: one for each thread.
class ErrorBounds {
public:
    explicit ErrorBounds(Ref<DisplacementCells> cells) : cells_(std::move(cells)) {}

    // Corners with the displacement there: evaluate(displacement, uvw).value.
    struct Corner {
        glm::dvec3 uvw, displacement;
    };
    Corner corner(const glm::dvec3& uvw) const;
    double triangle(const std::array<Corner, 3>& corners, BoundMethod method);
    double edge(const std::array<Corner, 2>& corners, BoundMethod method);

    // The displacement along an edge as the Bezier nets of its pieces.
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
    std::optional<CubicError> cubic_; // of that cell
};

// The least circle round a triangle, and the one through its corners: radii in the units of p.
double least_circle_radius(const std::array<glm::dvec3, 3>& p);
double circumradius(const std::array<glm::dvec3, 3>& p);

} // namespace trivar
