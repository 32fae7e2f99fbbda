// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/campaign_child.h"

#include "core/base/rejected.h"
#include "core/base/text.h"
#include "tests/fuzz/peak_memory.h"
#include "tests/fuzz/sentence.h"
#include "tests/support/fixtures.h"

#include <algorithm>
#include <csignal>
#include <ctime>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace trivar::testing {
namespace {

namespace fs = std::filesystem;

double processor_seconds()
{
    timespec now{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void try_case(const Campaign& campaign, const std::string& path, CaseResult& result)
{
    try {
        campaign.use(path);
    } catch (const Rejected& rejected) {
        result.what = rejected.what();
        const std::string flaw = flaw_of_sentence(result.what);
        result.end = flaw.empty() ? CaseEnd::refused : CaseEnd::broken;
        if (!flaw.empty()) result.what = flaw;
    } catch (const Broken& broken) {
        result.end = CaseEnd::broken;
        result.what = broken.what();
    } catch (const std::exception& other) {
        result.end = CaseEnd::broken;
        result.what =
            fmt::format("an exception that is no sentence for the user: {}", other.what());
    }
}

void judge_memory(const CaseLimits& limits, std::size_t file_bytes, CaseResult& result)
{
    result.memory_bytes = peak_memory().value_or(0);
    const std::size_t most =
        std::max(limits.memory_bytes, limits.memory_by_file_bytes * file_bytes);
    if (result.memory_bytes <= most || failed(result)) return;
    result.end = CaseEnd::too_large;
    result.what = fmt::format("{} MB of memory, by a file of {} bytes", result.memory_bytes >> 20,
                              file_bytes);
}

// The undefined-behaviour sanitizer reports and goes on.
void judge_reports(const CaseFolder& folder, CaseResult& result)
{
    std::error_code none;
    if (!TRIVAR_SANITIZED || fs::file_size(folder.said(), none) == 0 || none) return;
    const std::string said = read_text_file(folder.said().string());
    const std::size_t at = said.find("runtime error: ");
    if (at == said.npos || failed(result)) return;
    result.end = CaseEnd::broken;
    result.what = said.substr(at, said.find('\n', at) - at);
}

void limit(__rlimit_resource resource, rlim_t most)
{
    const rlimit both{most, most};
    ::setrlimit(resource, &both);
}

// So that a case can neither fill the machine nor outlive who watches it.
void confine(const CaseFolder& folder)
{
    ::setpgid(0, 0);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_FSIZE, rlim_t{1} << 30);
    if (!TRIVAR_SANITIZED) limit(RLIMIT_DATA, rlim_t{4} << 30); // they reserve terabytes
    const int said = ::open(folder.said().c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_APPEND, 0644);
    ::dup2(said, STDOUT_FILENO);
    ::dup2(said, STDERR_FILENO);
}

void say(int report, const std::string& line)
{
    if (::write(report, line.data(), line.size()) != static_cast<ssize_t>(line.size())) ::_exit(3);
}

} // namespace

CaseResult run_case(const Campaign& campaign, const CampaignOptions& options, int number,
                    const CaseFolder& folder)
{
    CaseResult result{.number = number};
    const FileSet files = campaign.damaged(options.seed, number);
    fs::remove_all(folder.files());
    std::size_t bytes = 0;
    for (const NamedFile& file : files) {
        write_file(folder.files() / file.name, file.bytes);
        bytes += file.bytes.size();
    }
    forget_peak_memory();
    const double begin_s = processor_seconds();
    try_case(campaign, (folder.files() / files.front().name).string(), result);
    result.processor_s = processor_seconds() - begin_s;
    judge_memory(options.limits, bytes, result);
    judge_reports(folder, result);
    return result;
}

void run_cases(const CampaignEntry& entry, const CampaignOptions& options, int first,
               const CaseFolder& folder, int report)
{
    confine(folder);
    const Campaign campaign = entry.make();
    for (int number = first; number < options.first + options.count; ++number) {
        if (::truncate(folder.said().c_str(), 0) != 0) ::_exit(3);
        say(report, begin_line(number));
        const CaseResult result = run_case(campaign, options, number, folder);
        if (failed(result)) keep_case(entry, options, result, folder);
        say(report, end_line(result));
    }
    ::_exit(0);
}

void keep_case(const CampaignEntry& entry, const CampaignOptions& options, const CaseResult& result,
               const CaseFolder& folder)
{
    if (options.keep.empty()) return;
    const fs::path kept =
        fs::path(options.keep) / fmt::format("{}-{}-{}", entry.damage, entry.kind, result.number);
    fs::create_directories(kept);
    constexpr auto over = fs::copy_options::overwrite_existing;
    std::error_code none; // what cannot be copied is made again by the number
    for (const auto& file : fs::directory_iterator(folder.files(), none))
        if (file.is_regular_file()) fs::copy_file(file, kept / file.path().filename(), over, none);
    fs::copy_file(folder.said(), kept / "said.txt", over, none);
    write_file(kept / "why.txt", fmt::format("{} {} --seed {} --only {}: {}\n", entry.damage,
                                             entry.kind, options.seed, result.number, result.what));
}

} // namespace trivar::testing
