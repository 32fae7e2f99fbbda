// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

namespace trivar {

// A Cage defines a subdivision surface: points, faces of any number of corners, and the edges and
// points that are sharp. All indices are of points, of which each is used.
struct Cage {
    std::vector<glm::dvec3> points;
    std::vector<int> face_sizes;         // number of corners of each face
    std::vector<int> corners;            // of all faces, one after the other
    std::vector<int> crease_ends;        // two points a crease
    std::vector<float> crease_sharpness; // 0..10; 10: infinitely sharp
    std::vector<int> sharp_points;
    std::vector<float> point_sharpness; // 0..10
};

// Repairs harmless damage of a mesh (core/mesh/repair.h) and numbers its points without gaps, as a
// cage needs them. O(#C log valence).
Mesh ready_to_subdivide(const Mesh& mesh);

// Makes a cage of a mesh that is ready, with its points moved by a matrix; one that mirrors turns
// the faces round. O(#C).
Cage cage_of(const Mesh& mesh, const glm::dmat4& to_model = glm::dmat4(1));

// Puts another cage beside the first.
void append(Cage& cage, const Cage& other);

} // namespace trivar
