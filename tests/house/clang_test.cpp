// SPDX-License-Identifier: GPL-3.0-or-later
// The fuzzers are built by clang 14, which does not compile some algorithms of g++'s library.
#include "core/base/text.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <string>

namespace trivar::testing {
namespace {

TEST(Clang, FindsNoRangeAlgorithmThatReturnsASubrangeToItsEnd)
{
    const std::filesystem::path house = TRIVAR_SOURCE_DIR;
    for (const char* room : {"core", "gpu", "ui", "editor"})
        for (const auto& file : std::filesystem::recursive_directory_iterator(house / room)) {
            if (file.path().extension() != ".cpp" && file.path().extension() != ".h") continue;
            const std::string text = read_text_file(file.path().string());
            for (const char* name : {"unique", "partition", "stable_partition", "rotate", "remove",
                                     "remove_if", "shift_left", "shift_right"})
                EXPECT_EQ(text.find(std::string("ranges::") + name + "("), text.npos)
                    << file.path() << ": use std::" << name;
        }
}

} // namespace
} // namespace trivar::testing
