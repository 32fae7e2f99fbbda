// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"
#include "core/split/needed_cut.h"
#include "core/split/on_cut.h"

namespace trivar {

// A CutMesh is a mesh that was cut in two where a function of its vertices is zero. Both halves are
// in one mesh: faces and vertices that were not cut keep their order, and stand first. Each half
// has its own copies of the places on the cut, so that the halves can part.
//
// A place is a point of the surface on an edge that was cut, or a point of the mesh that lies on
// the cut; places are numbered from 0. Its point in Mesh::points is first_point + 2 place below the
// cut, and one more above it.
struct CutMesh {
    Mesh mesh;               // open along the cut; `points` is never empty where something was cut
    std::vector<char> above; // #V: 1 where the function is not negative
    std::vector<glm::vec3> places;
    // The cut as directed edges between places: the solid lies to the left of them, as seen from
    // above the cut. They are the edges of the faces above; the faces below run along them the
    // other way.
    std::vector<glm::uvec2> rim;
    // The edges that were cut, by their vertices: copy 2 e and 2 e + 1 lie on edge e, which is from
    // a vertex to itself where that lies on the cut. And one of the edges of each place.
    std::vector<glm::uvec2> edges;
    std::vector<std::uint32_t> edge_of_place;
    std::uint32_t first_vertex =
        0; // of the copies; those below the cut have even distances from it
    std::uint32_t first_point = 0;
    std::size_t first_new_face = 0; // of those that were made of faces that were cut
    // The greatest move of the cut's function at each place, where it was near 0 at an end of the
    // edge.
    std::vector<double> moved;

    std::uint32_t point(std::uint32_t place, bool above_cut) const
    {
        return first_point + 2 * place + (above_cut ? 1 : 0);
    }
};

// Cuts a mesh where a function of its vertices changes its sign. Along an edge the function is
// linear; heights near 0 are moved a little apart (see move_apart()), so that the place stays on
// the edge, at least 1e-4 of its length from either end. Attributes are blended. Cut faces become
// triangles.
//   heights  #V, finite, equal for the vertices of one point; 0 counts as above, so that one rule
//            holds and no vertex lies on the cut
//   memory   a result that is not needed any more, of an earlier place of a moving cut: its memory
//            is used again
//   need     where the halves part: loops beside that stay whole (see needed()), and the mesh then
//            consists of triangles; null: everywhere
//   on       vertices that near lie on the cut, and no height is moved: the cut goes through them,
//            faces on it are not cut, and what only touches it is not parted, so that nothing
//            becomes thinner than that; null: none do
// O(#V + #C), and O(k log k) for k cut faces. The same bits for any number of threads. [Schein,
// thesis, chapter 6]
CutMesh cut(const Mesh& mesh, std::span<const double> heights, CutMesh memory = {},
            const CutNeed* need = nullptr, const OnCut* on = nullptr);

} // namespace trivar
