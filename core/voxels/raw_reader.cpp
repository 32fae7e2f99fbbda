// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/voxels/volume_readers.h"

#include <fmt/format.h>

namespace trivar {
namespace {

// Returns the layout that the name says. Throws Rejected with the possible ones.
RawLayout guessed_layout(VolumeSource& source)
{
    const std::vector<RawGuess> guesses = raw_guesses(source.name(), source.size());
    if (!guesses.empty() && guesses[0].named) {
        const RawLayout& layout = guesses[0].layout;
        const bool alone = guesses.size() == 1 || !guesses[1].named;
        source.say(fmt::format(
            "was read as {}{}, as its name and its number of bytes say", words_of(layout),
            size_of(layout.block.type) == 1  ? ""
            : layout.order == ByteOrder::big ? ", most significant byte first"
                                             : ", least significant byte first"));
        if (!alone) source.say(fmt::format("could also be {}", words_of(guesses[1].layout)));
        return layout;
    }
    std::string could;
    constexpr std::size_t most_said = 3;
    for (std::size_t k = 0; k < std::min(most_said, guesses.size()); ++k)
        could += (k == 0 ? "; it could be " : " or ") + words_of(guesses[k].layout);
    source.refuse(fmt::format("a file without a head does not say its size and type, and {} bytes "
                              "do not tell them; give them, or name it such as "
                              "head_64x64x64_u16.raw{}",
                              with_commas(source.size()), could));
}

} // namespace

ReadVolume read_raw(VolumeSource& source, const ReadVolumeOptions& options)
{
    const RawLayout layout = options.raw ? *options.raw : guessed_layout(source);
    check_block(layout.block, source.name());
    if (layout.header_bytes > source.size())
        source.refuse(fmt::format("has {} bytes; {} should be skipped", with_commas(source.size()),
                                  with_commas(layout.header_bytes)));
    check_bytes(layout.block, source.size() - layout.header_bytes, source.name());
    if (options.spacing == glm::dvec3(1))
        source.say("it does not say how far its samples are apart; 1 mm was taken");
    PartTaker taker(layout.block, options, source.name(), source.progress());
    if (taker.wants_samples())
        taker.take(stream_of(source.file(), layout.header_bytes), layout.order);
    return volume_of(source, taker, layout.block.type, upright_frame(options.spacing),
                     metres_per_unit(options, 0));
}

} // namespace trivar
