// SPDX-License-Identifier: GPL-3.0-or-later
// A comment says at once what it is about: its first sentence has a noun and a verb, and does not
// begin in the middle of a thought.
#include "core/base/text.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <gtest/gtest.h>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace trivar::testing {
namespace {

const std::set<std::string> riddles{"What", "Of", "By", "From", "As", "Those"};
// These may begin a sentence within a function, and leave open what a declaration is.
const std::set<std::string> riddles_in_headers{"At", "To", "For", "Where"};

// Returns the place of the slashes if a line is only a comment.
std::size_t comment_at(const std::string& line)
{
    const std::size_t at = line.find_first_not_of(' ');
    return at != line.npos && line.compare(at, 2, "//") == 0 ? at : line.npos;
}

// Returns the lines, from 1, at which blocks of comments begin with a riddle. A line that goes on
// with the comment behind a statement, below it, begins no block.
std::vector<int> riddles_in(const std::string& text, bool header)
{
    std::vector<int> out;
    std::istringstream lines(text);
    std::string line, before;
    for (int number = 1; std::getline(lines, line); before = line, ++number) {
        const std::size_t at = comment_at(line);
        if (at == line.npos || comment_at(before) != before.npos) continue;
        if (at > 0 && before.find("//") == at) continue;
        const std::size_t first = line.find_first_not_of("/ ", at);
        if (first == line.npos) continue;
        std::string word = line.substr(first, line.find_first_of(" .,:;", first) - first);
        word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
        if (riddles.contains(word) || line.compare(first, 7, "All but") == 0 ||
            (header && riddles_in_headers.contains(word)))
            out.push_back(number);
    }
    return out;
}

TEST(Comments, BeginWithASubject)
{
    const std::filesystem::path house = TRIVAR_SOURCE_DIR;
    std::size_t files = 0;
    for (const char* room : {"core", "gpu", "ui", "editor", "assets/make", "tests"})
        for (const auto& entry : std::filesystem::recursive_directory_iterator(house / room)) {
            const std::string kind = entry.path().extension().string();
            if (kind != ".h" && kind != ".cpp" && kind != ".glsl") continue;
            ++files;
            const std::string path =
                std::filesystem::relative(entry.path(), house).generic_string();
            for (const int line : riddles_in(read_text_file(entry.path().string()), kind == ".h"))
                ADD_FAILURE() << path << ":" << line
                              << " begins with a word that is no subject: say what a thing is, or "
                                 "what a function does or returns";
        }
    EXPECT_GT(files, 2000u) << "the house was not found";
}

TEST(Comments, ThatBeginInTheMiddleOfAThoughtAreNoticed)
{
    EXPECT_EQ(riddles_in("// What it gives.\nint a;\n", false), std::vector{1});
    EXPECT_EQ(riddles_in("struct A {\n    // of the mesh\n    int a;\n};\n", true), std::vector{2});
    EXPECT_EQ(riddles_in("// All but the last.\n", false), std::vector{1});
    EXPECT_EQ(riddles_in("// Where a sample is.\n", true), std::vector{1});
}

TEST(Comments, MayBeginWithOtherWords)
{
    EXPECT_TRUE(riddles_in("// Returns what it gives.\n// Of two the first.\n", true).empty());
    EXPECT_TRUE(riddles_in("// Where slopes jump, one side counts.\n", false).empty());
    EXPECT_TRUE(riddles_in("// Often nothing. Whatever.\n", true).empty());
    EXPECT_TRUE(riddles_in("    int a; // sides\n           // of the box\n", true).empty());
}

} // namespace
} // namespace trivar::testing
