// SPDX-License-Identifier: GPL-3.0-or-later
// MetaImage, legacy VTK and VTI.
#include "tests/support/fixtures.h"
#include "tests/voxels/reading.h"
#include "tests/voxels/volume_files.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::HasSubstr;
using testing::refusal;
using testing::VtiKind;

// A file with one part of its text changed.
std::string with(std::string text, const std::string& part, const std::string& other)
{
    const std::size_t at = text.find(part);
    EXPECT_NE(at, text.npos) << part;
    return text.replace(at, part.size(), other);
}

const glm::dmat4 upright = testing::upright_mm({0.7, 0.8, 1.25}, {10, -20, 30});

TEST(MetaImage, GivesSamplesAndPlace)
{
    for (const bool packed : {false, true}) {
        const VoxelGrid read = read_volume_bytes(testing::meta_file(packed), "a.mha", "").grid;
        EXPECT_EQ(read.samples, testing::small_volume().samples);
        EXPECT_TRUE(read.notices.empty());
        const glm::dmat4 place{{0.0007, 0, 0, 0},
                               {0, 0.00048, 0.00064, 0},
                               {0, -0.001, 0.00075, 0},
                               {0.01, -0.02, 0.03, 1}};
        testing::expect_same_place(read.to_metres, place, 1e-12);
    }
}

TEST(MetaImage, ReadsItsFilesBesideTheHead)
{
    const testing::TemporaryFolder folder;
    const std::string data = testing::packed<std::int16_t>(testing::small_volume(), true);
    const std::string all = with(testing::meta_file(false), "MSB = False", "MSB = True");
    const std::string head = all.substr(0, all.find("LOCAL"));
    const auto read = [&](const std::string& file) {
        testing::write_file(folder.file("a.mhd"), head + file);
        return read_volume(folder.file("a.mhd"));
    };
    testing::write_file(folder.file("a.raw"), data);
    testing::write_file(folder.file("a.zraw"), testing::zlib_packed(data));
    for (int k = 0; k < 3; ++k)
        testing::write_file(folder.file("s0" + std::to_string(k + 1) + ".raw"),
                            data.substr(static_cast<std::size_t>(40 * k), 40));
    EXPECT_EQ(read("a.raw\n").grid.samples, testing::small_volume().samples);
    EXPECT_EQ(read("s%02d.raw 1 3 1\n").grid.samples, testing::small_volume().samples);
    EXPECT_EQ(read("LIST\ns01.raw\ns02.raw\ns03.raw\n").companions.size(), 3u);
    testing::write_file(folder.file("b.mhd"),
                        with(head, "CompressedData = False", "CompressedData = True") + "a.zraw\n");
    EXPECT_EQ(read_volume(folder.file("b.mhd")).grid.samples, testing::small_volume().samples);
    EXPECT_THROW(read("missing.raw\n"), Rejected);
}

TEST(MetaImage, RefusesWhatIsNoVolume)
{
    const std::string sound = testing::meta_file(false);
    EXPECT_THAT(refusal(with(sound, "MET_SHORT", "MET_SHORT_ARRAY"), "a.mha"),
                HasSubstr("one number"));
    EXPECT_THAT(refusal(with(sound, "5 4 3", "5 4 0"), "a.mha"), HasSubstr("5 x 4 x 0"));
    EXPECT_THAT(refusal(with(sound, "5 4 3", "5 4"), "a.mha"), HasSubstr("3 numbers"));
    EXPECT_THAT(refusal(with(sound, "5 4 3", "50000 40000 3000"), "a.mha"),
                HasSubstr("need 12,000,000,000,000"));
    EXPECT_THAT(refusal(with(sound, "0.7 0.8 1.25", "0 0.8 1.25"), "a.mha"),
                HasSubstr("span space"));
    EXPECT_THAT(refusal(sound + "more", "a.mha"), HasSubstr("has 124 bytes of samples"));
}

TEST(LegacyVtk, GivesSamplesAndPlace)
{
    for (const bool binary : {false, true}) {
        const VoxelGrid read = read_volume_bytes(testing::vtk_file(binary), "a.vtk", "").grid;
        EXPECT_EQ(read.samples, testing::small_volume().samples);
        testing::expect_same_place(read.to_metres, upright, 1e-12);
        EXPECT_TRUE(read.notices.empty());
    }
}

