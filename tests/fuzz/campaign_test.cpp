// SPDX-License-Identifier: GPL-3.0-or-later
// What watches the cases: each kind of failure is met once, planted, and told by its number.
#include "core/base/rejected.h"
#include "tests/fuzz/byte_damage.h"
#include "tests/fuzz/campaign_run.h"
#include "tests/fuzz/campaigns.h"
#include "tests/fuzz/json_damage.h"
#include "tests/fuzz/log_damage.h"
#include "tests/fuzz/log_use.h"
#include "tests/fuzz/model_use.h"
#include "tests/fuzz/shortened.h"
#include "tests/fuzz/sound_files.h"
#include "tests/fuzz/sound_logs.h"
#include "tests/support/fixtures.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>

namespace trivar::testing {
namespace {

using ::testing::HasSubstr;

// The number of the case is the content of its file.
CampaignEntry planted(const std::function<void(int)>& use)
{
    return {"planted", "kind", [use] {
                return Campaign{[](std::uint64_t, int number) {
                                    return FileSet{{"file", std::to_string(number)}};
                                },
                                [use](const std::string& path) {
                                    int number = 0;
                                    std::ifstream(path) >> number;
                                    use(number);
                                }};
            }};
}

Tally tally_of(const std::function<void(int)>& use, CampaignOptions options = {})
{
    options.count = 8;
    return run_campaign(planted(use), options);
}

TEST(Campaign, CountsWhatIsAcceptedAndWhatIsRefused)
{
    const Tally tally = tally_of([](int number) {
        if (number % 2 == 1) throw Rejected("file: it is odd");
    });
    EXPECT_EQ(tally.cases, 8);
    EXPECT_EQ(tally.accepted, 4);
    EXPECT_TRUE(tally.failures.empty());
}

TEST(Campaign, GoesOnAfterACrashAndTellsWhichCaseItWas)
{
    const Tally tally = tally_of([](int number) {
        if (number == 2 || number == 7) std::_Exit(5);
    });
    EXPECT_EQ(tally.cases, 8);
    EXPECT_EQ(tally.accepted, 6);
    ASSERT_EQ(tally.ended(CaseEnd::crash), 2);
    EXPECT_EQ(tally.failures[0].number, 2);
    EXPECT_EQ(tally.failures[1].number, 7);
    EXPECT_THAT(tally.failures[1].what, HasSubstr("status 5"));
}

TEST(Campaign, EndsACaseThatHangsBusyOrAsleep)
{
    CampaignOptions options;
    options.limits.processor_s = 0.05;
    options.limits.wall_s = 4;
    const Tally tally = tally_of(
        [](int number) {
            volatile bool for_ever = true;
            while (number == 3 && for_ever) {
            }
            while (number == 5) std::this_thread::sleep_for(std::chrono::seconds(1));
        },
        options);
    EXPECT_EQ(tally.accepted, 6);
    EXPECT_EQ(tally.ended(CaseEnd::hang), 2);
}

TEST(Campaign, TellsExceptionsThatAreNoSentencesAndSentencesThatAreNone)
{
    const Tally tally = tally_of([](int number) {
        if (number == 1) throw std::bad_alloc();
        if (number == 2) throw Rejected("");
        if (number == 3) throw Rejected("two\nlines");
        if (number == 4) throw Rejected("\xff");
        if (number == 5) throw Rejected(std::string(401, 'a'));
        if (number == 6) throw Broken("a promise");
    });
    EXPECT_EQ(tally.accepted, 2);
    EXPECT_EQ(tally.ended(CaseEnd::broken), 6);
}

TEST(Campaign, TellsACaseThatTakesTooMuchMemory)
{
    if (TRIVAR_SANITIZED) GTEST_SKIP() << "sanitizers hold a multiple of it";
    const Tally tally = tally_of([](int number) {
        if (number == 4) std::vector<char>(std::size_t{600} << 20, 'a');
    });
    ASSERT_EQ(tally.failures.size(), 1u);
    EXPECT_EQ(tally.failures[0].end, CaseEnd::too_large);
    EXPECT_EQ(tally.failures[0].number, 4);
}

TEST(Campaign, KeepsTheFilesOfCasesThatFail)
{
    const TemporaryFolder folder;
    CampaignOptions options;
    options.keep = folder.file("kept");
    tally_of(
        [](int number) {
            if (number == 1) throw Broken("a promise");
            if (number == 6) std::abort();
        },
        options);
    EXPECT_TRUE(std::filesystem::exists(folder.file("kept/planted-kind-1/file")));
    EXPECT_TRUE(std::filesystem::exists(folder.file("kept/planted-kind-6/file")));
    EXPECT_TRUE(std::filesystem::exists(folder.file("kept/planted-kind-6/why.txt")));
    EXPECT_FALSE(std::filesystem::exists(folder.file("kept/planted-kind-2")));
}

TEST(Shortened, LeavesTheLinesThatFailTogether)
{
    std::vector<std::string> lines;
    for (int i = 0; i < 40; ++i) lines.push_back(std::to_string(i));
    int tries = 0;
    const auto fails = [&](const std::vector<std::string>& some) {
        ++tries;
        return std::ranges::count(some, "7") > 0 && std::ranges::count(some, "31") > 0;
    };
    EXPECT_THAT(shortened(lines, fails), ::testing::ElementsAre("7", "31"));
    EXPECT_LT(tries, 60);
    EXPECT_THAT(shortened(lines, [](const auto&) { return true; }), ::testing::IsEmpty());
}

TEST(SoundFiles, AreAllAccepted)
{
    const TemporaryFolder folder;
    const auto put = [&](const FileSet& files) {
        std::filesystem::remove_all(folder.path());
        for (const NamedFile& file : files) write_file(folder.path() / file.name, file.bytes);
        return folder.file(files.front().name);
    };
    for (const char* kind : {"obj", "ply", "ply-text", "stl", "stl-text", "off", "gltf", "glb"})
        for (const FileSet& files : sound_files(kind)) use_model(put(files));
    for (const FileSet& files : sound_logs()) use_log(put(files));
}

TEST(Damage, IsTheSameForTheSameSeedAndNumberAndAnotherForOthers)
{
    for (const CampaignEntry& entry : all_campaigns()) {
        const Campaign one = entry.make(), two = entry.make();
        const auto bytes = [](const FileSet& files) {
            std::string all;
            for (const NamedFile& file : files) all += file.name + '\n' + file.bytes;
            return all;
        };
        int different = 0;
        for (int number = 0; number < 10; ++number) {
            EXPECT_EQ(bytes(one.damaged(1, number)), bytes(two.damaged(1, number)));
            different += bytes(one.damaged(1, number)) != bytes(two.damaged(2, number));
        }
        EXPECT_GT(different, 5) << entry.damage << " " << entry.kind;
    }
}

TEST(Damage, IsDoneToWhateverItIsGiven)
{
    for (int number = 0; number < 200; ++number) {
        Dice dice(1, number);
        with_bytes_damaged("", {""}, dice);
        with_bytes_damaged("a", {"b"}, dice);
        with_lines_damaged("", dice);
        for (const char* json : {"", "[]", "{", "7", "{\"a\":[1,{}]}"})
            with_values_replaced(json, dice);
    }
}

} // namespace
} // namespace trivar::testing
