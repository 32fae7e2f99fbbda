// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/voxels/volume_summary.h"

namespace trivar {

// The value that parts the values of a volume best: the variance between both parts is greatest
// [Otsu 1979]. Of whole numbers it is half a step above one, so that no sample is at the level.
double usual_level(const VolumeSummary& summary, const VoxelGrid& grid);

// Returns that value, and the one that divides the part above it likewise: of a CT of a head skin
// and bone.
std::array<double, 2> usual_levels(const VolumeSummary& summary, const VoxelGrid& grid);

} // namespace trivar
