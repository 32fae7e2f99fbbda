// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/depth_jump.h"
#include "core/placement/embed.h"
#include "core/placement/gap.h"
#include "core/placement/ray_grid.h"
#include "core/placement/springs.h"

namespace trivar {

// A StripLayout is the strip laid on the scene, before and after the springs: everything that
// place() decides before there is a surface. The live animation of the springs starts from it, too.
struct StripLayout {
    std::array<Knots, 2> axes; // of the contact surface; node (i, j) sits at Greville (i, j)
    Strip strip;
    RayGrid grid{}; // with a distance for every node
    SpringSheet sheet{};
    std::vector<double> s{}; // the nodes' rest on the sheet; 0 without springs
    std::vector<char> loose{};
    double length = 0, width = 0, height = 0; // in the world, measured at the nodes
    // share of the nodes that hit the scene and are not lifted by the springs
    double contact_share = 0;
    int spring_iterations = 0;
    int narrowed = 0;
    std::vector<DepthJump> jumps{}; // in the middle line, that the strip spans
    std::vector<char> on_ridge{};   // #nodes or empty; 1: the node lies on an edge of the scene
    std::vector<SceneSample> features{}; // points of oblique creases; the surface is drawn to them

    std::vector<glm::dvec3> points() const; // the nodes, on their springs
    // the node hit the scene, and the springs do not hold it up
    bool touches(std::size_t node) const;
};

} // namespace trivar
