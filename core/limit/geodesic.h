// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limit/limit_surface.h"

namespace trivar {

// A GeodesicRay is where a straightest way over a limit surface has come to.
struct GeodesicRay {
    ChartPlace at;
    glm::dvec3 direction{1, 0, 0}; // unit tangent of the way there
    // The spread of neighbouring ways from the same start: j'' = -K j, j = 0 and j' = 1 at the
    // start. The ways meet again where it returns to 0.
    double spread = 0, spread_rate = 1;
    double left = 0; // length that a border cut off
    int creases = 0; // number of creases that it went over
};

// Follows the straightest way over the surface.
//   start  where it begins
//   way    in the tangent plane there; its length is the way's
//   steps  the error falls with their fourth power; at most 4 steps + 32 are made
// Steps are by Runge and Kutta, in the coordinates of charts where these are smooth, and with the
// point in space as the state near extraordinary vertices and creases. A way goes over a crease as
// if both sides were unfolded, and stops at borders. Cost: 1 to 5 us a step in charts, 3 to 15 in
// space.
GeodesicRay geodesic(const LimitSurface& surface, const ChartPlace& start, const glm::dvec3& way,
                     int steps);
// Goes on from where a ray has come to.
void extend(const LimitSurface& surface, GeodesicRay& ray, double length, int steps);

// Chooses the number of steps, 1 to 8, for ways of at most a length from a place: their ends are
// then within a thousandth of the length while length times curvature is at most 1.
int steps_from(const LimitSurface& surface, const ChartPlace& start, double length);

// Finds the place nearest to a point of space, by Newton's method.
//   near       a place near it
//   p          in the space of the surface
//   tolerance  it stops if it comes within this distance, or no nearer
// It slides along borders and creases and does not cross them. At most 12 evaluations.
struct FootPoint {
    ChartPlace at;
    LimitJet jet;
    int edge = -1; // along which it slid; -1: none
};
FootPoint foot_point(const LimitSurface& surface, const ChartPlace& near, const glm::dvec3& p,
                     double tolerance);

} // namespace trivar
