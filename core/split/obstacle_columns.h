// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/box.h"
#include "core/rays/ray_scene.h"

#include <optional>

namespace trivar {

// A SplitFrame is the space of a split: u is the direction in which the halves part, v the way on
// which the model passes the obstacle, w = u x v. Metres.
//
//      u ^        .-----------.            W_1: the wall of the upper half
//        |     .-'     ___     `-.
//      --+------------( o )-------------   phi: the cut surface through the obstacle o
//        |     `-.     ```     .-'
//        |        `-----------'            W_0: the wall of the lower half
//        +-------------------------> v     w points away from you
struct SplitFrame {
    glm::dvec3 origin{0};
    glm::dmat3 axes{1}; // columns u, v, w: orthonormal and right-handed

    glm::dvec3 uvw(const glm::dvec3& p_world) const
    {
        return glm::transpose(axes) * (p_world - origin);
    }
    glm::dvec3 world(const glm::dvec3& uvw) const { return origin + axes * uvw; }
    bool operator==(const SplitFrame&) const = default;
};

// ObstacleColumns are the ranges of u that an obstacle occupies along lines parallel to u. Pockets,
// which a line leaves and enters again, count as filled.
class ObstacleColumns {
public:
    // Throws Rejected for bodies without extent in the frame.
    ObstacleColumns(const std::vector<RayScene::Entry>& bodies, const SplitFrame& frame);

    // Least and greatest u at (v, w); none: the line misses the obstacle. In parallel.
    std::vector<std::optional<glm::dvec2>> at(std::span<const glm::dvec2> vw) const;
    const Box& box() const { return box_; }                                 // in uvw
    const std::vector<glm::dvec3>& vertices() const { return vertices_; }   // in uvw
    const std::vector<glm::uvec3>& triangles() const { return triangles_; } // of these

private:
    RayScene scene_;
    SplitFrame frame_;
    Box box_;
    std::vector<glm::dvec3> vertices_;
    std::vector<glm::uvec3> triangles_;
};

} // namespace trivar
