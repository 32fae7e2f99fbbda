// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/shaping.h"

#include <string>
#include <vector>

namespace trivar {

// A Falloff says how a motion fades with the distance from the chosen points: 1 at the points, 0
// from the radius on.
enum class Falloff { smooth, sphere, root, linear, sharp, constant };
double falloff(Falloff kind, double x); // x = distance / radius
inline const std::vector<std::string> falloff_names{"Smooth", "Sphere", "Root",
                                                    "Linear", "Sharp",  "Constant"};

// A PointDistance is a control point and its distance in metres from the nearest point of a shift,
// mirrored points included.
struct PointDistance {
    glm::ivec3 point{0};
    double metres = 0;
};
// All control points by distance, first those of the shift, at 0; only those on the side of its
// first point where it mirrors. O(#control points times #points of the shift).
std::vector<PointDistance> by_distance(const Lattice& volume, const PointShift& shift);

// The shift of its own points and of all within the radius, each by its share.
PointShift with_neighbours(PointShift shift, const std::vector<PointDistance>& points, Falloff kind,
                           double radius_m);

} // namespace trivar
