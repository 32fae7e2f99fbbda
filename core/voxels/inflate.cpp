// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/inflate.h"

#include "core/base/rejected.h"
#include "core/voxels/sample_type.h"

#include <algorithm>
#include <array>
#include <bzlib.h>
#include <fmt/format.h>
#include <limits>
#include <zlib.h>

namespace trivar {
namespace {

enum class StreamState { going, ended, damaged };

// A stream of zlib's library over bytes in memory, which it is fed with.
class Inflater {
public:
    explicit Inflater(Packing packing)
    {
        constexpr int largest_window = 15, with_gzip_head = 16;
        // It fails for lack of memory only.
        begun_ = inflateInit2(&stream_, packing == Packing::gzip ? largest_window + with_gzip_head
                                        : packing == Packing::deflate ? -largest_window
                                                                      : largest_window) == Z_OK;
    }
    ~Inflater() { inflateEnd(&stream_); }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;

    // Unpacks into a part of memory; the number of bytes that were written, and how it went.
    std::pair<std::size_t, StreamState> fill(char* to, std::size_t room)
    {
        if (!begun_) return {0, StreamState::damaged};
        const auto few = [](std::size_t count) {
            return static_cast<uInt>(std::min<std::size_t>(count, 1u << 30));
        };
        stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(left_.data()));
        stream_.avail_in = few(left_.size());
        stream_.next_out = reinterpret_cast<Bytef*>(to);
        stream_.avail_out = few(room);
        const uInt given = stream_.avail_in, wanted = stream_.avail_out;
        const int result = inflate(&stream_, Z_NO_FLUSH);
        left_.remove_prefix(given - stream_.avail_in);
        const std::size_t written = wanted - stream_.avail_out;
        if (result == Z_STREAM_END) return {written, StreamState::ended};
        const bool stuck = written == 0 && given == stream_.avail_in;
        return {written, result == Z_OK && !stuck ? StreamState::going : StreamState::damaged};
    }
    std::string_view left() const { return left_; }
    // The next packed bytes; all before were used.
    void feed(std::string_view bytes) { left_ = bytes; }
    void again() { inflateReset(&stream_); }

private:
    std::string_view left_;
    z_stream stream_{};
    bool begun_ = false;
};

// The same of bzip2's.
class Bunzipper {
public:
    Bunzipper() { begun_ = BZ2_bzDecompressInit(&stream_, 0, 0) == BZ_OK; }
    ~Bunzipper() { BZ2_bzDecompressEnd(&stream_); }
    Bunzipper(const Bunzipper&) = delete;
    Bunzipper& operator=(const Bunzipper&) = delete;

    std::pair<std::size_t, StreamState> fill(char* to, std::size_t room)
    {
        if (!begun_) return {0, StreamState::damaged};
        const auto few = [](std::size_t count) {
            return static_cast<unsigned>(std::min<std::size_t>(count, 1u << 30));
        };
        stream_.next_in = const_cast<char*>(left_.data());
        stream_.avail_in = few(left_.size());
        stream_.next_out = to;
        stream_.avail_out = few(room);
        const unsigned given = stream_.avail_in, wanted = stream_.avail_out;
        const int result = BZ2_bzDecompress(&stream_);
        left_.remove_prefix(given - stream_.avail_in);
        const std::size_t written = wanted - stream_.avail_out;
        if (result == BZ_STREAM_END) return {written, StreamState::ended};
        const bool stuck = written == 0 && given == stream_.avail_in;
        return {written, result == BZ_OK && !stuck ? StreamState::going : StreamState::damaged};
    }
    std::string_view left() const { return left_; }
    // The next packed bytes; all before were used.
    void feed(std::string_view bytes) { left_ = bytes; }
    void again()
    {
        BZ2_bzDecompressEnd(&stream_);
        stream_ = {};
        begun_ = BZ2_bzDecompressInit(&stream_, 0, 0) == BZ_OK;
    }

private:
    std::string_view left_;
    bz_stream stream_{};
    bool begun_ = false;
};

// Unpacks a part of a file bit by bit.
template <class Stream> class Unpacker {
public:
    // `magic` begins another member that may follow; `filling` bytes may.
    Unpacker(ByteFile file, std::uint64_t at, std::uint64_t count, std::string_view magic,
             std::uint64_t filling, std::string name, auto... of_stream)
        : stream_(of_stream...),
          file_(std::move(file)),
          at_(std::min(at, file_.size())),
          end_(at_ + std::min(count, file_.size() - at_)),
          magic_(magic),
          filling_(filling),
          name_(std::move(name))
    {
    }

    std::size_t read(std::span<char> to)
    {
        std::size_t done = 0;
        while (done < to.size() && !ended_) {
            if (stream_.left().empty()) feed();
            const auto [written, state] = stream_.fill(to.data() + done, to.size() - done);
            done += written;
            given_ += written;
            // A stream that is stuck for lack of bytes goes on once it has some.
            if (state == StreamState::damaged && !(stream_.left().empty() && at_ < end_))
                throw Rejected(fmt::format("{}: its packed data {} after {} bytes", name_,
                                           stream_.left().empty() ? "end too early" : "are damaged",
                                           with_commas(given_)));
            if (state == StreamState::ended) go_on();
        }
        return done;
    }

private:
    void feed()
    {
        constexpr std::uint64_t at_once = std::uint64_t{1} << 20;
        const std::string_view next = file_.part(at_, std::min(at_once, end_ - at_), buffer_);
        at_ += next.size();
        stream_.feed(next);
    }
    // Another member may follow the one that has ended.
    void go_on()
    {
        const std::uint64_t behind = stream_.left().size() + (end_ - at_);
        if (behind <= filling_) {
            ended_ = true;
            return;
        }
        if (stream_.left().size() < magic_.size()) {
            at_ -= stream_.left().size();
            feed();
        }
        if (magic_.empty() || !stream_.left().starts_with(magic_))
            throw Rejected(
                fmt::format("{}: {} bytes follow its packed data", name_, with_commas(behind)));
        stream_.again();
    }

    Stream stream_;
    ByteFile file_;
    std::uint64_t at_, end_; // of what the stream was not fed with yet
    std::string_view magic_;
    std::uint64_t filling_;
    std::string name_, buffer_;
    std::uint64_t given_ = 0;
    bool ended_ = false;
};

} // namespace

