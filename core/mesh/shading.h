// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/mesh/mesh.h"

#include <optional>

namespace trivar {

// The angle above which faces that meet have an edge between them, if nothing else is known.
inline constexpr float usual_edge_deg = 35;

// The mesh with the normals of its faces where it has none: where a normal is 0 or not finite, and
// everywhere if it has no normals. Given normals are made unit and stay. At a point the faces that
// hang together over smooth edges share one normal, their mean weighted by area: an edge is smooth
// between two faces that meet there at no more than `smooth_up_to_deg` degrees, or, if `smoothing`
// has a group for each face, #F, between two faces of one group; group 0 is none. Where no face
// differs from the mean of all at the point by more than half of the angle, they share one, too.
// From 180 degrees on all faces at a point do; with 0 every face is flat. A vertex whose corners
// get several normals is split; `points`, faces and their order stay. If no normal was given,
// tangents are dropped, because they belong to other normals. O(#C log valence); the same bits for
// any number of threads.
Mesh with_normals_of_faces(Mesh mesh, float smooth_up_to_deg,
                           const std::vector<std::uint32_t>& smoothing = {});

// The same in place of all normals that the mesh has.
Mesh shaded(Mesh mesh, float smooth_up_to_deg);

// The angle by which shaded() gives the mesh the edges that it shows: 0, or the usual one; none if
// it shows others, or none at all. Its normals then say nothing that its faces do not. O(#C log
// valence).
std::optional<float> shading_of(const Mesh& mesh);

// Whether faces that are shaded flat are many and meet at small angles, as those of a scan do:
// smooth they would look better.
bool looks_smooth(const Mesh& mesh);

} // namespace trivar
