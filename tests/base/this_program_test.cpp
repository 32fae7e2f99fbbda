// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/this_program.h"

#include "tests/support/fixtures.h"

#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;

TEST(ThisProgram, IsTheFileThatRuns)
{
    EXPECT_EQ(this_program().filename(), "base_test");
}

TEST(ThisProgram, HasItsPartsBesideItOrWhereTheyAreInstalled)
{
    const TemporaryFolder folder;
    const std::filesystem::path program = folder.path() / "bin" / "trivar";
    EXPECT_EQ(part_of(program, "part"), "");
    write_file(folder.path() / "lib" / "trivar" / "part", "");
    EXPECT_EQ(part_of(program, "part"), folder.path() / "lib" / "trivar" / "part");
    write_file(folder.path() / "bin" / "part", "");
    EXPECT_EQ(part_of(program, "part"), folder.path() / "bin" / "part");
}

} // namespace
} // namespace trivar
