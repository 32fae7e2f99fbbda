// SPDX-License-Identifier: GPL-3.0-or-later
// Damages small sound files in ways that follow from a seed, and uses each as a program would.
#include "core/base/rejected.h"
#include "tests/fuzz/campaign_child.h"
#include "tests/fuzz/campaign_run.h"
#include "tests/fuzz/campaigns.h"

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <filesystem>
#include <fmt/format.h>

namespace trivar::testing {
namespace {

constexpr std::size_t most_told = 20; // of a campaign's failures

struct Arguments {
    std::string damage, kind;
    CampaignOptions run;
    int only = -1;
};

Arguments parsed(CLI::App& app, int count, char** words)
{
    Arguments out;
    app.add_option("damage", out.damage, "bytes, json, pictures or logs; all without it");
    app.add_option("--kind", out.kind, "of file: obj, ply-text, glb ...; all without it");
    app.add_option("--count", out.run.count, "number of cases of each kind")->capture_default_str();
    app.add_option("--first", out.run.first, "number of the first case")->capture_default_str();
    app.add_option("--seed", out.run.seed, "what all numbers follow from")->capture_default_str();
    app.add_option("--keep", out.run.keep, "a folder for the files of cases that fail");
    app.add_option("--only", out.only, "this case alone, in this process and without limits");
    app.parse(count, words);
    return out;
}

bool run_only(const CampaignEntry& entry, const Arguments& arguments)
{
    const CaseFolder folder{std::filesystem::temp_directory_path() / "trivar-campaign-only"};
    std::filesystem::create_directories(folder.path);
    const CaseResult result = run_case(entry.make(), arguments.run, arguments.only, folder);
    fmt::print("{} {}, case {}: {} MB, {:.2f} s, {}\n{}\n", entry.damage, entry.kind, result.number,
               result.memory_bytes >> 20, result.processor_s,
               failed(result)                    ? "FAILED"
               : result.end == CaseEnd::accepted ? "accepted"
                                                 : "refused",
               result.what);
    fmt::print("its files: {}\n", folder.files().string());
    return !failed(result);
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

int run_main(int count, char** words)
{
    CLI::App app("Damages small sound files and uses each as a program would.");
    const Arguments arguments = parsed(app, count, words);
    bool sound = true, any = false;
    for (const CampaignEntry& entry : all_campaigns()) {
        if (!arguments.damage.empty() && entry.damage != arguments.damage) continue;
        if (!arguments.kind.empty() && entry.kind != arguments.kind) continue;
        any = true;
        const bool good =
            arguments.only >= 0 ? run_only(entry, arguments) : run_all(entry, arguments.run);
        sound = sound && good;
    }
    if (!any) fmt::print(stderr, "there is no such campaign\n");
    return sound && any ? 0 : 1;
}

} // namespace
} // namespace trivar::testing

int main(int count, char** words)
{
    // Each case writes a dozen files: in memory, where there is such a folder, and no disk waits.
    if (std::filesystem::is_directory("/dev/shm")) ::setenv("TMPDIR", "/dev/shm", 0);
    try {
        return trivar::testing::run_main(count, words);
    } catch (const CLI::ParseError& error) {
        return CLI::App().exit(error);
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}
