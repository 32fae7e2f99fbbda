// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/passes/targets.h"
#include "gpu/passes/tools.h"
#include "gpu/picture.h"

namespace trivar::gpu {

ProgramName wire_program(bool copies);

// The edges of the scene's faces over the lit surfaces, for items that have them; fainter where
// they are so many, or so short in the picture, that they would cover everything.
void draw_wire(Tools& tools, const Targets& targets, const Frame& frame, const Scene& scene,
               const EdgeStyle& style);

} // namespace trivar::gpu
