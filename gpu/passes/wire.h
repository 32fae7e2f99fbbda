// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu/passes/targets.h"
#include "gpu/passes/tools.h"
#include "gpu/picture.h"

namespace trivar::gpu {

// The program with what add_placing() tells of an item.
ProgramName wire_program(std::vector<std::string> defines);

// Draws the edges of the scene's faces over the lit surfaces, for items that have edges; fainter
// where there are so many, or such short ones in the picture, that they would cover everything.
void draw_wire(Tools& tools, const Targets& targets, const Frame& frame, const Scene& scene,
               const EdgeStyle& style);

} // namespace trivar::gpu
