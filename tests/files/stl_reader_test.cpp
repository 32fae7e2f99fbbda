// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/files/text_models.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;

TEST(StlReader, ReadsTextInCapitalsAndWithBlanksBefore)
{
    const std::string text = stl_text(square_model());
    const Mesh expected = *read_text_model(text, ".stl").meshes[0];
    std::string capitals = text;
    std::ranges::transform(capitals, capitals.begin(),
                           [](unsigned char c) { return std::toupper(c); });
    for (const std::string& other : {capitals, "  \n\n\t" + text, "\xef\xbb\xbf \r\n" + capitals})
        EXPECT_EQ(*read_text_model(other, ".stl").meshes[0], expected);
}

// A header of 80 bytes, the number of triangles, and triangles in the plane z = 0.
std::string binary_stl(std::string header, std::uint32_t declared, std::size_t triangles)
{
    header.resize(80, ' ');
    header.append(reinterpret_cast<const char*>(&declared), 4);
    const float values[12] = {0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0};
    for (std::size_t t = 0; t < triangles; ++t) {
        header.append(reinterpret_cast<const char*>(values), sizeof values);
        header.append(2, '\0');
    }
    return header;
}

TEST(StlReader, ReadsBinaryFilesThatCallThemselvesSolidAndHaveMoreBytesThanTheyNeed)
{
    for (const std::string more : {"", "\n", "three"}) {
        const Model read = read_text_model(binary_stl("solid a", 1, 1) + more, ".stl");
        EXPECT_EQ(read.meshes[0]->face_count(), 1u);
        EXPECT_EQ(read.notices.size(), more.empty() ? 0u : 1u);
    }
}

TEST(StlReader, SaysWhatIsWrongAndWhere)
{
    const std::string text = stl_text(square_model());
    const auto with = [&](const std::string& was, const std::string& now) {
        std::string other = text;
        other.replace(other.rfind(was), was.size(), now);
        return refusal_of(other, ".stl");
    };
    EXPECT_EQ(with("1 1 0", "1 1e39 0"),
              "a.stl: line 12: the y of a vertex is '1e39', which is not a number from -3.4e38 to "
              "3.4e38");
    EXPECT_EQ(with("   vertex 0 1 0\n", ""), "a.stl: line 14: a facet has 2 corners instead of 3");
    EXPECT_EQ(
        refusal_of(binary_stl("a", 2, 1), ".stl"),
        "a.stl: this is not an STL file, or it is cut off: it does not begin with 'solid', and a "
        "binary file needs more than its 134 bytes: 184 for the 2 triangles that it declares");
    EXPECT_EQ(refusal_of("facet", ".stl"),
              "a.stl: this is not an STL file, or it is cut off: it does not begin with 'solid', "
              "and a binary file needs more than its 5 bytes: 84 for its header");
    std::string infinite = binary_stl("a", 1, 1);
    std::memset(infinite.data() + 84 + 12, 0xff, 4);
    EXPECT_EQ(refusal_of(infinite, ".stl"),
              "a.stl: triangle 0 of 1, counted from 0: a coordinate is not a finite number");
}

} // namespace
} // namespace trivar
