// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

namespace trivar {

// Triangles of the plane, counter-clockwise; they meet along whole edges.
struct FlatTriangles {
    std::vector<glm::dvec2> points;
    std::vector<std::array<std::uint32_t, 3>> corners;
};

// TriangleCoarseness is the coarseness of a triangle as a share of what is allowed, above 1 too
// coarse: of the whole, and along each of its edges (corner i to the next). A triangle that
// contains another has at least its coarseness.
struct TriangleCoarseness {
    std::array<double, 3> edges;
    double whole;
};
using Coarseness = std::function<TriangleCoarseness(const std::array<glm::dvec2, 3>&)>;

// Makes triangles fine enough by points inside: the coarsest inner edge of a triangle that is too
// coarse is halved, and inner edges are turned over where that makes them less coarse, so that
// triangles become long where little changes along them. Edges of one triangle alone stay, and so
// do edges that are not longer than `shortest`. New points come last. O(n) for n triangles made.
void make_fine_enough(FlatTriangles& triangles, const Coarseness& coarseness, double shortest);

} // namespace trivar
