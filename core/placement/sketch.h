// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/placement_input.h"
#include "core/spline/curve.h"

namespace trivar {

constexpr double ring_closing_px = 10; // a stroke that ends this near its start is a ring

// The samples of a stroke as points of the picture. Neighbours closer than half a pixel become one
// point, and a long recording is thinned to 1,000 points, evenly along the stroke. Throws Rejected
// for a camera or a sample that is not finite, a click, a stroke shorter than 8 pixels, and a
// stroke that leaves the picture.
std::vector<glm::dvec2> stroke_points(const Sketch& sketch);

// A cubic through the first and the last point that stays within the tolerance of the others where
// it can: least squares over chord-length parameters, with knots added where it strays, at most 200
// control points. The domain is [0, 1]. A stroke of at least 100 pixels that ends within
// ring_closing_px of its start is a ring: the curve is closed, and smooth where it closes.
Curve<glm::dvec2> fit_sketch(const std::vector<glm::dvec2>& points, double tolerance_px = 2);

// Curvature, 1/pixels; positive where the curve turns to its left as the user sees it.
double curvature(const CurveJet<glm::dvec2>& jet);

// Unit normal to the left of the direction of travel as the user sees it (y goes down).
glm::dvec2 left_normal(const CurveJet<glm::dvec2>& jet);

} // namespace trivar
