// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/ffd/deform_rates.h"

namespace trivar::gpu {

// What copying and multiply-adds would allow at most, and which of the two says so.
double allowed_per_s(const DeformRate& rate);
const char* bound_by(const DeformRate& rate);

// What the rates of a report say, a sentence each, each of the most vertices that it was measured
// with: how near to its bound the device comes, what normals cost, what passes cost each way.
std::vector<std::string> findings(const DeformReport& report);

} // namespace trivar::gpu
