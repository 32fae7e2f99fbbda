// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/progress.h"
#include "gpu/ffd/deform_timer.h"

#include <optional>

namespace trivar::gpu {

// A DeformCase is one measurement: a sphere that fills a lattice of uniform knots, with order
// `order` and `lattice` control points on every axis.
struct DeformCase {
    Way way = Way::two_phases;
    Method method;
    int order = 3, lattice = 8;
    std::size_t vertices = 0;
    int passes = 0; // number of passes that draw the vertices; see DeformTimer::time_ms()
    bool operator==(const DeformCase&) const = default;
};

// DeviceFigures hold the best rates of a device.
struct DeviceFigures {
    std::string name;               // vendor, renderer, version
    double copy_bytes_per_s = 0;    // read and written by copies of buffers
    double multiply_adds_per_s = 0; // in a compute shader, single precision
};

struct DeformRate {
    DeformCase what;
    double time_ms = 0; // the least of several runs
    double vertices_per_s = 0;
    // The rates that copying alone, and multiply-adds alone, would allow on the device; 0 for the
    // processor.
    double copy_allows_per_s = 0, arithmetic_allows_per_s = 0;
    // The differences from the processor, where they were compared: the largest distance of
    // positions as a share of the box, and the largest angle between normals.
    std::optional<double> position_error = {}, normal_error_deg = {};
};

struct DeformReport {
    DeviceFigures device;
    std::vector<DeformRate> rates;
    std::vector<std::string> notices; // what was left out, and why
};

// The bytes that are read and written per vertex, in all passes together, and the multiply-adds of
// its sums.
double bytes_a_vertex(const DeformCase& what);
double multiply_adds(const DeformCase& what);

// The cases that `trivar bench gpu` measures: 10^5 vertices, then 10^6, then 10^7.
std::vector<DeformCase> every_deform_case();

// A DeformBudget limits the time of measuring. A case is left out if it would take longer than
// `run_s` per run, as an earlier case of its kind with fewer vertices shows; so are all cases that
// have not begun after `all_s`.
struct DeformBudget {
    double run_s = 1, all_s = 480;
};

// Measures in the current context, by timer queries or, on software GL, fences. Notices tell what
// is left out and what is impossible. Throws Rejected where the device cannot deform at all.
DeformReport deform_rates(const std::vector<DeformCase>& cases, const DeformBudget& budget,
                          const Progress& progress = {});

} // namespace trivar::gpu
