// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/voxels/voxel_grid.h"

#include <string>

namespace trivar {

// The bytes of a volume as an NRRD file: raw, attached, in millimetres, LPS. Its samples and its
// place are kept, and read_volume gives them back to the last bit of the samples. NRRD knows no
// slope and intercept: where there are any, values are written, as floats.
std::string write_nrrd(const VoxelGrid& grid);

// The same as a NIfTI-1 file (.nii), with slope and intercept; its matrix has 32-bit numbers.
// Throws Rejected where a size is above 32767, which the format cannot say.
std::string write_nifti(const VoxelGrid& grid);

} // namespace trivar
