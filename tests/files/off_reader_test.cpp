// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/files/text_models.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

const std::string off_rest = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n";

TEST(OffReader, NeedsNoNumberOfEdgesAndMindsNoComments)
{
    const Mesh expected = *read_text_model(off_text(square_model()), ".off").meshes[0];
    for (const std::string counts : {"OFF\n4 2\n", "OFF\n4 2 5\n", "OFF 4 2 5\n", "OFF\n4\n2\n5\n",
                                     "OFF # a\n# b\n\n4 2 # c\n", "# a\n\nOFF\n4 2 0 # b\n#c\n"}) {
        const Model model = read_text_model(counts + off_rest, ".off");
        EXPECT_EQ(*model.meshes[0], expected) << counts;
        EXPECT_THAT(model.notices, IsEmpty());
    }
}

TEST(OffReader, LeavesOutFacesOfVerticesThatAreNotThere)
{
    const Model read =
        read_text_model("OFF\n4 3\n" + off_rest.substr(0, 32) + "3 0 1 4\n3 0 2 3\n", ".off");
    EXPECT_EQ(*read.meshes[0], *read_text_model(off_text(square_model()), ".off").meshes[0]);
    EXPECT_THAT(read.notices,
                ElementsAre("a.off: 1 face names a vertex that is not there and was left out (line "
                            "8); the file has 4 vertices"));
}

TEST(OffReader, SaysTheLineAndTheWordThatIsWrong)
{
    const auto refused = [](const std::string& text) { return refusal_of(text, ".off"); };
    EXPECT_EQ(
        refused("OFF\n4 x\n"),
        "a.off: line 2: the number of faces is 'x' but must be a whole number from 0 to 999999999");
    EXPECT_EQ(
        refused("OFF\n2 0\n0 0 0\n0 1e39 0\n"),
        "a.off: line 4: a number of vertex 1 is '1e39', which is not a number from -3.4e38 to "
        "3.4e38");
    EXPECT_EQ(
        refused("OFF\n1 2\n0 0 0\n3 0 1 0\n3 0 0 2\n"),
        "a.off: every face names a vertex that is not there (the first: line 4); the file has "
        "1 vertex");
    EXPECT_EQ(refused("X\n"),
              "a.off: line 1: the file must begin with OFF, COFF, NOFF, CNOFF or STOFF");
}

} // namespace
} // namespace trivar
