// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/placement.h"
#include "core/placement/strip.h"
#include "core/rays/ray_scene.h"

namespace trivar {

// A RayGrid holds the rays through a ruled grid of the strip and their hits. Node (i, j) has index
// i * columns + j; i runs along the stroke, j from its right to its left.
struct RayGrid {
    int rows = 0, columns = 0;
    std::vector<double> a;          // #rows, along the strip
    std::vector<double> v;          // #nodes, across
    std::vector<Ray> rays;          // #nodes
    std::vector<double> distance;   // #nodes, along the ray; for misses only after filled()
    std::vector<char> hit;          // #nodes
    std::vector<glm::dvec3> normal; // #nodes, of the scene, toward the camera; for misses the ray's

    std::size_t index(int i, int j) const
    {
        return static_cast<std::size_t>(i) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(j);
    }
    glm::dvec3 point(std::size_t k) const
    {
        return rays[k].origin + distance[k] * rays[k].direction;
    }
    double missed_share() const;
};

// Fills in the hits of the grid's rays. A hit at less than about a degree to the surface counts as
// a miss: such a hit jumps with the smallest move of the strip.
RayGrid met(RayGrid grid, const RayScene& scene, bool skip_back_faces);
inline constexpr double grazing = 0.02; // cosine between normal and ray

// The same with one ray per node.
RayGrid shoot(const Strip& strip, std::vector<double> a, std::vector<double> v,
              const Camera& camera, const RayScene& scene, bool skip_back_faces);

// Gives every node a distance. A missed node takes its distance from the membrane that spans the
// hits around it (discrete Laplace equation), from the ground z = 0 or from the nearest hit. At
// least one node must be a hit.
RayGrid filled(RayGrid grid, Misses misses);

} // namespace trivar
