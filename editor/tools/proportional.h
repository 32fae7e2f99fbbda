// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/shaping.h"

#include <string>
#include <vector>

namespace trivar {

// How a motion fades with the distance from what is moved: 1 there, 0 from the radius on.
enum class Falloff { smooth, sphere, root, linear, sharp, constant };
double falloff(Falloff kind, double x); // x = distance / radius
inline const std::vector<std::string> falloff_names{"Smooth", "Sphere", "Root",
                                                    "Linear", "Sharp",  "Constant"};

// Neighbours of the chosen points go with them, the less the further they are away.
struct Proportional {
    bool on = false;
    Falloff kind = Falloff::smooth;
    double radius_m = 0; // 0: half of the volume's longest side
};

// A control point, and how far it is from the nearest one that a shift has hold of, mirrored ones
// among them, metres.
struct PointDistance {
    glm::ivec3 point{0};
    double metres = 0;
};
// First those of the shift, at 0; all on the side of its first one where it mirrors. O(number of
// control points times that of the shift).
std::vector<PointDistance> by_distance(const Lattice& volume, const PointShift& shift);

// The same shift of these and of all within the radius, each by its share.
PointShift with_neighbours(PointShift shift, const std::vector<PointDistance>& points, Falloff kind,
                           double radius_m);

} // namespace trivar
