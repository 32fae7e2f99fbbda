// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/number_text.h"
#include "core/voxels/voxel_grid.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace trivar {

// The types of samples in files of volumes.
enum class SampleType { u8, i8, u16, i16, u32, i32, u64, i64, f32, f64 };
enum class ByteOrder { little, big };

std::size_t size_of(SampleType type);      // in bytes
std::size_t kept_size_of(SampleType type); // of a sample in memory, bytes
const char* words_of(SampleType type);     // "unsigned 16-bit whole numbers"

// A SampleBlock describes the samples that follow a head: their number along each axis, and their
// type.
struct SampleBlock {
    std::array<std::int64_t, 3> size{};
    SampleType type = SampleType::u8;
    std::size_t bytes() const; // only of a block that passed check_block
    bool operator==(const SampleBlock&) const = default;
};

// Throws Rejected where a size is below 2 or above 2^31 - 1, or where the bytes of such a block
// cannot be counted. `name` is that of the file, for the sentence.
void check_block(const SampleBlock& block, const std::string& name);

// Throws Rejected where the number of bytes that are there for a checked block is another one than
// it needs.
void check_bytes(const SampleBlock& block, std::uint64_t present, const std::string& name);

// Samples of a grid, of the bytes of a file: whole numbers of 8 and 16 bits as they are, all others
// as floats.
struct TakenSamples {
    VoxelGrid::Samples samples;
    std::size_t rounded = 0; // number of values that a float does not hold exactly
};
TakenSamples taken_samples(std::string_view bytes, SampleType type, ByteOrder order);

// The same of numbers in words, as ASCII files have them, separated by blanks, ends of lines or
// commas. Throws Rejected where there are more or fewer than the block has, or a word is no number
// of the type; "nan" and "inf" are numbers of f32 and f64.
TakenSamples taken_words(std::string_view text, const SampleBlock& block, const std::string& name);

// Samples for a type, all 0.
VoxelGrid::Samples samples_for(SampleType type, std::size_t count);

// The sentence for values that were rounded; nothing for none.
std::optional<std::string> rounded_sentence(std::size_t rounded, SampleType type);

} // namespace trivar
