// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/split/split_field.h"
#include "core/split/surface_bounds.h"

namespace trivar {

// SplitError bounds how far the flat triangles of a split model are from where the field takes
// them: for a triangle with edge vectors e the error of linear interpolation is at most 1/6 of the
// greatest |second derivative along e| over its box, times |e|^2. [Waldron 1998; here with the sum
// of products of barycentric coordinates, at most 1/3, in place of a circle]
class SplitError {
public:
    explicit SplitError(const SplitField& field); // which must live as long

    // Metres, for each edge (corner i to the next); the largest of them bounds the triangle, for
    // the points of either side. 0 where nothing is moved. `heights` holds, corner by corner, the
    // heights over the cut surfaces.
    std::array<double, 3> edges(const std::array<glm::dvec3, 3>& uvw,
                                const std::array<const double*, 3>& heights) const;
    // Metres, for a flat triangle of a cap of an opening, whose corners have these (v, w). Beside
    // its own walls a cap may run through other openings.
    double cap(std::size_t opening, const std::array<glm::dvec2, 3>& vw) const;

private:
    double own_cap(std::size_t opening, const std::array<glm::dvec2, 3>& vw) const;
    struct Each {
        SurfaceBounds surface;
        std::array<SurfaceBounds, 2> walls;
        glm::dvec2 lo, hi; // of the rectangle
        std::array<double, 2> reach;
        SplitKernel kernel;
    };
    void add(std::size_t opening, const std::array<glm::dvec3, 3>& uvw,
             const std::array<double, 3>& heights, std::array<double, 3>& edges) const;

    const SplitField& field_;
    std::vector<Each> all_;
};

} // namespace trivar