ByteStream unpacked(ByteFile file, std::uint64_t at, std::uint64_t count, Packing packing,
                    std::string name)
{
    const auto stream = [](auto unpacker) {
        return stream_of([unpacker](std::span<char> to) { return unpacker->read(to); });
    };
    if (packing == Packing::bzip2)
        return stream(std::make_shared<Unpacker<Bunzipper>>(std::move(file), at, count, "BZh", 0,
                                                            std::move(name)));
    return stream(std::make_shared<Unpacker<Inflater>>(
        std::move(file), at, count, packing == Packing::gzip ? "\x1f\x8b" : "",
        packing == Packing::deflate ? 1 : 0, std::move(name), packing));
}

std::string unpacked(std::string_view bytes, Packing packing, std::uint64_t most,
                     const std::string& name)
{
    constexpr std::size_t first_room = 1 << 16, largest_step = std::size_t{1} << 26;
    if (packing == Packing::none) return std::string(bytes);
    most = std::min(most, std::numeric_limits<std::uint64_t>::max() - 1);
    const ByteStream stream = unpacked(ByteFile(bytes), 0, bytes.size(), packing, name);
    std::string out;
    while (true) {
        const std::size_t before = out.size();
        // One byte more than there may be tells a stream that is too long.
        const std::uint64_t room = std::min<std::uint64_t>(
            {std::clamp(before, first_room, largest_step), most - before + 1});
        out.resize(before + static_cast<std::size_t>(room));
        const std::size_t got = stream.read(std::span(out).subspan(before));
        out.resize(before + got);
        if (out.size() > most) refuse_more(most, name);
        if (got < room) return out;
    }
}

std::string first_unpacked(std::string_view bytes, std::size_t count)
{
    Inflater stream(Packing::gzip);
    stream.feed(bytes);
    std::string out(count, '\0');
    std::size_t filled = 0;
    while (filled < count) {
        const auto [written, state] = stream.fill(out.data() + filled, count - filled);
        filled += written;
        if (state != StreamState::going) break;
    }
    out.resize(filled);
    return out;
}

void check_ratio(std::uint64_t packed, Packing packing, std::uint64_t needed,
                 const std::string& name)
{
    constexpr std::uint64_t of_deflate = 1032, of_bzip2 = 50'000; // bytes of one, at most
    const std::uint64_t most = packing == Packing::none
                                   ? packed
                                   : packed * (packing == Packing::bzip2 ? of_bzip2 : of_deflate);
    if (needed > most)
        throw Rejected(fmt::format("{} has {} bytes, which cannot hold the {} that its size and "
                                   "type need",
                                   name, with_commas(packed), with_commas(needed)));
}

void refuse_more(std::uint64_t most, const std::string& name)
{
    throw Rejected(fmt::format("{}: its packed data are more than the {} bytes expected", name,
                               with_commas(most)));
}

} // namespace trivar
