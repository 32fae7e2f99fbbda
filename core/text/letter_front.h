// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plane/triangulation.h"
#include "core/text/extrusion.h"

#include <optional>

namespace trivar {

// Rings about a region, one within the other, and the heights that they are lifted to.
struct BevelRing {
    Region region;     // its edges cut short
    double inset = 0;  // units from the outermost
    double height = 0; // em above it
    double slope = 0;  // radians that normals of the bevel are raised by here
};
// The first is the region itself, cut short; those that vanish are left out.
std::vector<BevelRing> bevel_rings(const Region& region, const Extrusion& extrusion);
double bevel_of(const Extrusion& extrusion); // em; what counts of it

// The outward normals beside a corner of a ring: of the edges that end and begin there, one and the
// same where the ring is smooth.
struct EdgeNormals {
    glm::dvec2 before{0}, behind{0};
};
std::vector<EdgeNormals> edge_normals(const Loop& loop);

// The front as triangles over the plane.
struct LetterFront {
    std::vector<glm::ivec2> points;
    std::vector<int> ring_of;                 // #points to ring whose height it has
    std::vector<std::vector<EdgeNormals>> at; // #points to the corners of rings there
    std::vector<Triangulation::Corners> triangles;
    std::vector<std::vector<int>> rim; // the outermost ring's corners as points, a list a loop
};
// Nothing where the outermost ring touches or crosses itself.
std::optional<LetterFront> letter_front(const std::vector<BevelRing>& rings, double max_edge);

} // namespace trivar
