// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/model.h"
#include "core/split/split_closing.h"
#include "core/split/split_ends.h"
#include "core/split/split_kernel.h"

#include <glm/glm.hpp>
#include <vector>

namespace trivar {

// An ObstacleUse says how an object is parted by one other object.
struct ObstacleUse {
    int object = 0;           // its id
    double clearance = 0.005; // metres that stay free between the two, at least
    double reach = 0; // metres over which the opening fades; what is needed where that is more
    SplitKernel kernel = SplitKernel::quadratic;
    bool operator==(const ObstacleUse&) const = default;
};

// Splitting lists the obstacles that part an object, and how its halves are closed.
struct Splitting {
    std::vector<ObstacleUse> obstacles;
    glm::dvec3 opening{1, 0, 0}; // direction in the world in which the halves part
    glm::dvec3 way{0, 1, 0};     // direction in the world in which the object passes
    SplitClosing closing = SplitClosing::capped;
    Filling inside = Filling::none; // what the caps show; none: the object's first material
    double tolerance = 2e-3;        // metres between flat triangles and the true walls, at most
    SplitEnds ends = SplitEnds::sharp;
    bool operator==(const Splitting&) const = default;
};

} // namespace trivar
