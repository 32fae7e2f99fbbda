// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/voxels/part_taker.h"
#include "core/voxels/sample_type.h"
#include "core/voxels/volume_frame.h"
#include "core/voxels/volume_options.h"
#include "core/voxels/volume_source.h"

namespace trivar {

// There is one reader per format. Each gives the samples of the part that the options ask for, and
// where they lie, and sets the part; sizes are checked against the bytes before memory is taken.
// What all volumes have in common (finite values, the file's name in sentences) is seen to by
// read_volume. All of them throw Rejected.
ReadVolume read_nrrd(VolumeSource& source, const ReadVolumeOptions& options);
ReadVolume read_nifti(VolumeSource& source, const ReadVolumeOptions& options);
ReadVolume read_meta_image(VolumeSource& source, const ReadVolumeOptions& options);
ReadVolume read_legacy_vtk(VolumeSource& source, const ReadVolumeOptions& options);
ReadVolume read_vti(VolumeSource& source, const ReadVolumeOptions& options);
ReadVolume read_raw(VolumeSource& source, const ReadVolumeOptions& options);

// The unit of a file: as the user says, else as the file, else millimetres. `of_file` is in metres,
// 0 where the file says nothing.
inline double metres_per_unit(const ReadVolumeOptions& options, double of_file)
{
    constexpr double millimetre = 1e-3;
    if (options.metres_per_unit) return *options.metres_per_unit;
    return of_file > 0 ? of_file : millimetre;
}

// Returns how a file of `things` volumes, such as times, holds them: so many of a volume's samples
// in turn. Says which one is taken. Throws Rejected if there is none of the number that is asked
// for, or the bytes of all cannot be counted.
ByteTurns turns_of(VolumeSource& source, const SampleBlock& block, std::uint64_t things,
                   std::uint64_t samples_in_turn);
inline std::uint64_t bytes_of(const ByteTurns& all)
{
    return all.things * all.run * all.turns;
}
// Throws Rejected: there are so many bytes of samples, which is another number.
void refuse_bytes(const SampleBlock& block, const ByteTurns& turns, std::uint64_t present,
                  const std::string& name);
// The samples of that volume, of the bytes of all.
ByteStream chosen_volume(const VolumeSource& source, ByteStream all, const ByteTurns& turns);

// Returns a volume of the part that was taken, with a sentence on the loss of samples. `frame` is
// that of the whole volume.
ReadVolume volume_of(VolumeSource& source, PartTaker& taker, SampleType type,
                     const VolumeFrame& frame, double metres_per_unit);
// Returns the transform of a part, given that of the whole.
glm::dmat4 place_of(const GridPart& part, const glm::dmat4& to_metres);

} // namespace trivar
