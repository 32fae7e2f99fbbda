// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/shader_source.h"

namespace trivar::gpu::testing {

// Every program in every variant that some picture needs.
std::vector<ProgramName> every_program();

} // namespace trivar::gpu::testing