TEST(LegacyVtk, SaysWhatItLeavesOut)
{
    for (const bool binary : {false, true}) {
        const std::string more = testing::vtk_file(binary) + "VECTORS v float\n1 2 3\n";
        const VoxelGrid read = read_volume_bytes(more, "a.vtk", "").grid;
        EXPECT_EQ(read.samples, testing::small_volume().samples);
        ASSERT_EQ(read.notices.size(), 1u);
        EXPECT_THAT(read.notices[0], HasSubstr("VECTORS and what follows were left out"));
    }
    EXPECT_THAT(refusal(testing::vtk_file(true) + "rubbish", "a.vtk"), HasSubstr("8 bytes more"));
}

TEST(LegacyVtk, RefusesWhatIsNoVolume)
{
    const std::string sound = testing::vtk_file(true);
    EXPECT_THAT(refusal(with(sound, "STRUCTURED_POINTS", "POLYDATA"), "a.vtk"),
                HasSubstr("POLYDATA"));
    EXPECT_THAT(refusal(with(sound, "short 1", "short 3"), "a.vtk"), HasSubstr("3 values at each"));
    EXPECT_THAT(refusal(with(sound, "POINT_DATA 60", "POINT_DATA 61"), "a.vtk"),
                HasSubstr("of 61 points"));
    EXPECT_THAT(refusal(with(sound, "POINT_DATA", "CELL_DATA"), "a.vtk"), HasSubstr("cells"));
    EXPECT_THAT(refusal(sound.substr(0, sound.size() - 2), "a.vtk"), HasSubstr("119 bytes"));
}

TEST(Vti, GivesSamplesAndPlaceInEveryEncoding)
{
    for (const VtiKind kind : {VtiKind::ascii, VtiKind::binary, VtiKind::binary_packed,
                               VtiKind::raw, VtiKind::raw_packed, VtiKind::base64_packed}) {
        const VoxelGrid read = read_volume_bytes(testing::vti_file(kind), "a.vti", "").grid;
        EXPECT_EQ(read.samples, testing::small_volume().samples);
        testing::expect_same_place(read.to_metres, upright, 1e-12);
        EXPECT_TRUE(read.notices.empty());
    }
}

TEST(Vti, TurnsByItsDirectionAndBeginsWhereItsExtentDoes)
{
    std::string text = with(testing::vti_file(VtiKind::ascii), "Spacing=\"0.7 0.8 1.25\"",
                            "Spacing=\"1 1 1\" Direction=\"0 -1 0 1 0 0 0 0 1\"");
    for (int k = 0; k < 2; ++k) text = with(text, "xtent=\"0 4 0", "xtent=\"2 6 0");
    const glm::dmat4 place{
        {0, 0.001, 0, 0}, {-0.001, 0, 0, 0}, {0, 0, 0.001, 0}, {0.01, -0.018, 0.03, 1}};
    testing::expect_same_place(read_volume_bytes(text, "a.vti", "").grid.to_metres, place, 1e-12);
}

TEST(Vti, RefusesWhatIsNoVolume)
{
    const std::string sound = testing::vti_file(VtiKind::raw_packed);
    EXPECT_THAT(refusal(with(sound, "vtkZLib", "vtkLZ4"), "a.vti"),
                HasSubstr("vtkLZ4DataCompressor"));
    EXPECT_THAT(refusal(with(sound, "Int16\"", "Int16\" NumberOfComponents=\"3\""), "a.vti"),
                HasSubstr("3 values at each"));
    EXPECT_THAT(refusal(with(sound, "Extent=\"0 4", "Extent=\"0 9"), "a.vti"), HasSubstr("part"));
    EXPECT_THAT(refusal(with(sound, "type=\"ImageData\"", "type=\"PolyData\""), "a.vti"),
                HasSubstr("PolyData"));
    EXPECT_THAT(refusal(with(sound, "offset=\"0\"", "offset=\"99999\""), "a.vti"),
                HasSubstr("99999"));
}

} // namespace
} // namespace trivar
