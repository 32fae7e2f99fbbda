// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/campaign_run.h"

#include "tests/fuzz/campaign_child.h"
#include "tests/support/fixtures.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <ctime>
#include <fmt/format.h>
#include <optional>
#include <poll.h>
#include <stdexcept>
#include <sys/wait.h>
#include <unistd.h>

namespace trivar::testing {
namespace {

using Clock = std::chrono::steady_clock;

// A process that runs cases, as the one sees it that watches.
class ChildProcess {
public:
    ChildProcess(const CampaignEntry& entry, const CampaignOptions& options, int first,
                 const CaseFolder& folder)
    {
        int ends[2];
        if (::pipe(ends) != 0) throw std::runtime_error("the system gives no pipe");
        process_ = ::fork();
        if (process_ < 0) throw std::runtime_error("the system gives no process");
        ::setpgid(process_, process_);
        if (process_ == 0) {
            ::close(ends[0]);
            run_cases(entry, options, first, folder, ends[1]);
        }
        ::close(ends[1]);
        report_ = ends[0];
    }
    ~ChildProcess()
    {
        ::close(report_);
        ::kill(-process_, SIGKILL); // those too that it started
        if (!status_) ::waitpid(process_, nullptr, 0);
    }
    ChildProcess(const ChildProcess&) = delete;
    ChildProcess& operator=(const ChildProcess&) = delete;

    // The next line, empty while none has come; nothing at the end of the last.
    std::optional<std::string> line()
    {
        if (const std::size_t end = read_.find('\n'); end != read_.npos) {
            std::string out = read_.substr(0, end);
            read_.erase(0, end + 1);
            return out;
        }
        pollfd ready{report_, POLLIN, 0};
        if (::poll(&ready, 1, 200) <= 0) return std::string();
        char some[4096];
        const ssize_t count = ::read(report_, some, sizeof some);
        if (count <= 0) return std::nullopt;
        read_.append(some, static_cast<std::size_t>(count));
        return std::string();
    }
    double processor_s() const
    {
        clockid_t clock{};
        timespec used{};
        if (::clock_getcpuclockid(process_, &clock) != 0 || ::clock_gettime(clock, &used) != 0)
            return 0;
        return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
    }
    // Waits till it is gone; how it went.
    std::string end()
    {
        status_.emplace();
        ::waitpid(process_, &*status_, 0);
        if (WIFSIGNALED(*status_))
            return fmt::format("it died of signal {} ({})", WTERMSIG(*status_),
                               ::strsignal(WTERMSIG(*status_)));
        return fmt::format("it ended with status {}", WEXITSTATUS(*status_));
    }

private:
    pid_t process_ = -1;
    int report_ = -1;
    std::string read_;
    std::optional<int> status_;
};

struct Watched {
    std::optional<int> number; // of the case that runs
    Clock::time_point begin;
    double begin_processor_s = 0;
};

bool hangs(const Watched& now, const ChildProcess& child, const CaseLimits& limits)
{
    const std::chrono::duration<double> wall = Clock::now() - now.begin;
    return child.processor_s() - now.begin_processor_s > limits.processor_s ||
           wall.count() > limits.wall_s;
}

void add(Tally& tally, const CaseResult& result)
{
    ++tally.cases;
    if (result.end == CaseEnd::accepted) ++tally.accepted;
    if (failed(result)) tally.failures.push_back(result);
    if (result.memory_bytes > tally.largest.memory_bytes) tally.largest = result;
    if (result.processor_s > tally.slowest.processor_s) tally.slowest = result;
}

// Runs one child to its end. Of the case that it does not survive its result; none: all are done.
std::optional<CaseResult> watch(ChildProcess& child, const CaseLimits& limits, Tally& tally)
{
    Watched now{.number = {}, .begin = Clock::now()};
    while (const std::optional<std::string> line = child.line()) {
        if (line->empty()) {
            if (!hangs(now, child, limits)) continue;
            if (!now.number) throw std::runtime_error("the sound files are not made in time");
            return CaseResult{.number = *now.number,
                              .end = CaseEnd::hang,
                              .processor_s = child.processor_s() - now.begin_processor_s,
                              .what = "it was not done in time"};
        }
        const CaseLine said = case_line(*line);
        if (said.ended) add(tally, said.result);
        now.number = said.ended ? std::nullopt : std::optional(said.result.number);
        now.begin = Clock::now();
        now.begin_processor_s = child.processor_s();
    }
    const std::string how = child.end();
    if (now.number) return CaseResult{.number = *now.number, .end = CaseEnd::crash, .what = how};
    if (how != "it ended with status 0")
        throw std::runtime_error("a child process died outside of a case: " + how);
    return std::nullopt;
}

} // namespace

Tally run_campaign(const CampaignEntry& entry, const CampaignOptions& options)
{
    const TemporaryFolder temporary;
    const CaseFolder folder{temporary.path()};
    Tally tally;
    for (int next = options.first; next < options.first + options.count;) {
        ChildProcess child(entry, options, next, folder);
        const std::optional<CaseResult> last = watch(child, options.limits, tally);
        if (!last) break;
        add(tally, *last);
        keep_case(entry, options, *last, folder);
        next = last->number + 1;
    }
    return tally;
}

int Tally::ended(CaseEnd by) const
{
    return static_cast<int>(std::ranges::count(failures, by, &CaseResult::end));
}

std::string summary(const CampaignEntry& entry, const Tally& tally)
{
    const int failures = static_cast<int>(tally.failures.size());
    return fmt::format("{} {}: {} cases, {} accepted, {} refused, {} broken promises, {} crashes, "
                       "{} hangs, {} too large; at most {} MB (case {}) and {:.2f} s (case {})",
                       entry.damage, entry.kind, tally.cases, tally.accepted,
                       tally.cases - tally.accepted - failures, tally.ended(CaseEnd::broken),
                       tally.ended(CaseEnd::crash), tally.ended(CaseEnd::hang),
                       tally.ended(CaseEnd::too_large), tally.largest.memory_bytes >> 20,
                       tally.largest.number, tally.slowest.processor_s, tally.slowest.number);
}

} // namespace trivar::testing
