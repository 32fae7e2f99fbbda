// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/split/seam.h"

namespace trivar {

// The error of linear interpolation, as a share of the greatest second derivative along an edge: on
// the edge itself, and over a triangle none of whose edges has a greater one.
constexpr double share_of_edge = 1.0 / 8, share_of_bend = 1.0 / 6;

// The share of the tolerance for triangles that are cut, since an edge of the cut may be worse than
// the edges of the triangle through which it runs.
constexpr double share_of_cut = 0.5;
// The share of the tolerance for all triangles, so that those cut afterwards keep within it.
constexpr double share_of_whole = 0.6;

// Beyond the walls halves only touch, but neither a cap nor its rim should be further from the cut
// surface than that, in tolerances: a cap would be out of the body, or cross the rim of another
// opening.
constexpr double far_from_surface = 32;

// Bounds of how far a flat triangle is off: on each of its edges (corner i to the next) by itself.
using EdgeErrors = std::array<double, 3>;

// The bound for the whole triangle: linear interpolation is off by 4 sum l_i l_j E_ij at most, for
// barycentric coordinates l. [Waldron, The error in linear interpolation at the vertices of a
// simplex, 1998]
double whole_error(const EdgeErrors& edges);

// SplitError bounds how far the flat triangles of a split model are from where the field takes
// them: on an edge e by 1/8 of the greatest |second derivative along e| over the triangle's box,
// times |e|^2.
class SplitError {
public:
    // The field must live as long. Seams: one per opening, or none.
    explicit SplitError(const SplitField& field, std::vector<Seam> seams = {})
        : field_(field),
          seams_(std::move(seams))
    {
    }

    // Metres, for the points of either side. 0 where nothing is moved. `heights` holds, corner by
    // corner, the heights over the cut surfaces.
    EdgeErrors edges(const std::array<glm::dvec3, 3>& uvw,
                     const std::array<const double*, 3>& heights) const;
    // Bounds the error, in metres, of any triangle whose corners lie in a box of uvw: quick, and
    // more than `edges` gives without seams.
    double within(const Box& uvw) const;
    // The same for a flat triangle of a cap of an opening, whose corners have these (v, w). Beside
    // its own walls a cap may run through other openings. O(1) for one opening.
    EdgeErrors cap(std::size_t opening, const std::array<glm::dvec2, 3>& vw) const;
    // Bounds the distance of such a triangle from the cut surface itself, before anything is moved.
    EdgeErrors surface(std::size_t opening, const std::array<glm::dvec2, 3>& vw) const;
    // The greatest of these for all triangles in a box of uvw and all openings. O(#openings).
    double surfaces_within(const Box& uvw) const;

private:
    // Errors of the edges on each side of the surface; one of both applies where a triangle may be
    // on either.
    using SideErrors = std::array<EdgeErrors, 2>;
    SideErrors by_sides(std::size_t opening, const std::array<glm::dvec3, 3>& uvw,
                        const std::array<double, 3>& heights) const;
    // The same where a seam draws in.
    SideErrors drawn_in_by_sides(std::size_t opening, const std::array<glm::dvec3, 3>& uvw,
                                 const std::array<double, 3>& heights) const;
    EdgeErrors drawn_in_cap(std::size_t opening, const std::array<glm::dvec2, 3>& vw) const;
    bool draws(std::size_t opening) const { return !seams_.empty() && seams_[opening].draws(); }

    const SplitField& field_;
    std::vector<Seam> seams_;
};

} // namespace trivar
