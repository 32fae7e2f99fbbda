// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/voxels/byte_stream.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace trivar {

// The packing of the bytes of a file; deflate is the stream that gzip and zlib hold, without a head
// and a checksum.
enum class Packing { none, gzip, zlib, bzip2, deflate };

// Whether bytes begin as gzip's do.
inline bool is_gzip(std::string_view bytes)
{
    return bytes.starts_with("\x1f\x8b");
}

// The bytes that a packed part of a file gives, members behind one another too: from a place on,
// `count` bytes. They are unpacked as they are asked for, in memory that does not grow. Reading
// throws Rejected where the stream is damaged, ends before its checksum or is followed by other
// bytes; one that fills up an odd number may follow deflate's. `packing` is not none; `name` is
// that of the file, for the sentences.
ByteStream unpacked(ByteFile file, std::uint64_t at, std::uint64_t count, Packing packing,
                    std::string name);

// Unpacks all of a stream. Memory is taken as bytes come, so a small file never takes much. Throws
// Rejected as well where it gives more than `most` bytes.
std::string unpacked(std::string_view bytes, Packing packing, std::uint64_t most,
                     const std::string& name);

// The first bytes of a gzip stream, at most `count`: fewer only where it ends before, or is
// damaged.
std::string first_unpacked(std::string_view bytes, std::size_t count);

// Throws Rejected where so many bytes cannot come out of a packed file of that size: deflate makes
// at most 1032 of one. Nothing is unpacked.
void check_ratio(std::uint64_t packed, Packing packing, std::uint64_t needed,
                 const std::string& name);

// Throws Rejected: more bytes come out than there should be.
[[noreturn]] void refuse_more(std::uint64_t most, const std::string& name);

} // namespace trivar
