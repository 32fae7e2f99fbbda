// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/certificate/motion_bound.h"
#include "core/refinement/born_vertices.h"

namespace trivar {

// A CommonMesh is one mesh of triangles for a part in a volume, fine enough at every moment of a
// film.
struct CommonMesh {
    // The mesh at one of the moments, before the volume; its faces are the same at every moment.
    Ref<Mesh> mesh;
    std::vector<BornVertex> born; // the vertices that the part itself does not have, in their order
    std::size_t triangles_before = 0;
    bool closed = false; // its edges are shared with no other part
    // The proven largest distance, in metres, of the flat triangles from the true surface at each
    // moment, rounding included.
    std::vector<double> space;
};

// Makes the meshes of the strips of one object that a volume deforms. The triangles are refined at
// one moment after the other until no moment splits any, or after four rounds.
//   strips     of the object
//   motion     its bound
//   tolerance  metres
// Throws Cancelled, and Rejected as refine() does.
std::vector<CommonMesh> common_meshes(const Film& film, const std::vector<const FilmStrip*>& strips,
                                      MotionBound& motion, double tolerance,
                                      const Progress& progress = {});

// The mesh with its faces cut into triangles in the same way as refine() and a GLB cut them.
Mesh in_triangles(const Mesh& mesh);
// The part's mesh at one moment, before its volume, with the common faces.
Mesh before_volume(const CommonMesh& common, const Part& part);

} // namespace trivar
