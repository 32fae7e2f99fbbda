// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/pictures/decoder_process.h"

#include "core/base/rejected.h"
#include "core/base/this_program.h"
#include "core/files/pictures/decoder_protocol.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace trivar {
namespace {

// Time for starting the helper: its libraries may come from a slow disk.
constexpr int start_ms = 60000;
// Time without any byte read or written, after which the helper counts as hung. A busy helper is
// stopped by the system when it has used its processor time, which other programs may stretch.
constexpr int silent_ms_a_cpu_s = 3000;

struct HelperEnd { // the helper exited, or it is hung
    bool silent = false;
};

template <class Struct> std::string_view message_bytes(const Struct& value)
{
    return {reinterpret_cast<const char*>(&value), sizeof(value)};
}

template <class Struct> Struct message_of(const std::string& bytes)
{
    Struct value;
    std::memcpy(&value, bytes.data(), sizeof(value));
    return value;
}

pid_t started(const std::string& program, int line)
{
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    for (const int end : {STDIN_FILENO, STDOUT_FILENO})
        posix_spawn_file_actions_adddup2(&actions, line, end);
    // Messages of its libraries about damaged pictures are discarded.
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
    // In its own process group the helper does not get Ctrl C: it exits at the end of its input.
    posix_spawnattr_t how;
    posix_spawnattr_init(&how);
    posix_spawnattr_setflags(&how, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&how, 0);
    std::string name = program;
    const std::array<char*, 2> arguments{name.data(), nullptr};
    pid_t id = -1;
    const int error =
        ::posix_spawn(&id, program.c_str(), &actions, &how, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    posix_spawnattr_destroy(&how);
    if (error != 0)
        throw Rejected(fmt::format("{} cannot be started ({})", program, std::strerror(error)));
    return id;
}

} // namespace

DecoderProcess::DecoderProcess()
{
    constexpr const char* file = "trivar-picture";
    const std::string program = part_of(this_program(), file).string();
    if (program.empty())
        throw Rejected(fmt::format("cannot be read: {}, a part of Trivar, is neither beside the "
                                   "program nor in lib/trivar; install Trivar again",
                                   file));
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
        throw Rejected(fmt::format("cannot be read ({})", std::strerror(errno)));
    line_ = ends[0];
    try {
        id_ = started(program, ends[1]);
        ::close(ends[1]);
    } catch (const Rejected&) {
        ::close(ends[1]);
        ::close(std::exchange(line_, -1));
        throw;
    }
    try {
        received(sizeof(DecoderAnswer), start_ms); // the helper is ready
    } catch (const HelperEnd&) {
        end();
        throw Rejected(
            fmt::format("cannot be read: {} does not start; install Trivar again", program));
    }
}

DecoderProcess::~DecoderProcess()
{
    end();
}

int DecoderProcess::end()
{
    int status = 0;
    if (id_ < 0) return status;
    ::close(std::exchange(line_, -1));
    ::kill(id_, SIGKILL); // no effect on the status of one that has exited
    while (::waitpid(id_, &status, 0) < 0 && errno == EINTR) continue;
    id_ = -1;
    return status;
}

bool DecoderProcess::waited(short event, int wait_ms)
{
    pollfd line{line_, event, 0};
    int ready = 0;
    do ready = ::poll(&line, 1, wait_ms);
    while (ready < 0 && errno == EINTR);
    return ready > 0;
}

void DecoderProcess::send(std::string_view bytes, int wait_ms)
{
    while (!bytes.empty()) {
        if (!waited(POLLOUT, wait_ms)) throw HelperEnd{true};
        const ssize_t count =
            ::send(line_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
        if (count < 0 && errno != EINTR && errno != EAGAIN) throw HelperEnd{};
        if (count > 0) bytes.remove_prefix(static_cast<std::size_t>(count));
    }
}

std::string DecoderProcess::received(std::uint64_t bytes, int wait_ms)
{
    std::string out(bytes, '\0');
    for (std::size_t have = 0; have < out.size();) {
        if (!waited(POLLIN, wait_ms)) throw HelperEnd{true};
        const ssize_t count = ::recv(line_, out.data() + have, out.size() - have, MSG_DONTWAIT);
        if (count == 0 || (count < 0 && errno != EINTR && errno != EAGAIN)) throw HelperEnd{};
        if (count > 0) have += static_cast<std::size_t>(count);
    }
    return out;
}

void DecoderProcess::fail(bool silent, const DecoderLimits& limits)
{
    const int status = end();
    if (silent || (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU))
        throw Rejected(fmt::format(
            "takes more than {} s to decode, so it is damaged or meant to do harm", limits.cpu_s));
    if (WIFEXITED(status) && WEXITSTATUS(status) == no_memory_status)
        throw Rejected(
            fmt::format("takes more than {} MB to decode, so it is damaged or meant to do harm",
                        limits.memory_bytes >> 20));
    throw Rejected("is damaged: its decoder fails");
}

DecodeResult DecoderProcess::decode(const DecodeTask& task, const DecoderLimits& limits,
                                    const TakeRows& take)
try {
    const int wait_ms = static_cast<int>(limits.cpu_s) * silent_ms_a_cpu_s;
    std::string words = task.format + '\0';
    for (const std::string& tag : task.tags) words += tag + '\0';
    DecoderOrder order;
    order.file_bytes = task.bytes.size();
    order.word_bytes = words.size();
    order.memory_bytes = limits.memory_bytes;
    order.width_px = task.size_px.x;
    order.height_px = task.size_px.y;
    order.cpu_s = limits.cpu_s;
    order.numbers = task.numbers ? 1 : 0;
    send(message_bytes(order), wait_ms);
    send(words, wait_ms);
    send(task.bytes, wait_ms);
    const std::uint64_t most =
        (std::uint64_t{1} << 20) + 4 * static_cast<std::uint64_t>(order.width_px) *
                                       static_cast<std::uint64_t>(order.height_px);
    while (true) {
        const auto answer = message_of<DecoderAnswer>(received(sizeof(DecoderAnswer), wait_ms));
        if (answer.bytes > most) throw HelperEnd{}; // the helper is corrupted
        const std::string bytes = received(answer.bytes, wait_ms);
        if (answer.what == DecoderAnswer::What::rows) {
            take({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
            continue;
        }
        DecodeResult decoded{answer.what == DecoderAnswer::What::whole, answer.bits, {}};
        for (std::size_t at = 0; at < bytes.size();) {
            const std::string tag = bytes.c_str() + at;
            const std::string text = bytes.c_str() + std::min(bytes.size(), at + tag.size() + 1);
            at += tag.size() + text.size() + 2;
            decoded.tags.emplace_back(tag, text);
        }
        return decoded;
    }
} catch (const HelperEnd& ended) {
    fail(ended.silent, limits);
} catch (...) { // of `take`: more rows may follow, so the helper is stopped
    end();
    throw;
}

} // namespace trivar
