// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/ffd/deform_rates.h"

namespace trivar::gpu {

// The greatest rate that copying and multiply-adds allow; the second function says which of both
// limits it.
double allowed_per_s(const DeformRate& rate);
const char* bound_by(const DeformRate& rate);

// Words the rates of a report, one sentence per finding, each about the largest number of vertices
// measured: how near the device comes to its bound, the cost of normals, the cost of passes in each
// way.
std::vector<std::string> findings(const DeformReport& report);

} // namespace trivar::gpu
