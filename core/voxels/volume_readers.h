// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/voxels/sample_type.h"
#include "core/voxels/volume_frame.h"
#include "core/voxels/volume_options.h"
#include "core/voxels/volume_source.h"

namespace trivar {

// There is one reader per format. Each gives the samples and where they lie; sizes are checked
// against the bytes before memory is taken. What all volumes have in common (finite values, the
// file's name in sentences) is seen to by read_volume. All of them throw Rejected.
VoxelGrid read_nrrd(VolumeSource& source, const ReadVolumeOptions& options);
VoxelGrid read_nifti(VolumeSource& source, const ReadVolumeOptions& options);
VoxelGrid read_meta_image(VolumeSource& source, const ReadVolumeOptions& options);
VoxelGrid read_legacy_vtk(VolumeSource& source, const ReadVolumeOptions& options);
VoxelGrid read_vti(VolumeSource& source, const ReadVolumeOptions& options);
VoxelGrid read_raw(VolumeSource& source, const ReadVolumeOptions& options);

// The unit of a file: as the user says, else as the file, else millimetres. `of_file` is in metres,
// 0 where the file says nothing.
inline double metres_per_unit(const ReadVolumeOptions& options, double of_file)
{
    constexpr double millimetre = 1e-3;
    if (options.metres_per_unit) return *options.metres_per_unit;
    return of_file > 0 ? of_file : millimetre;
}

// A grid of samples that were read, with the sentence for what they lost.
VoxelGrid grid_of(VolumeSource& source, const SampleBlock& block, TakenSamples samples,
                  const VolumeFrame& frame, double metres_per_unit);

} // namespace trivar
