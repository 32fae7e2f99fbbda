// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/refinement/error_bounds.h"
#include "core/refinement/next_volume.h"
#include "core/refinement/stretch_bound.h"

namespace trivar {

// ComposedCells holds the data for error bounds of volumes that deform one after the other: the
// first one, and those that deform its result. Threads share it.
class ComposedCells {
public:
    ComposedCells(const Lattice& first, std::vector<NextVolume> next);

    const Ref<DisplacementCells>& first() const { return first_; }
    const std::vector<NextVolume>& next() const { return next_; }
    // The greatest stretch of all volumes behind the first one.
    double most_stretch() const;

private:
    friend class ComposedBounds;
    Ref<DisplacementCells> first_;
    std::vector<NextVolume> next_;
    std::vector<Ref<DisplacementCells>> cells_; // by next volume
    std::vector<StretchBound> stretch_;
};

// ComposedBounds bounds the distance of G(F(x)) from the flat edge or triangle through the deformed
// corners, in world units, point for point of equal barycentric coordinates:
//
//   |G(F(x)) - flat| <= |G(F(x)) - G(y)| + |G(y) - flat| <= L e(F) + e(G),
//
// y the point of the flat triangle through the corners that F has taken, e(F) and e(G) the bounds
// for one volume (ErrorBounds) and L the greatest stretch of G where a point within e(F) of that
// triangle may be. By induction for any number of volumes. One volume alone gives the bits of
// ErrorBounds. Each thread needs a ComposedBounds of its own.
class ComposedBounds {
public:
    using Corner = ErrorBounds::Corner;
    explicit ComposedBounds(const ComposedCells& cells);

    // Corners with their places after the first volume.
    template <std::size_t corners> struct Simplex {
        std::array<Corner, corners> by_first;
        std::array<glm::dvec3, corners> world;
    };
    double operator()(const Simplex<2>& edge, BoundMethod method);
    double operator()(const Simplex<3>& triangle, BoundMethod method);

    // An edge as that volume takes it which adds the most to its bound.
    struct WorstPart {
        ErrorBounds& bounds;
        std::array<Corner, 2> edge;
    };
    WorstPart worst_part(const Simplex<2>& edge, BoundMethod method);

private:
    template <std::size_t corners> struct Shares;
    template <std::size_t corners>
    Shares<corners> shares(const Simplex<corners>& simplex, BoundMethod method);

    const ComposedCells& cells_;
    ErrorBounds first_;
    std::vector<ErrorBounds> next_;
};

} // namespace trivar
