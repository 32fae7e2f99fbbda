// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/every_command.h"
#include "core/document/document_digest.h"
#include "core/document/field.h"
#include "core/scene/log.h"
#include "tests/support/scenes/commands.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

using testing::fitting_commands, testing::fitting_document;

TEST(EveryCommand, HasAFittingExampleHere)
{
    const std::vector<Command> all = every_command(), fitting = fitting_commands();
    ASSERT_EQ(fitting.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i) EXPECT_EQ(verb(fitting[i]), verb(all[i]));
}

TEST(EveryCommand, ComesBackFromItsLineOfJson)
{
    for (const Command& command : fitting_commands()) {
        const std::string line = to_json_line(command);
        EXPECT_EQ(command_from_json_line(line), command) << line;
        EXPECT_EQ(to_json_line(command_from_json_line(line)), line);
    }
}

TEST(EveryCommand, LeavesItsInputUntouched)
{
    const Document before = fitting_document();
    const Document kept = before;
    const std::string digest_before = digest(before);
    for (const Command& command : fitting_commands()) {
        const Document result = after(before, command);
        EXPECT_TRUE(before == kept) << verb(command);
        EXPECT_EQ(digest(before), digest_before) << verb(command);
    }
}

TEST(EveryCommand, GivesTheSameResultWheneverItIsApplied)
{
    for (const Command& command : fitting_commands())
        EXPECT_EQ(digest(after(fitting_document(), command)),
                  digest(after(fitting_document(), command)))
            << verb(command);
}

TEST(EveryCommand, IsUndoneToTheVeryObjectsAndRedoneToTheOthers)
{
    for (const Command& command : fitting_commands()) {
        History history(fitting_document());
        const Document before = history.document();
        history.run(command);
        const Document result = history.document();
        ASSERT_TRUE(history.undo());
        EXPECT_TRUE(history.document() == before) << verb(command);
        ASSERT_TRUE(history.redo());
        EXPECT_TRUE(history.document() == result) << verb(command);
    }
}

TEST(EveryCommand, ReplaysFromTheLogToTheSameDigest)
{
    const Document start = fitting_document();
    for (const Command& command : fitting_commands()) {
        const Document live = after(start, command);
        const Log log = read_log(log_header() + command_line(command), "log");
        History history(start);
        apply(history, log.lines.front(), log.name);
        EXPECT_EQ(digest(history.document()), digest(live)) << verb(command);
    }
}

TEST(EveryCommand, HasASummaryAndAHelpForEachField)
{
    for (const Command& command : fitting_commands()) {
        visit(
            [](const auto& c) {
                EXPECT_FALSE(c.summary.empty());
                each_field(c, [&](std::string_view name, const auto&, std::string_view help,
                                  Rule = {}) { EXPECT_FALSE(help.empty()) << c.verb << name; });
            },
            command);
    }
}

TEST(EveryCommand, WithRandomFieldsIsAppliedOrRejectedAndNothingElse)
{
    std::mt19937 random(2006);
    const Document start = fitting_document();
    const std::string digest_before = digest(start);
    int applied = 0;
    for (int i = 0; i < 20000; ++i) {
        const Command command = testing::random_command(random);
        try {
            const Document result = after(start, command);
            ++applied;
            // An accepted command can be written and read, and does the same again.
            const Command again = command_from_json_line(to_json_line(command));
            EXPECT_EQ(digest(after(start, again)), digest(result)) << to_json_line(command);
        } catch (const Rejected& error) {
            EXPECT_NE(std::string(error.what()), "");
        }
    }
    EXPECT_EQ(digest(start), digest_before);
    EXPECT_GT(applied, 1000); // the test means something
}

TEST(EveryCommand, AppliedAtRandomNeverBreaksWhatTheDocumentPromises)
{
    std::mt19937 random(7);
    History history(fitting_document());
    for (int i = 0; i < 5000; ++i) {
        try {
            history.run(testing::random_command(random));
        } catch (const Rejected&) {
            continue;
        }
        const Document& document = history.document();
        for (const auto& [id, ref] : document.objects) {
            ASSERT_GT(id, 0);
            ASSERT_LT(id, document.next_id);
            ASSERT_NO_THROW(visible(document, id)); // parents exist and end
            ASSERT_TRUE(ref->parent == 0 || document.objects.contains(ref->parent));
            if (!ref->stroke) continue;
            for (const Id lower : ref->stroke->onto) {
                ASSERT_NE(lower, id);
                ASSERT_TRUE(document.objects.contains(lower));
            }
        }
    }
    History again(fitting_document());
    const Log log = read_log(log_text(history), "log");
    for (const LogLine& line : log.lines) apply(again, line, log.name);
    EXPECT_EQ(digest(again.document()), digest(history.document()));
}

} // namespace
} // namespace trivar
