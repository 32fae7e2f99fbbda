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

// A stream of zlib's library over bytes in memory.
class Inflater {
public:
    Inflater(std::string_view bytes, Packing packing) : left_(bytes)
    {
        constexpr int largest_window = 15, with_gzip_head = 16;
        // It fails for lack of memory only.
        begun_ = inflateInit2(&stream_, packing == Packing::gzip ? largest_window + with_gzip_head
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
    void again() { inflateReset(&stream_); }

private:
    std::string_view left_;
    z_stream stream_{};
    bool begun_ = false;
};

// The same of bzip2's.
class Bunzipper {
public:
    explicit Bunzipper(std::string_view bytes) : left_(bytes)
    {
        begun_ = BZ2_bzDecompressInit(&stream_, 0, 0) == BZ_OK;
    }
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

template <class Stream>
std::string all_of(Stream& stream, std::string_view magic, std::uint64_t most,
                   const std::string& name)
{
    constexpr std::size_t first_room = 1 << 16, largest_step = std::size_t{1} << 26;
    std::string out;
    while (true) {
        const std::size_t before = out.size();
        // One byte more than there may be tells a stream that is too long.
        const std::uint64_t room = std::min<std::uint64_t>(
            {std::clamp(before, first_room, largest_step), most - before + 1});
        out.resize(before + static_cast<std::size_t>(room));
        const auto [written, state] = stream.fill(out.data() + before, out.size() - before);
        out.resize(before + written);
        if (out.size() > most)
            throw Rejected(fmt::format("{}: its packed data are more than the {} bytes expected",
                                       name, with_commas(most)));
        if (state == StreamState::damaged)
            throw Rejected(fmt::format("{}: its packed data {} after {} bytes", name,
                                       stream.left().empty() ? "end too early" : "are damaged",
                                       with_commas(out.size())));
        if (state == StreamState::ended) {
            if (stream.left().empty()) return out;
            if (magic.empty() || !stream.left().starts_with(magic))
                throw Rejected(fmt::format("{}: {} bytes follow its packed data", name,
                                           with_commas(stream.left().size())));
            stream.again();
        }
    }
}

} // namespace

std::string unpacked(std::string_view bytes, Packing packing, std::uint64_t most,
                     const std::string& name)
{
    most = std::min(most, std::numeric_limits<std::uint64_t>::max() - 1);
    if (packing == Packing::none) return std::string(bytes);
    if (packing == Packing::bzip2) {
        Bunzipper stream(bytes);
        return all_of(stream, "BZh", most, name);
    }
    Inflater stream(bytes, packing);
    return all_of(stream, packing == Packing::gzip ? "\x1f\x8b" : "", most, name);
}

std::string first_unpacked(std::string_view bytes, std::size_t count)
{
    Inflater stream(bytes, Packing::gzip);
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

void check_ratio(std::string_view bytes, Packing packing, std::uint64_t needed,
                 const std::string& name)
{
    constexpr std::uint64_t of_deflate = 1032, of_bzip2 = 50'000; // bytes of one, at most
    const std::uint64_t most =
        packing == Packing::none
            ? bytes.size()
            : bytes.size() * (packing == Packing::bzip2 ? of_bzip2 : of_deflate);
    if (needed > most)
        throw Rejected(fmt::format("{} has {} bytes, which cannot hold the {} that its size and "
                                   "type need",
                                   name, with_commas(bytes.size()), with_commas(needed)));
}

} // namespace trivar
