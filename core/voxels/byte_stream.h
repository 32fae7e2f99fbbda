// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/ordinary_file.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace trivar {

// A ByteFile is the bytes of a file, on the disk or in memory, of which any part can be read. On
// the disk only the requested part is read. Copies are the same file.
class ByteFile {
public:
    // Reads bytes that outlive it, or bytes that it keeps.
    explicit ByteFile(std::string_view bytes) : bytes_(bytes) {}
    static ByteFile kept(std::string bytes);
    static ByteFile opened(const std::string& path); // throws Rejected

    std::uint64_t size() const { return file_ ? file_->size() : bytes_.size(); }
    bool is_in_memory() const { return !file_; }
    // The bytes from a place on, at most `count`: a view of its own memory, else of `buffer`, which
    // holds them then. Throws Rejected.
    std::string_view part(std::uint64_t at, std::uint64_t count, std::string& buffer) const;
    // Reads from a place on, as many bytes as fit; their number is less only at the end.
    std::size_t read(std::uint64_t at, std::span<char> to) const;

private:
    std::string_view bytes_;
    std::shared_ptr<const std::string> kept_;
    std::shared_ptr<const OrdinaryFile> file_;
};

// A ByteStream gives bytes in order, once. Both functions return how many there were, which is less
// than was asked for only at the end; they throw Rejected where the stream is damaged.
struct ByteStream {
    std::function<std::size_t(std::span<char>)> read;
    std::function<std::uint64_t(std::uint64_t)> skip;
};

// Returns the bytes of a file from a place on, at most `count`; skipped bytes are not read.
ByteStream stream_of(ByteFile file, std::uint64_t at, std::uint64_t count = ~std::uint64_t{0});
// Makes a stream from a read function; skipped bytes are read.
ByteStream stream_of(std::function<std::size_t(std::span<char>)> read);

// The first `count` bytes of a stream that is to have just these. As soon as all of them were read
// or skipped it is looked whether more follow. `wrong` gets the number of bytes where the stream
// has fewer, and count + 1 where it has more; it throws.
ByteStream exactly(ByteStream stream, std::uint64_t count,
                   std::function<void(std::uint64_t)> wrong);

// ByteTurns is the layout of a stream that holds several things in turn: `run` bytes of each,
// `turns` times.
struct ByteTurns {
    std::uint64_t things = 1, run = 0, turns = 0;
};
// The bytes of one thing, from 0; after its last ones the rest of the stream is skipped. Short runs
// are read in blocks, so that the cost is that of reading all things once.
ByteStream one_of(ByteStream stream, ByteTurns turns, std::uint64_t thing);

// Streams behind one another; `next` gives the one with that number when those before have ended.
ByteStream joined(std::size_t count, std::function<ByteStream(std::size_t)> next);

} // namespace trivar
