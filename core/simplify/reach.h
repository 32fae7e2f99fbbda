// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/spline/box_tree.h"

#include <array>

namespace trivar {

using Triangle3 = std::array<glm::dvec3, 3>;

Box box_of(const Triangle3& triangle);
double distance_squared(const glm::dvec3& p, const Triangle3& triangle); // also of a flat one

// Triangles, to prove how near others are to them.
class Reach {
public:
    explicit Reach(std::vector<Triangle3> triangles = {}); // O(n log n)

    // Whether every point of a triangle is proven to be within a distance of these. True never
    // errs; false if a point is further, or if the pieces that it is cut into are not enough to
    // tell. A piece is proven by one triangle that all its corners are near to [1]: distances from
    // a convex set are greatest at corners. The part above one of the triangles is cut off and
    // proven by that one, the rest is quartered.
    //   [1] Guthe, Borodin, Klein, Fast and accurate Hausdorff distance calculation, 2005
    bool covers(const Triangle3& triangle, double distance) const;

private:
    bool covers(const Triangle3& piece, const std::vector<int>& near, std::size_t near_before,
                double distance, std::size_t& pieces_left) const;
    bool is_cut_away(const Triangle3& piece, const std::vector<int>& near, double distance) const;

    std::vector<Triangle3> triangles_;
    std::vector<Box> boxes_;
    BoxTree tree_;
};

} // namespace trivar
