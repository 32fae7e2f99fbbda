// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace trivar {

// How the bytes of a file are packed.
enum class Packing { none, gzip, zlib, bzip2 };

// Whether bytes begin as gzip's do.
inline bool is_gzip(std::string_view bytes)
{
    return bytes.starts_with("\x1f\x8b");
}

// Unpacks all of a stream, members behind one another too. Memory is taken as bytes come, so a
// small file never takes much. Throws Rejected where the stream is damaged, ends before its
// checksum, is followed by other bytes, or gives more than `most` bytes.
std::string unpacked(std::string_view bytes, Packing packing, std::uint64_t most,
                     const std::string& name);

// The first bytes of a gzip stream, at most `count`: fewer only where it ends before, or is
// damaged.
std::string first_unpacked(std::string_view bytes, std::size_t count);

// Throws Rejected where so many bytes cannot come out of packed ones: deflate makes at most 1032 of
// one. Nothing is unpacked.
void check_ratio(std::string_view bytes, Packing packing, std::uint64_t needed,
                 const std::string& name);

} // namespace trivar
