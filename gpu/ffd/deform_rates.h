// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "gpu/ffd/deform_timer.h"

#include <optional>

namespace trivar::gpu {

// One measurement: a sphere that fills a lattice of uniform knots, `order` and `lattice` control
// points on every axis.
struct DeformCase {
    Way way = Way::two_phases;
    Method method;
    int order = 3, lattice = 8;
    std::size_t vertices = 0;
};

// What a device does at best.
struct DeviceFigures {
    std::string name;               // vendor, renderer, version
    double copy_bytes_per_s = 0;    // read and written by copies of buffers
    double multiply_adds_per_s = 0; // in a compute shader, single precision
};

struct DeformRate {
    DeformCase what;
    double time_ms = 0; // the least of some
    double vertices_per_s = 0;
    // What copying alone, and multiply-adds alone, would allow on the device; 0 for the processor.
    double copy_allows_per_s = 0, arithmetic_allows_per_s = 0;
    // Against the processor, where they were compared: the largest distance of positions as a share
    // of the box, the largest angle between normals.
    std::optional<double> position_error = {}, normal_error_deg = {};
};

struct DeformReport {
    DeviceFigures device;
    std::vector<DeformRate> rates;
    std::vector<std::string> notices; // what was left out, and why
};

// Bytes that a vertex is read and written with, and the multiply-adds of its sum.
double bytes_a_vertex(const Method& method);
double multiply_adds(int order, const Method& method);

// What `trivar bench gpu` measures: 10^5 vertices, then 10^6, then 10^7.
std::vector<DeformCase> every_deform_case();

// Measures in the current context, by timer queries or, on software GL, fences. A case that would
// take longer than `most_s` a run, as one of the same kind with fewer vertices before it shows, is
// left out; what cannot be done is a notice. Throws Rejected where the device cannot deform at all.
DeformReport deform_rates(const std::vector<DeformCase>& cases, double most_s,
                          const Progress& progress = {});

} // namespace trivar::gpu
