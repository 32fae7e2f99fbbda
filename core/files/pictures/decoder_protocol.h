// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

// The messages between Trivar and trivar-picture, which are built from the same source and run on
// one machine. A message is one of these structs, then as many bytes as it says.
namespace trivar {

// A message to the helper: a picture to decode. Words follow (the format's name, then tags, each
// ended by a null byte), then the file's bytes.
struct DecoderOrder {
    std::uint64_t file_bytes = 0, word_bytes = 0;
    std::uint64_t memory_bytes = 0; // it may take beside what it holds at its start
    std::int32_t width_px = 0, height_px = 0;
    std::uint32_t cpu_s = 0;   // of the processor's time it may take
    std::uint32_t numbers = 0; // 1: rows are numbers and not colours
};

// A message of the helper: ready, pixel rows, complete, with words (tags and their texts, each
// ended by a null byte), or damaged.
struct DecoderAnswer {
    enum class What : std::uint32_t { ready, rows, whole, damaged } what = What::damaged;
    std::int32_t bits = 0; // a channel of the file, where it is whole
    std::uint64_t bytes = 0;
};

// The status with which the helper ends when it may take no more memory.
constexpr int no_memory_status = 3;

} // namespace trivar
