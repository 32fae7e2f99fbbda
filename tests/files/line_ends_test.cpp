// SPDX-License-Identifier: GPL-3.0-or-later
// What an editor of text may do to a file without changing what it says.
#include "core/files/formats.h"
#include "tests/files/text_models.h"

#include <bit>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;
using ::testing::HasSubstr;

const std::string utf8_sign = "\xef\xbb\xbf";

std::string with_line_ends(const std::string& text, const std::string& end)
{
    std::string result;
    for (const char c : text)
        if (c == '\n')
            result += end;
        else
            result += c;
    return result;
}

// In UTF-16 with the given order of the bytes; a mark is the character 0xfeff.
std::string in_utf16(const std::string& text, bool marked, bool big_first)
{
    std::string result;
    const auto add = [&](char high, char low) {
        result += big_first ? high : low;
        result += big_first ? low : high;
    };
    if (marked) add('\xfe', '\xff');
    for (const char c : text) add('\0', c);
    return result;
}

class TextFormats : public ::testing::TestWithParam<const char*> {
protected:
    const std::string text = text_of(square_model(), GetParam());
};

TEST_P(TextFormats, AreReadWithAnyLineEndAndTheMarkOfUtf8)
{
    const Mesh expected = *read_text_model(text, GetParam()).meshes[0];
    for (const char* end : {"\n", "\r\n", "\r", " \r\n"})
        for (const std::string& before : {std::string(), utf8_sign}) {
            const Model read = read_text_model(before + with_line_ends(text, end), GetParam());
            EXPECT_EQ(*read.meshes[0], expected);
            EXPECT_TRUE(read.notices.empty());
        }
}

TEST(LineEnds, OfTheHeadOfABinaryPlyAreOneOrTwoBytesAndNeverItsData)
{
    const std::string head = "ply\nformat binary_little_endian 1.0\nelement vertex 3\n"
                             "property float x\nproperty float y\nproperty float z\n"
                             "element face 1\nproperty list uchar int vertex_indices\n"
                             "end_header\n";
    for (const float first : {0.0f, std::bit_cast<float>(0x0a0d0a0du)}) { // ends of lines as data
        std::string data;
        const auto put = [&](const auto& value) {
            data.append(reinterpret_cast<const char*>(&value), sizeof value);
        };
        for (const float x : {first, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f, 0.0f}) put(x);
        put(std::uint8_t{3});
        for (const std::int32_t v : {0, 1, 2}) put(v);
        for (const char* end : {"\n", "\r\n", "\r", "\n\r"}) {
            const Model read = read_text_model(with_line_ends(head, end) + data, ".ply");
            EXPECT_EQ(read.meshes[0]->face_count(), 1u);
            EXPECT_EQ(read.meshes[0]->positions[0].x, first);
        }
    }
}

TEST(LineEnds, OfFilesOfPointsAloneDoNotMatterForWhatIsSaid)
{
    TextModel points = square_model();
    points.faces.clear();
    for (const char* extension : {".obj", ".ply", ".off"})
        EXPECT_THAT(refusal_of(with_line_ends(text_of(points, extension), "\r\n"), extension),
                    HasSubstr("it is a point cloud, which is not shown; make a mesh"));
}

TEST_P(TextFormats, NameTheSameLineWithAnyLineEnd)
{
    std::string broken = text;
    broken.replace(broken.rfind("1 1 0"), 5, "1 ? 0");
    const std::string sentence = refusal_of(broken, GetParam());
    EXPECT_THAT(sentence, HasSubstr("'?'"));
    for (const char* end : {"\r\n", "\r"})
        EXPECT_EQ(refusal_of(utf8_sign + with_line_ends(broken, end), GetParam()), sentence);
}

TEST_P(TextFormats, InUtf16AreRefusedWithWhatToDo)
{
    for (const bool marked : {false, true})
        for (const bool big_first : {false, true})
            EXPECT_THAT(refusal_of(in_utf16(text, marked, big_first), GetParam()),
                        HasSubstr("UTF-16 or UTF-32; save it as UTF-8"));
}
INSTANTIATE_TEST_SUITE_P(Formats, TextFormats, ::testing::Values(".obj", ".ply", ".off", ".stl"));

TEST(TextGltf, InUtf16IsRefusedWithWhatToDo)
{
    EXPECT_THAT(refusal_of(in_utf16(R"({"asset":{}})", true, false), ".gltf"),
                HasSubstr("save it as UTF-8"));
}

TEST(TextMtl, IsReadWithAnyLineEndAndTheMarkOfUtf8)
{
    const std::string text = "newmtl a b\nKd 1 0 0\nnewmtl c\nKd 0 1 0\nPr 0.25\n";
    const std::vector<Material> expected = read_mtl({text, "m.mtl", ""}).materials;
    ASSERT_EQ(expected.size(), 2u);
    for (const char* end : {"\r\n", "\r"}) {
        const std::string other = utf8_sign + with_line_ends(text, end);
        EXPECT_EQ(read_mtl({other, "m.mtl", ""}).materials, expected);
    }
}

// The first byte behind such a header may be 10, which is then no end of a line.
TEST(BinaryPly, IsReadWithAHeaderOfAnyLineEnd)
{
    std::string header = ply_text(square_model());
    header = header.substr(0, header.find("0 0 0"));
    header.replace(header.find("ascii"), 5, "binary_little_endian");
    std::string data;
    const auto add = [&](auto value) {
        data.append(reinterpret_cast<const char*>(&value), sizeof value);
    };
    const float ten = std::bit_cast<float>(std::uint32_t{10});
    for (const float value :
         {ten, 0.0f, 0.0f, 1.0f, 0.0f, 0.0f, 1.0f, 1.0f, 0.0f, 0.0f, 1.0f, 0.0f})
        add(value);
    for (const std::int32_t last : {2, 3}) {
        data += '\3';
        for (const std::int32_t v : {0, last - 1, last}) add(v);
    }
    const Mesh expected = *read_text_model(header + data, ".ply").meshes[0];
    for (const std::string end : {"\r\n", "\r"})
        EXPECT_EQ(*read_text_model(with_line_ends(header, end) + data, ".ply").meshes[0], expected);
}

} // namespace
} // namespace trivar
