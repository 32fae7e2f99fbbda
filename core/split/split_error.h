// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/split/split_field.h"

namespace trivar {

// SplitError bounds how far the flat triangles of a split model are from where the field takes
// them: for a triangle with edge vectors e the error of linear interpolation is at most 1/6 of the
// greatest |second derivative along e| over its box, times |e|^2. [Waldron 1998; here with the sum
// of products of barycentric coordinates, at most 1/3, in place of a circle]
class SplitError {
public:
    explicit SplitError(const SplitField& field) : field_(field) {} // which must live as long

    // Metres, for each edge (corner i to the next); the largest of them bounds the triangle, for
    // the points of either side. 0 where nothing is moved. `heights` holds, corner by corner, the
    // heights over the cut surfaces.
    std::array<double, 3> edges(const std::array<glm::dvec3, 3>& uvw,
                                const std::array<const double*, 3>& heights) const;
    // Metres, for every triangle whose corners lie in a box of uvw: quick, and more than what
    // `edges` says.
    double within(const Box& uvw) const;
    // The same for a flat triangle of a cap of an opening, whose corners have these (v, w). Beside
    // its own walls a cap may run through other openings. O(1) for one opening.
    std::array<double, 3> cap(std::size_t opening, const std::array<glm::dvec2, 3>& vw) const;

private:
    void add(std::size_t opening, const std::array<glm::dvec3, 3>& uvw,
             const std::array<double, 3>& heights, std::array<double, 3>& edges) const;

    const SplitField& field_;
};

} // namespace trivar
