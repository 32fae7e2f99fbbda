// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/shader_source.h"

namespace trivar::gpu {

// Every program in every variant that some picture needs, for tests and for compiling ahead.
std::vector<ProgramName> every_program();

} // namespace trivar::gpu
