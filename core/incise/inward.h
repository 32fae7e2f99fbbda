// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/key_numbers.h"
#include "core/incise/lattice_point.h"

namespace trivar {

// Inward says which way walls go down below points of the skin: the other way than a normal that is
// smoothed over some rings and then turned until all faces round the point see it from outside.
// Between points it is linear, and not of unit length.
class Inward {
public:
    // Computes the directions at the corners of some triangles. O(#triangles and their rings).
    Inward(const SlitSkin& skin, std::span<const std::uint32_t> triangles);

    // A Source is a point of a cut, with the outward direction there and the length of the cut that
    // it stands for. How far it counts is its radius.
    struct Source {
        glm::dvec3 p, outward;
        double length, radius;
    };
    // Replaces the direction at each point by the mean of the sources round it, as far as the faces
    // there see it: walls are as smooth as they are deep, however rough the skin is.
    void follow(std::vector<Source> sources);

    // Unit, at a point of these triangles; elsewhere the normal.
    glm::dvec3 outward(std::uint32_t point) const;
    glm::dvec3 outward(const LatticePoint& p) const;
    // Whether walls can go down at all: some points are seen from outside by no common direction.
    bool has_inside(const LatticePoint& p) const;
    // The greatest depth, at most `wanted`, down to which layers below a triangle stay right way
    // up.
    double depth_below(std::uint32_t triangle, double wanted) const;

private:
    struct Direction {
        glm::dvec3 outward;
        bool seen = true;
    };
    void turn_to_faces(std::uint32_t point, Direction& d) const;

    const SlitSkin* skin_;
    KeyNumbers number_;
    std::vector<std::uint32_t> points_; // by number; more than have directions
    std::vector<Direction> directions_;
};

} // namespace trivar
