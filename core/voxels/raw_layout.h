// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/voxels/sample_type.h"

#include <cstdint>
#include <string>
#include <vector>

namespace trivar {

// A RawLayout tells how samples lie in a file that does not say it itself.
struct RawLayout {
    SampleBlock block;
    ByteOrder order = ByteOrder::little;
    std::uint64_t header_bytes = 0; // before the samples
    bool operator==(const RawLayout&) const = default;
};

// A layout that fits a file, and whether the file's name says its sizes.
struct RawGuess {
    RawLayout layout;
    bool named = false;
};

// Layouts that give exactly so many bytes, the likeliest first, at most 12. The name may say sizes
// (head_256x256x128.raw), the type (u8, uint16, short, float, 16bit) and the order of bytes (le,
// be); else cubes and stacks of square slices are tried. Empty: nothing fits.
std::vector<RawGuess> raw_guesses(const std::string& name, std::uint64_t bytes);

// "256 x 256 x 128 unsigned 8-bit whole numbers"; for lists of guesses.
std::string words_of(const RawLayout& layout);

} // namespace trivar
