// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/split/seam.h"
#include "core/split/surface_bounds.h"

namespace trivar {

// Of the error of a function that is linear over a triangle, with the greatest second derivative
// along an edge: twice the largest sum of products of two barycentric coordinates, by the 2 of
// Taylor's term.
constexpr double share_of_bends = 1.0 / 6;

// SplitError bounds how far the flat triangles of a split model are from where the field takes
// them: for a triangle with edge vectors e the error of linear interpolation is at most 1/6 of the
// greatest |second derivative along e| over its box, times |e|^2. [Waldron 1998; here with the sum
// of products of barycentric coordinates, at most 1/3, in place of a circle]
class SplitError {
public:
    // The field must live as long. Seams: one per opening, or none.
    explicit SplitError(const SplitField& field, std::vector<Seam> seams = {});

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
    // The same where a seam draws in.
    void add_drawn_in(std::size_t opening, const std::array<glm::dvec3, 3>& uvw,
                      const std::array<double, 3>& heights, std::array<double, 3>& edges) const;
    double drawn_in_cap(std::size_t opening, const std::array<glm::dvec2, 3>& vw) const;
    bool draws(std::size_t opening) const { return !seams_.empty() && seams_[opening].draws(); }

    const SplitField& field_;
    std::vector<Seam> seams_;
    std::vector<Each> all_;
};

} // namespace trivar
