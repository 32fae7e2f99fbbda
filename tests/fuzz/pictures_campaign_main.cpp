// SPDX-License-Identifier: GPL-3.0-or-later
// manual_damaged_pictures [COUNT [SEED [EXTENSION...]]]: reads damaged pictures of every kind, in a
// process that may crash or hang, and counts what becomes of them.
#include "tests/fuzz/pictures_campaign.h"
#include "tests/fuzz/sound_pictures.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fmt/format.h>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <poll.h>
#include <stdexcept>
#include <string>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace trivar::testing {
namespace {

constexpr int hang_ms = 30000; // on a busy machine; the longest of all is told as well
// Under sanitizers, which hold more than the program does, memory is not judged.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr long usual_kib = std::numeric_limits<long>::max();
#else
constexpr long usual_kib = 512 * 1024;
#endif

struct Case { // what goes through the pipe
    int number = 0;
    enum class End : int { begun, read, refused, broken } end = End::begun;
    long memory_kib = 0;
    double seconds = 0;
    std::array<char, 200> words{};
};

double now_s()
{
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

// The most that a process held since the last time.
long peak_kib_of(const std::string& process)
{
    std::ifstream status("/proc/" + process + "/status");
    long peak = 0;
    for (std::string word; status >> word;)
        if (word == "VmHWM:") status >> peak;
    std::ofstream("/proc/" + process + "/clear_refs") << "5";
    return peak;
}

// Returns the peak of this process and of those it started, together; of ended ones, the greatest.
long peak_kib()
{
    rusage used{};
    ::getrusage(RUSAGE_CHILDREN, &used);
    long children = 0;
    std::ifstream list(fmt::format("/proc/self/task/{}/children", ::getpid()));
    for (std::string child; list >> child;) children += peak_kib_of(child);
    return peak_kib_of("self") + std::max(children, used.ru_maxrss);
}

void run(const PicturesCampaign& campaign, std::uint64_t seed, int first, int end, int report)
{
    PictureReader reader;
    for (int number = first; number < end; ++number) {
        Case one{number};
        if (::write(report, &one, sizeof(one)) < 0) return;
        const DamagedPicture picture = campaign.damaged(seed, number);
        const double before_s = now_s();
        std::string words;
        try {
            words = use_picture(picture, reader);
            one.end = words.empty() ? Case::End::read : Case::End::refused;
        } catch (const std::exception& error) {
            one.end = Case::End::broken;
            words = error.what();
        }
        one.seconds = now_s() - before_s;
        one.memory_kib = std::max<long>(0, peak_kib());
        words.copy(one.words.data(), one.words.size() - 1);
        if (::write(report, &one, sizeof(one)) < 0) return;
    }
}

struct Counts {
    int read = 0, refused = 0, broken = 0, crashed = 0, hung = 0, too_large = 0;
    long memory_kib = 0;
    double seconds = 0;
    std::map<std::string, int> sentences; // without their numbers
};

void count(Counts& counts, const Case& one, const PicturesCampaign& campaign, std::uint64_t seed)
{
    const std::string words = one.words.data();
    counts.read += one.end == Case::End::read ? 1 : 0;
    counts.refused += one.end == Case::End::refused ? 1 : 0;
    counts.broken += one.end == Case::End::broken ? 1 : 0;
    counts.memory_kib = std::max(counts.memory_kib, one.memory_kib);
    counts.seconds = std::max(counts.seconds, one.seconds);
    const auto bytes = static_cast<long>(campaign.damaged(seed, one.number).bytes.size());
    if (one.memory_kib > std::max(usual_kib, 64 * bytes / 1024)) {
        ++counts.too_large;
        std::cout << fmt::format("  {}: {} MiB\n", one.number, one.memory_kib / 1024);
    }
    if (one.end == Case::End::broken) std::cout << fmt::format("  {}: {}\n", one.number, words);
    std::string kind;
    for (const char c : words)
        if (kind.empty() || kind.back() != '#' || c < '0' || c > '9')
            kind += c >= '0' && c <= '9' ? '#' : c;
    if (one.end == Case::End::refused) ++counts.sentences[kind];
}

Counts counts_of(const PicturesCampaign& campaign, std::uint64_t seed, int end)
{
    Counts counts;
    for (int next = 0; next < end;) {
        std::array<int, 2> ends{};
        if (::pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
        const pid_t id = ::fork();
        if (id == 0) {
            ::close(ends[0]);
            run(campaign, seed, next, end, ends[1]);
            ::_exit(0);
        }
        ::close(ends[1]);
        Case one;
        bool hangs = false, open = true;
        while (open) {
            pollfd line{ends[0], POLLIN, 0};
            hangs = ::poll(&line, 1, hang_ms) == 0;
            open = !hangs && ::read(ends[0], &one, sizeof(one)) == sizeof(one);
            if (open && one.end != Case::End::begun) count(counts, one, campaign, seed);
            next = one.number + 1;
        }
        ::close(ends[0]);
        if (hangs) ::kill(id, SIGKILL);
        int status = 0;
        ::waitpid(id, &status, 0);
        if (hangs || !WIFEXITED(status) || WEXITSTATUS(status) != 0) {
            ++(hangs ? counts.hung : counts.crashed);
            std::cout << fmt::format("  {}: {}\n", one.number,
                                     hangs ? "hangs" : fmt::format("ends with {}", status));
        }
    }
    return counts;
}

} // namespace
} // namespace trivar::testing

int main(int argc, char** argv)
{
    using namespace trivar::testing;
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    const int count = arguments.empty() ? 1000 : std::stoi(arguments[0]);
    const std::uint64_t seed = arguments.size() > 1 ? std::stoull(arguments[1]) : 1;
    std::vector<std::string> kinds = picture_extensions();
    if (arguments.size() > 2) kinds.assign(arguments.begin() + 2, arguments.end());
    bool failed = false;
    for (const std::string& kind : kinds) {
        const PicturesCampaign campaign(kind);
        const Counts c = counts_of(campaign, seed, count);
        std::cout << fmt::format("{:5} {} read, {} refused, {} broken, {} crashed, {} hung, {} too "
                                 "large; at most {} MiB, {:.2f} s\n",
                                 kind, c.read, c.refused, c.broken, c.crashed, c.hung, c.too_large,
                                 c.memory_kib / 1024, c.seconds);
        if (std::getenv("TRIVAR_SENTENCES"))
            for (const auto& [sentence, times] : c.sentences)
                std::cout << fmt::format("  {:6} {}\n", times, sentence);
        failed = failed || c.broken + c.crashed + c.hung + c.too_large > 0;
        std::cout.flush();
    }
    return failed ? 1 : 0;
}
