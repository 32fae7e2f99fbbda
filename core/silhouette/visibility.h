// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/level/level_body.h"
#include "core/silhouette/silhouettes.h"

namespace trivar {

// Whether a body hides a point from an eye.
//   to_eye    unit, voxels
//   distance  of the eye, voxels
// A line of sight that leaves a point of the body's own silhouette is at a double root there, so it
// is tested from a tenth of a voxel on. Between two points outside, the cubic through values and
// slopes tells whether the line may have been inside; the last place is the end of the grid or the
// eye. It errs at 0.02 % of points at most. 0.3 to 3 us: bricks whose hull leaves out the level are
// passed at once.
bool hides(const LevelBody& body, const glm::vec3& p, const glm::vec3& to_eye, float distance);

// Returns for each point of the silhouettes whether their own body or one of the others hides it.
// The own body hides a point at which it is hollow along the line of sight; border lines have no
// bend, so rays alone tell.
std::vector<char> hidden_points(const Silhouettes& silhouettes, const ViewPoint& view,
                                const LevelBody& own, std::span<const LevelBody> others = {});
// Do the same in two steps, for bodies that come slab by slab: the points hidden where they are,
// and those already hidden with those that bodies hide.
std::vector<char> hollow_points(const Silhouettes& silhouettes, LevelSide side);
std::vector<char> hidden_by(std::vector<char> hidden, const Silhouettes& silhouettes,
                            const ViewPoint& view, std::span<const LevelBody> bodies);

} // namespace trivar
