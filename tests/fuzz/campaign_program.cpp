// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/campaign_program.h"

#include "core/base/text.h"
#include "tests/fuzz/campaign_child.h"
#include "tests/fuzz/campaign_run.h"
#include "tests/fuzz/shortened.h"
#include "tests/support/fixtures.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fmt/ranges.h>
#include <optional>
#include <sstream>

namespace trivar::testing {
namespace {

constexpr std::size_t most_told = 20; // of a campaign's failures

struct Arguments {
    std::string damage, kind;
    CampaignOptions run;
    int only = -1;
    bool shorten = false;
    std::string again;
};

void add_options(CLI::App& app, Arguments& out)
{
    app.add_option("damage", out.damage, "name of a campaign; all without it");
    app.add_option("--kind", out.kind, "of file: obj, ply-text, glb ...; all without it");
    app.add_option("--count", out.run.count, "number of cases of each kind")->capture_default_str();
    app.add_option("--first", out.run.first, "number of the first case")->capture_default_str();
    app.add_option("--seed", out.run.seed, "what all numbers follow from")->capture_default_str();
    app.add_option("--keep", out.run.keep, "a folder for the files of cases that fail");
    app.add_option("--only", out.only, "this case alone, in this process and without limits");
    app.add_flag("--shorten", out.shorten,
                 "with --only: leaves lines out of the case's file while it still fails");
    app.add_option("--again", out.again,
                   "a file that a case was kept in, used in this process; with --kind");
}

// Prints the result; whether the case did not fail.
bool told(const CampaignEntry& entry, const CaseFolder& folder, const CaseResult& result)
{
    fmt::print("{} {}, case {}: {} MB, {:.2f} s, {}\n{}\n", entry.damage, entry.kind, result.number,
               result.memory_bytes >> 20, result.processor_s,
               failed(result)                    ? "FAILED"
               : result.end == CaseEnd::accepted ? "accepted"
                                                 : "refused",
               result.what);
    fmt::print("its files: {}\n", folder.files().string());
    return !failed(result);
}

// The files that stand beside a kept one, which is the first.
FileSet files_kept(const std::string& path)
{
    const std::filesystem::path first(path);
    FileSet out{{first.filename().string(), read_text_file(path)}};
    for (const auto& each : std::filesystem::directory_iterator(first.parent_path()))
        if (each.is_regular_file() && each.path().filename() != first.filename())
            out.push_back({each.path().filename().string(), read_text_file(each.path().string())});
    return out;
}

bool run_only(const CampaignEntry& entry, const Arguments& arguments)
{
    const CaseFolder folder{std::filesystem::temp_directory_path() / "trivar-campaign-only"};
    std::filesystem::create_directories(folder.path);
    Campaign campaign = entry.make();
    if (!arguments.again.empty())
        campaign.damaged = [&](std::uint64_t, int) { return files_kept(arguments.again); };
    return told(entry, folder, run_case(campaign, arguments.run, arguments.only, folder));
}

// The case of that number with other lines in its file, in a process that may die. Without lines
// it is as it is, and its file is written to `all`.
Tally tally_of_lines(const CampaignEntry& entry, const Arguments& arguments,
                     const std::optional<std::vector<std::string>>& lines, const std::string& all)
{
    CampaignOptions options = arguments.run;
    options.first = arguments.only;
    options.count = 1;
    const std::string& again = arguments.again;
    CampaignEntry altered = entry;
    altered.make = [&] {
        Campaign campaign = entry.make();
        campaign.damaged = [&, damaged = campaign.damaged](std::uint64_t seed, int number) {
            FileSet files = again.empty() ? damaged(seed, number) : files_kept(again);
            std::string& text = files.front().bytes;
            if (!lines) write_file(all, text);
            if (lines) text = fmt::format("{}\n", fmt::join(*lines, "\n"));
            return files;
        };
        return campaign;
    };
    return run_campaign(altered, options);
}

// A failure without what it says of the case.
std::string kind_of(const CaseResult& failure)
{
    return fmt::format("{} {}", static_cast<int>(failure.end),
                       failure.what.substr(0, failure.what.find(", after")));
}

std::vector<std::string> lines_of(const std::string& text)
{
    std::vector<std::string> out;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) out.push_back(line);
    return out;
}

// Prints the case with as few lines as fail in the same way.
bool run_shortened(const CampaignEntry& entry, const Arguments& arguments)
{
    const TemporaryFolder folder;
    const std::string file = folder.file("all");
    const Tally whole = tally_of_lines(entry, arguments, {}, file);
    if (whole.failures.empty()) {
        fmt::print("{} {}, case {} does not fail\n", entry.damage, entry.kind, arguments.only);
        return true;
    }
    const std::string failure = kind_of(whole.failures.front());
    const auto fails = [&](const std::vector<std::string>& lines) {
        const Tally tally = tally_of_lines(entry, arguments, lines, file);
        return !tally.failures.empty() && kind_of(tally.failures.front()) == failure;
    };
    for (const std::string& line : shortened(lines_of(read_text_file(file)), fails))
        fmt::print("{}\n", line);
    fmt::print(stderr, "{}\n", whole.failures.front().what);
    return false;
}

bool run_all(const CampaignEntry& entry, const CampaignOptions& options)
{
    const Tally tally = run_campaign(entry, options);
    fmt::print("{}\n", summary(entry, tally));
    for (std::size_t i = 0; i < std::min(most_told, tally.failures.size()); ++i)
        fmt::print("  case {}, seed {}: {}\n", tally.failures[i].number, options.seed,
                   tally.failures[i].what);
    if (tally.failures.size() > most_told)
        fmt::print("  and {} more\n", tally.failures.size() - most_told);
    std::fflush(stdout);
    return tally.failures.empty();
}

int run(const Arguments& arguments, const std::vector<CampaignEntry>& entries)
{
    bool sound = true, any = false;
    for (const CampaignEntry& entry : entries) {
        if (!arguments.damage.empty() && entry.damage != arguments.damage) continue;
        if (!arguments.kind.empty() && entry.kind != arguments.kind) continue;
        any = true;
        Arguments own = arguments;
        own.run.limits = entry.limits;
        const bool alone = own.only >= 0 || !own.again.empty();
        const bool good = !alone        ? run_all(entry, own.run)
                          : own.shorten ? run_shortened(entry, own)
                                        : run_only(entry, own);
        sound = sound && good;
    }
    if (!any) fmt::print(stderr, "there is no such campaign\n");
    return sound && any ? 0 : 1;
}

} // namespace

int campaign_program(CLI::App& app, int count, char** words,
                     const std::function<std::vector<CampaignEntry>()>& entries)
{
    // Each case writes a dozen files: in memory, where there is such a folder, and no disk waits.
    if (std::filesystem::is_directory("/dev/shm")) ::setenv("TMPDIR", "/dev/shm", 0);
    try {
        Arguments arguments;
        add_options(app, arguments);
        app.parse(count, words);
        return run(arguments, entries());
    } catch (const CLI::ParseError& error) {
        return app.exit(error);
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}

} // namespace trivar::testing
