// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/certificate/motion_bound.h"
#include "core/refinement/born_vertices.h"

namespace trivar {

// One mesh of triangles for a part in a volume, fine enough at all moments of a film.
struct CommonMesh {
    Ref<Mesh> mesh; // as it stands at some moment, before the volume; its faces hold at all
    std::vector<BornVertex> born; // its vertices beyond the part's own, in their order
    std::size_t triangles_before = 0;
    bool closed = false; // it shares no edge with other parts
    // What is proven of the flat triangles at each moment, rounding included, metres.
    std::vector<double> space;
};

// The strips of one object that a volume deforms. Refined at one moment after the other until
// nothing is split any more, or four times round. Throws Rejected as refine() does, and Cancelled.
std::vector<CommonMesh> common_meshes(const Film& film, const std::vector<const FilmStrip*>& strips,
                                      MotionBound& motion, double tolerance,
                                      const Progress& progress = {});

// The mesh with its faces cut, as refine() and a GLB cut them.
Mesh in_triangles(const Mesh& mesh);
// The part's mesh at a moment before its volume, with the common faces.
Mesh before_volume(const CommonMesh& common, const Part& part);

} // namespace trivar
