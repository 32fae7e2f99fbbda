// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/volume_readers.h"

#include "core/voxels/coarsened.h"

namespace trivar {

glm::dmat4 place_of(const GridPart& part, const glm::dmat4& to_metres)
{
    return coarsened_place(cropped_place(to_metres, part.box), part.step());
}

ReadVolume volume_of(VolumeSource& source, PartTaker& taker, SampleType type,
                     const VolumeFrame& frame, double metres_per_unit)
{
    ReadVolume out;
    TakenSamples samples = taker.finish();
    out.part = taker.part();
    out.grid.size = out.part.size();
    out.grid.samples = std::move(samples.samples);
    out.grid.to_metres = place_of(out.part, to_metres_of(frame, metres_per_unit));
    if (const auto sentence = rounded_sentence(samples.rounded, type)) source.say(*sentence);
    return out;
}

} // namespace trivar
