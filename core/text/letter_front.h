// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/plane/triangulation.h"
#include "core/text/extrusion.h"

#include <optional>

namespace trivar {

// A BevelRing is one of the rings about a region, one within the other, with the height to which it
// is lifted.
struct BevelRing {
    Region region;     // its edges are cut short
    double inset = 0;  // units from the outermost ring
    double height = 0; // em above the outermost ring
    double slope = 0;  // radians by which normals of the bevel are raised here
};
// The rings, beginning with the region itself, its edges cut short; rings that vanish are left out.
std::vector<BevelRing> bevel_rings(const Region& region, const Extrusion& extrusion);
double bevel_of(const Extrusion& extrusion); // em; the part of the bevel that is used

// EdgeNormals are the outward normals beside a corner of a ring: of the edge that ends and of the
// edge that begins there. They are equal where the ring is smooth.
struct EdgeNormals {
    glm::dvec2 before{0}, behind{0};
};
std::vector<EdgeNormals> edge_normals(const Loop& loop);

// A LetterFront is the front of a letter as triangles over the plane.
struct LetterFront {
    std::vector<glm::ivec2> points;
    std::vector<int> ring_of;                 // #points to the ring whose height the point has
    std::vector<std::vector<EdgeNormals>> at; // #points to the corners of rings at the point
    std::vector<Triangulation::Corners> triangles;
    std::vector<std::vector<int>> rim; // the outermost ring's corners as points, one list per loop
};
// Empty where the outermost ring touches or crosses itself.
std::optional<LetterFront> letter_front(const std::vector<BevelRing>& rings, double max_edge);

} // namespace trivar
