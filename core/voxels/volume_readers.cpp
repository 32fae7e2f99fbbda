// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/volume_readers.h"

#include "core/base/rejected.h"
#include "core/files/file_sentences.h"
#include "core/voxels/coarsened.h"

#include <fmt/format.h>
#include <limits>

namespace trivar {

glm::dmat4 place_of(const GridPart& part, const glm::dmat4& to_metres)
{
    return coarsened_place(cropped_place(to_metres, part.box), part.step());
}

ByteTurns turns_of(VolumeSource& source, const SampleBlock& block, std::uint64_t things,
                   std::uint64_t samples_in_turn)
{
    const auto wanted = static_cast<std::uint64_t>(source.time());
    if (wanted > things)
        source.refuse(fmt::format("it holds {}; there is no number {}",
                                  counted(things, "volume", "volumes"), wanted));
    if (things > std::numeric_limits<std::uint64_t>::max() / block.bytes())
        source.refuse(fmt::format("it holds {} volumes, too many", with_commas(things)));
    if (things > 1)
        source.say(fmt::format("it holds {} volumes, such as times, echoes or layers; number {} "
                               "was taken",
                               with_commas(things), wanted));
    const std::uint64_t run = samples_in_turn * size_of(block.type);
    return {things, run, block.bytes() / run};
}

void refuse_bytes(const SampleBlock& block, const ByteTurns& turns, std::uint64_t present,
                  const std::string& name)
{
    if (turns.things == 1) check_bytes(block, present, name);
    throw Rejected(fmt::format("{} has {} bytes of samples; its {} volumes need {} each", name,
                               with_commas(present), with_commas(turns.things),
                               with_commas(block.bytes())));
}

ByteStream chosen_volume(const VolumeSource& source, ByteStream all, const ByteTurns& turns)
{
    if (turns.things == 1) return all;
    return one_of(std::move(all), turns, static_cast<std::uint64_t>(source.time()) - 1);
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
