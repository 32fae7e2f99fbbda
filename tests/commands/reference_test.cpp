// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/commands/command.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace trivar {
namespace {

TEST(Reference, InDocsIsTheOneThatTheProgramWrites)
{
    EXPECT_EQ(read_text_file(TRIVAR_SOURCE_DIR "/docs/commands.md"), commands_markdown())
        << "write it anew: build/trivar commands --markdown > docs/commands.md";
}

TEST(Reference, AsJsonHoldsEveryCommand)
{
    const nlohmann::json all = nlohmann::json::parse(commands_json());
    EXPECT_EQ(all.size(), CommandKinds::count);
    for (const auto& command : all) {
        EXPECT_TRUE(command.at("do").is_string());
        EXPECT_FALSE(command.at("fields").empty());
    }
}

} // namespace
} // namespace trivar
