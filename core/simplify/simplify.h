// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "core/base/ref.h"
#include "core/mesh/mesh.h"

#include <optional>

namespace trivar {

// SimplifyOptions are two goals, of which the first one met ends the work. Without any, nothing is
// done.
struct SimplifyOptions {
    // The greatest number of triangles, not counting those left out; lines that are kept may need
    // more.
    std::optional<std::size_t> triangles;
    // The greatest deviation: no point of the old mesh is to be further than that from the new one,
    // nor of the new one from the old; in the unit of the mesh.
    std::optional<double> error;
    // Positions of the vertices at other moments, as of a clip, #V each. Parts that are flat at
    // rest but bend there are kept, and the error bound holds there too. Morph targets need not be
    // listed: they always count in full.
    std::vector<std::vector<glm::vec3>> poses;
    bool measured = false; // whether the error of a number of triangles is wanted too
};

struct SimplifiedMesh {
    Ref<Mesh> mesh; // the one that was given where nothing was to be done
    std::size_t triangles_before = 0, triangles = 0;
    std::size_t left_out = 0; // of them: round edges of more than two faces and the like, kept
    // The proven greatest distance of a point of either mesh from the other, in any pose, rounding
    // of single precision included. It is the error asked for if one was given; otherwise, if it
    // was measured, at most a quarter more than the least provable, and infinite if it was not. 0
    // if nothing was done.
    double error = 0;
};

// Returns the mesh with fewer triangles. Its vertices are some of the old ones with all they have:
// colours, texture coordinates, influences, morph targets. Colours count too: black in place of
// white as much as a movement by 2 % of the size, and no vertex goes whose place would get another
// colour by more than a fifth of that.
//
// Lines are kept, with fewer points: borders, creases, hard edges, seams of texture coordinates and
// of colours, edges between materials and groups. Closed surfaces stay closed, and holes stay
// holes. Polygons that did not change stay polygons. Normals are taken anew where faces changed,
// unless a hard edge splits them; if all follow from the faces (core/mesh/shading.h), and hard
// edges are in the way of the goal, they are none.
//
// Cost: 2 to 10 us a triangle to a number, about 30 to an error; twice that if normals follow from
// the faces, to an error always and to a number if it is not reached. The same bits for any number
// of threads. Throws Rejected for an error that is not a number from 0 up and for poses of another
// mesh; and what `progress` throws, to cancel.
SimplifiedMesh simplified(const Ref<Mesh>& mesh, const SimplifyOptions& options,
                          const Progress& progress = {});

} // namespace trivar
