// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/sample_type.h"

#include "core/base/rejected.h"
#include "core/files/file_sentences.h"

#include <fmt/format.h>
#include <limits>

namespace trivar {
namespace {

constexpr std::int64_t most_along_axis = std::numeric_limits<std::int32_t>::max();

std::string sizes_in_words(const SampleBlock& block)
{
    return fmt::format("{} x {} x {}", block.size[0], block.size[1], block.size[2]);
}

} // namespace

std::size_t size_of(SampleType type)
{
    switch (type) {
    case SampleType::u8:
    case SampleType::i8: return 1;
    case SampleType::u16:
    case SampleType::i16: return 2;
    case SampleType::u32:
    case SampleType::i32:
    case SampleType::f32: return 4;
    case SampleType::u64:
    case SampleType::i64:
    case SampleType::f64: return 8;
    }
    return 0;
}

std::size_t kept_size_of(SampleType type)
{
    constexpr std::size_t of_float = 4, whole = 2; // what is longer than `whole` becomes a float
    return size_of(type) <= whole ? size_of(type) : of_float;
}

VoxelGrid::Samples samples_for(SampleType type, std::size_t count)
{
    switch (type) {
    case SampleType::u8: return std::vector<std::uint8_t>(count);
    case SampleType::i8: return std::vector<std::int8_t>(count);
    case SampleType::u16: return std::vector<std::uint16_t>(count);
    case SampleType::i16: return std::vector<std::int16_t>(count);
    default: return std::vector<float>(count);
    }
}

const char* words_of(SampleType type)
{
    switch (type) {
    case SampleType::u8: return "unsigned 8-bit whole numbers";
    case SampleType::i8: return "signed 8-bit whole numbers";
    case SampleType::u16: return "unsigned 16-bit whole numbers";
    case SampleType::i16: return "signed 16-bit whole numbers";
    case SampleType::u32: return "unsigned 32-bit whole numbers";
    case SampleType::i32: return "signed 32-bit whole numbers";
    case SampleType::u64: return "unsigned 64-bit whole numbers";
    case SampleType::i64: return "signed 64-bit whole numbers";
    case SampleType::f32: return "32-bit floating point numbers";
    case SampleType::f64: return "64-bit floating point numbers";
    }
    return "";
}

std::size_t SampleBlock::bytes() const
{
    return static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) *
           static_cast<std::size_t>(size[2]) * size_of(type);
}

void check_block(const SampleBlock& block, const std::string& name)
{
    std::uint64_t bytes = size_of(block.type);
    for (const std::int64_t count : block.size) {
        if (count < 1 || count > most_along_axis)
            throw Rejected(fmt::format("{}: its size is {}; a volume has 2 to {} samples along "
                                       "each axis",
                                       name, sizes_in_words(block), with_commas(most_along_axis)));
        if (bytes > std::numeric_limits<std::uint64_t>::max() / static_cast<std::uint64_t>(count))
            throw Rejected(fmt::format("{}: {} voxels are more than any file holds", name,
                                       sizes_in_words(block)));
        bytes *= static_cast<std::uint64_t>(count);
    }
    for (const std::int64_t count : block.size)
        if (count < 2)
            throw Rejected(fmt::format("{}: its size is {}, which is no volume: it needs at least "
                                       "2 samples along each axis",
                                       name, sizes_in_words(block)));
}

void check_bytes(const SampleBlock& block, std::uint64_t present, const std::string& name)
{
    if (present == block.bytes()) return;
    throw Rejected(fmt::format("{} has {} {} of samples; {} voxels of {} bits need {}", name,
                               with_commas(present), present == 1 ? "byte" : "bytes",
                               sizes_in_words(block), 8 * size_of(block.type),
                               with_commas(block.bytes())));
}

std::optional<std::string> rounded_sentence(std::size_t rounded, SampleType type)
{
    if (rounded == 0) return {};
    return fmt::format("{} of its {} {} rounded to 32-bit floating point", with_commas(rounded),
                       words_of(type), rounded == 1 ? "was" : "were");
}

} // namespace trivar
