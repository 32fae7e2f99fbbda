// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/placement/surface_table.h"
#include "core/placement/view.h"

#include <vector>

namespace trivar {

// A point of the scene and the parameters of the contact surface that is seen in front of it, or
// should be.
struct SceneSample {
    glm::dvec3 p_world;
    glm::dvec2 uv;
};

// How far the surface is in front of the sample (negative: behind), and where.
struct Gap {
    glm::dvec2 uv;
    double gap = 0;      // metres along the line of sight
    bool inside = false; // the strip covers the sample
};

// Newton steps toward S(uv) = p - gap d, d the line of sight, from the parameters of the sample;
// the last one is not taken but exact to second order. Where they do not settle, nothing covers it.
// The strip may be asked for as it would be, were it wider by so many `more_cells` on all sides.
Gap gap_at(const SurfaceTable& s, const View& view, const SceneSample& sample,
           double more_cells = 0);

// The gaps of all samples, which keep the parameters found. Parallel.
std::vector<Gap> gaps(const SurfaceTable& s, const View& view, std::vector<SceneSample>& samples);

} // namespace trivar
