// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/surface_table.h"
#include "core/placement/view.h"

#include <vector>

namespace trivar {

// A SceneSample is a point of the scene, with the parameters of the contact surface that is seen in
// front of the point, or should be.
struct SceneSample {
    glm::dvec3 p_world;
    glm::dvec2 uv;
};

// A Gap says how far the surface is in front of a sample (negative: behind), and where on the
// surface.
struct Gap {
    glm::dvec2 uv;
    double gap = 0;      // metres along the line of sight
    bool inside = false; // the strip covers the sample
};

// Measures the gap of a sample, by Newton steps toward S(uv) = p - gap d, with d the line of sight.
//   sample      its uv is the start
//   more_cells  asks about a strip that is wider by so many cells on all sides
// The last step is not taken, but the gap is exact to second order. If the steps do not settle, the
// sample is not covered.
Gap gap_at(const SurfaceTable& s, const View& view, const SceneSample& sample,
           double more_cells = 0);

// The gaps of all samples; each sample keeps the parameters that were found. Parallel.
std::vector<Gap> gaps(const SurfaceTable& s, const View& view, std::vector<SceneSample>& samples);

} // namespace trivar
