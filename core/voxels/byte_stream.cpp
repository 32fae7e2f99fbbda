// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/byte_stream.h"

#include <algorithm>
#include <cstring>
#include <optional>
#include <string>

namespace trivar {
namespace {

constexpr std::size_t skipped_at_once = std::size_t{1} << 18; // bytes

// The same bytes, of which many are read at once.
ByteStream in_blocks(ByteStream stream)
{
    struct State {
        ByteStream stream;
        std::string block;
        std::size_t at = 0;
    };
    const auto state = std::make_shared<State>(State{std::move(stream), {}});
    const auto pass = [state](std::uint64_t bytes, char* to) {
        std::uint64_t done = 0;
        while (done < bytes) {
            if (state->at == state->block.size()) {
                state->block.resize(skipped_at_once);
                state->block.resize(state->stream.read(state->block));
                state->at = 0;
                if (state->block.empty()) break;
            }
            const auto count = static_cast<std::size_t>(
                std::min<std::uint64_t>(bytes - done, state->block.size() - state->at));
            if (to) std::memcpy(to + done, state->block.data() + state->at, count);
            state->at += count;
            done += count;
        }
        return done;
    };
    return {
        [pass](std::span<char> to) { return static_cast<std::size_t>(pass(to.size(), to.data())); },
        [pass](std::uint64_t bytes) { return pass(bytes, nullptr); }};
}

} // namespace

ByteFile ByteFile::kept(std::string bytes)
{
    ByteFile out{std::string_view()};
    out.kept_ = std::make_shared<const std::string>(std::move(bytes));
    out.bytes_ = *out.kept_;
    return out;
}

ByteFile ByteFile::opened(const std::string& path)
{
    ByteFile out{std::string_view()};
    out.file_ = std::make_shared<const OrdinaryFile>(path);
    return out;
}

std::string_view ByteFile::part(std::uint64_t at, std::uint64_t count, std::string& buffer) const
{
    at = std::min(at, size());
    count = std::min(count, size() - at);
    if (!file_) return bytes_.substr(static_cast<std::size_t>(at), static_cast<std::size_t>(count));
    buffer.resize(static_cast<std::size_t>(count));
    file_->read_at(at, buffer);
    return buffer;
}

std::size_t ByteFile::read(std::uint64_t at, std::span<char> to) const
{
    if (file_) return file_->read_at(at, to);
    if (at >= bytes_.size()) return 0;
    return bytes_.copy(to.data(), to.size(), static_cast<std::size_t>(at));
}

ByteStream stream_of(ByteFile file, std::uint64_t at, std::uint64_t count)
{
    struct State {
        ByteFile file;
        std::uint64_t at, left;
    };
    at = std::min(at, file.size());
    const std::uint64_t left = std::min(count, file.size() - at);
    const auto state = std::make_shared<State>(State{std::move(file), at, left});
    const auto pass = [state](std::uint64_t bytes) {
        state->at += bytes;
        state->left -= bytes;
        return bytes;
    };
    return {[=](std::span<char> to) {
                const std::uint64_t wanted = std::min<std::uint64_t>(to.size(), state->left);
                return static_cast<std::size_t>(
                    pass(state->file.read(state->at, to.first(static_cast<std::size_t>(wanted)))));
            },
            [=](std::uint64_t bytes) { return pass(std::min(bytes, state->left)); }};
}

ByteStream stream_of(std::function<std::size_t(std::span<char>)> read)
{
    return {
        read, [read](std::uint64_t bytes) {
            std::string unused(
                static_cast<std::size_t>(std::min<std::uint64_t>(bytes, skipped_at_once)), '\0');
            std::uint64_t done = 0;
            while (done < bytes) {
                const std::size_t wanted =
                    static_cast<std::size_t>(std::min<std::uint64_t>(bytes - done, unused.size()));
                const std::size_t got = read(std::span(unused).first(wanted));
                done += got;
                if (got < wanted) break;
            }
            return done;
        }};
}

ByteStream exactly(ByteStream stream, std::uint64_t count, std::function<void(std::uint64_t)> wrong)
{
    struct State {
        ByteStream stream;
        std::uint64_t done = 0;
    };
    const auto state = std::make_shared<State>(State{std::move(stream)});
    const auto taken = [=](std::uint64_t got, std::uint64_t wanted) {
        state->done += got;
        if (got < wanted) wrong(state->done);
        char one = 0;
        if (got > 0 && state->done == count && state->stream.read(std::span(&one, 1)) > 0)
            wrong(count + 1);
        return got;
    };
    return {
        [=](std::span<char> to) {
            const auto wanted =
                static_cast<std::size_t>(std::min<std::uint64_t>(to.size(), count - state->done));
            return static_cast<std::size_t>(taken(state->stream.read(to.first(wanted)), wanted));
        },
        [=](std::uint64_t bytes) {
            const std::uint64_t wanted = std::min(bytes, count - state->done);
            return taken(state->stream.skip(wanted), wanted);
        }};
}

ByteStream one_of(ByteStream stream, ByteTurns turns, std::uint64_t thing)
{
    struct State {
        ByteStream stream;
        std::uint64_t turn = 0, left = 0; // of the run
    };
    constexpr std::uint64_t short_run = 1 << 12; // bytes
    if (turns.run < short_run) stream = in_blocks(std::move(stream));
    const auto state = std::make_shared<State>(State{std::move(stream)});
    // Passes so many bytes of the thing, run by run.
    const auto pass = [=](std::uint64_t bytes, auto&& by) {
        std::uint64_t done = 0;
        while (done < bytes && (state->left > 0 || state->turn < turns.turns)) {
            if (state->left == 0) {
                const std::uint64_t before = state->turn++ == 0 ? thing : turns.things - 1;
                if (before > 0) state->stream.skip(before * turns.run);
                state->left = turns.run;
            }
            const std::uint64_t wanted = std::min(bytes - done, state->left);
            const std::uint64_t got = by(state->stream, done, wanted);
            done += got;
            state->left -= got;
            if (got < wanted) break;
            const std::uint64_t behind = turns.things - 1 - thing;
            if (state->left == 0 && state->turn == turns.turns && behind > 0)
                state->stream.skip(behind * turns.run);
        }
        return done;
    };
    return {[=](std::span<char> to) {
                return static_cast<std::size_t>(
                    pass(to.size(), [&](ByteStream& from, std::uint64_t done, std::uint64_t count) {
                        return std::uint64_t{from.read(to.subspan(
                            static_cast<std::size_t>(done), static_cast<std::size_t>(count)))};
                    }));
            },
            [=](std::uint64_t bytes) {
                return pass(bytes, [](ByteStream& from, std::uint64_t, std::uint64_t count) {
                    return from.skip(count);
                });
            }};
}

ByteStream joined(std::size_t count, std::function<ByteStream(std::size_t)> next)
{
    struct State {
        std::optional<ByteStream> now;
        std::size_t number = 0;
    };
    const auto state = std::make_shared<State>();
    // Goes through the streams until so many bytes were passed.
    const auto pass = [=](std::uint64_t bytes, auto&& by) {
        std::uint64_t done = 0;
        while (done < bytes) {
            if (!state->now) {
                if (state->number == count) break;
                state->now = next(state->number++);
            }
            const std::uint64_t got = by(*state->now, done);
            done += got;
            if (done < bytes) state->now.reset();
        }
        return done;
    };
    return {[=](std::span<char> to) {
                return static_cast<std::size_t>(
                    pass(to.size(), [&](ByteStream& now, std::uint64_t done) -> std::uint64_t {
                        return now.read(to.subspan(static_cast<std::size_t>(done)));
                    }));
            },
            [=](std::uint64_t bytes) {
                return pass(bytes, [&](ByteStream& now, std::uint64_t done) {
                    return now.skip(bytes - done);
                });
            }};
}

} // namespace trivar
