// SPDX-License-Identifier: GPL-3.0-or-later
// trivar-picture decodes pictures for Trivar, which starts it
// (core/files/pictures/decoder_process.h): it reads orders from its standard input and writes
// pixels to its standard output. Its memory and time are limited, and it may fail in any way.
#include "core/base/rejected.h"
#include "core/files/pictures/codec_plugin.h"
#include "core/files/pictures/decoder_protocol.h"

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <malloc.h>
#include <new>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

namespace trivar {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool has_bound_of_memory = false; // a sanitizer reserves far more than the bound
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool has_bound_of_memory = false;
#else
constexpr bool has_bound_of_memory = true;
#endif
#else
constexpr bool has_bound_of_memory = true;
#endif

void bound(int what, rlim_t most)
{
    rlimit limit{};
    ::getrlimit(static_cast<__rlimit_resource>(what), &limit);
    limit.rlim_cur = std::min(most, limit.rlim_max);
    ::setrlimit(static_cast<__rlimit_resource>(what), &limit);
}

std::uint64_t address_space()
{
    std::uint64_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

rlim_t used_s()
{
    rusage used{};
    ::getrusage(RUSAGE_SELF, &used);
    return static_cast<rlim_t>(used.ru_utime.tv_sec + used.ru_stime.tv_sec);
}

// Reads exactly `count` bytes; false at the end of the input, at which this program exits.
bool read_all(void* to, std::size_t count)
{
    auto* at = static_cast<char*>(to);
    while (count > 0) {
        const ssize_t got = ::read(STDIN_FILENO, at, count);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) return false;
        at += got;
        count -= static_cast<std::size_t>(got);
    }
    return true;
}

void write_all(const void* from, std::size_t count)
{
    const auto* at = static_cast<const char*>(from);
    while (count > 0) {
        const ssize_t put = ::write(STDOUT_FILENO, at, count);
        if (put < 0 && errno == EINTR) continue;
        if (put <= 0) ::_exit(0);
        at += put;
        count -= static_cast<std::size_t>(put);
    }
}

void answer(DecoderAnswer::What what, int bits, const void* bytes, std::size_t count)
{
    const DecoderAnswer head{what, bits, count};
    write_all(&head, sizeof(head));
    write_all(bytes, count);
}

void decode(const Codec& codec, const DecoderOrder& order, const std::string& words,
            std::string_view file)
{
    DecodeTask task{file,
                    words.substr(0, words.find('\0')),
                    {order.width_px, order.height_px},
                    {},
                    order.numbers != 0};
    for (std::size_t at = task.format.size() + 1; at < words.size();) {
        task.tags.emplace_back(words.c_str() + at);
        at += task.tags.back().size() + 1;
    }
    const DecodeResult decoded = codec.decode(task, [](std::span<const std::uint8_t> rows) {
        answer(DecoderAnswer::What::rows, 0, rows.data(), rows.size());
    });
    std::string tags;
    for (const auto& [tag, text] : decoded.tags) tags += tag + '\0' + text + '\0';
    answer(decoded.whole ? DecoderAnswer::What::whole : DecoderAnswer::What::damaged, decoded.bits,
           tags.data(), tags.size());
}

void serve(const Codec& codec)
{
    const std::uint64_t at_start = address_space();
    answer(DecoderAnswer::What::ready, 0, nullptr, 0);
    for (DecoderOrder order; read_all(&order, sizeof(order));) {
        bound(RLIMIT_AS, RLIM_INFINITY);
        std::string words(order.word_bytes, '\0'), file(order.file_bytes, '\0');
        if (!read_all(words.data(), words.size()) || !read_all(file.data(), file.size())) return;
        if (has_bound_of_memory) bound(RLIMIT_AS, at_start + file.size() + order.memory_bytes);
        bound(RLIMIT_CPU, used_s() + order.cpu_s + 1); // rounded up to whole seconds
        decode(codec, order, words, file);
    }
}

} // namespace
} // namespace trivar

int main()
{
    using namespace trivar;
    bound(RLIMIT_CORE, 0);
    mallopt(M_ARENA_MAX, 1); // another arena would count as memory of a picture
    std::set_new_handler([] { ::_exit(no_memory_status); });
    try {
        const Codec& codec = picture_codec();
        codec.keep_to_one_thread();
        serve(codec);
    } catch (const Rejected& error) {
        std::cerr << "trivar-picture: " << error.what() << "\n";
        return 1;
    }
    ::_exit(0); // no clean-up is needed
}
