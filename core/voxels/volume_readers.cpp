// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/volume_readers.h"

namespace trivar {

VoxelGrid grid_of(VolumeSource& source, const SampleBlock& block, TakenSamples samples,
                  const VolumeFrame& frame, double metres_per_unit)
{
    VoxelGrid grid;
    for (int k = 0; k < 3; ++k)
        grid.size[k] = static_cast<int>(block.size[static_cast<std::size_t>(k)]);
    grid.samples = std::move(samples.samples);
    grid.to_metres = to_metres_of(frame, metres_per_unit);
    if (const auto sentence = rounded_sentence(samples.rounded, block.type)) source.say(*sentence);
    return grid;
}

} // namespace trivar
