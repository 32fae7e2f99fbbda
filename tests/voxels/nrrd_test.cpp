// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/fixtures.h"
#include "tests/voxels/reading.h"
#include "tests/voxels/volume_files.h"
#include "tests/voxels/volume_writers.h"

#include <cmath>
#include <cstring>
#include <gmock/gmock.h>
#include <limits>

namespace trivar {
namespace {

using ::testing::HasSubstr;
using testing::refusal;

// A head for small_volume()'s samples, with more lines; the last one is `encoding`.
std::string nrrd_head(const std::string& lines, const std::string& encoding = "raw",
                      const std::string& type = "short")
{
    return "NRRD0004\ntype: " + type + "\ndimension: 3\nsizes: 5 4 3\nendian: little\n" + lines +
           "encoding: " + encoding + "\n";
}

const std::string& small_bytes()
{
    static const std::string bytes = testing::packed<std::int16_t>(testing::small_volume());
    return bytes;
}

TEST(Nrrd, GivesBackWhatWasWritten)
{
    const VoxelGrid grid = testing::small_volume();
    const VoxelGrid read = read_volume_bytes(write_nrrd(grid), "a.nrrd", "").grid;
    EXPECT_EQ(read.samples, grid.samples);
    EXPECT_EQ(read.size, grid.size);
    testing::expect_same_place(read.to_metres, grid.to_metres, 1e-15);
    EXPECT_TRUE(read.notices.empty());
}

TEST(Nrrd, ReadsEveryEncodingToTheSameSamples)
{
    const VoxelGrid grid = testing::small_volume();
    std::string hex;
    for (const char c : small_bytes()) {
        constexpr const char* digits = "0123456789abcdef";
        hex += digits[static_cast<unsigned char>(c) >> 4];
        hex += digits[c & 15];
    }
    for (const auto& [encoding, bytes] : {std::pair<std::string, std::string>{"raw", small_bytes()},
                                          {"gzip", testing::gzipped(small_bytes())},
                                          {"bzip2", testing::bzip2_packed(small_bytes())},
                                          {"ascii", testing::in_words(grid)},
                                          {"hex", hex}})
        EXPECT_EQ(
            read_volume_bytes(nrrd_head("", encoding) + "\n" + bytes, "a.nrrd", "").grid.samples,
            grid.samples)
            << encoding;
}

TEST(Nrrd, ReadsManyFilesBesideItsHead)
{
    const testing::TemporaryFolder folder;
    for (int k = 0; k < 3; ++k)
        testing::write_file(folder.file("s" + std::to_string(k + 8) + ".raw"),
                            small_bytes().substr(static_cast<std::size_t>(40 * k), 40));
    for (const char* files :
         {"data file: s%d.raw 8 10 1 2\n", "data file: LIST 2\ns8.raw\ns9.raw\ns10.raw\n"}) {
        testing::write_file(folder.file("a.nhdr"), nrrd_head("") + files);
        const ReadVolume read = read_volume(folder.file("a.nhdr"));
        EXPECT_EQ(read.grid.samples, testing::small_volume().samples) << files;
        EXPECT_THAT(read.companions, ::testing::ElementsAre("s10.raw", "s8.raw", "s9.raw"));
    }
    testing::write_file(folder.file("s9.raw"), "short");
    EXPECT_THROW(read_volume(folder.file("a.nhdr")), Rejected);
}

TEST(Nrrd, OpensNoFileOutsideItsFolder)
{
    const testing::TemporaryFolder folder;
    for (const char* file : {"/etc/passwd", "../a.raw", "-"}) {
        testing::write_file(folder.file("a.nhdr"),
                            nrrd_head(std::string("data file: ") + file + "\n"));
        EXPECT_THROW(read_volume(folder.file("a.nhdr")), Rejected) << file;
    }
}

TEST(Nrrd, CountsSkippedBytesFromTheEndToo)
{
    const VoxelGrid grid = testing::small_volume();
    const auto read = [&](const std::string& lines, const std::string& data) {
        return refusal(nrrd_head(lines) + "\n" + data, "a.nrrd");
    };
    EXPECT_EQ(read("byte skip: 4\n", "head" + small_bytes()), "");
    EXPECT_EQ(read("byte skip: -1\n", "anything" + small_bytes()), "");
    EXPECT_EQ(read("byte skip: -3\n", "anything" + small_bytes() + "ab"), "");
    EXPECT_EQ(read("line skip: 2\n", "one\ntwo\n" + small_bytes()), "");
    EXPECT_THAT(read("byte skip: -5\n", small_bytes()),
                HasSubstr("120 samples' bytes and 4 behind"));
}

TEST(Nrrd, RefusesStreamsThatAreShorterOrLonger)
{
    EXPECT_EQ(refusal(nrrd_head("") + "\n" + small_bytes().substr(1), "a.nrrd"),
              "a.nrrd has 119 bytes of samples; 5 x 4 x 3 voxels of 16 bits need 120");
    EXPECT_THAT(refusal(nrrd_head("") + "\n" + small_bytes() + "x", "a.nrrd"),
                HasSubstr("has 121 bytes of samples"));
    EXPECT_THAT(
        refusal(nrrd_head("", "gzip") + "\n" + testing::gzipped(small_bytes() + "xy"), "a.nrrd"),
        HasSubstr("more than the 120 bytes expected"));
}

TEST(Nrrd, RefusesAHugeHeadOverFewBytesAtOnce)
{
    const std::string head = "NRRD0004\ntype: float\ndimension: 3\nsizes: 2000 2000 2500\n"
                             "endian: little\nencoding: ";
    EXPECT_THAT(refusal(head + "raw\n\n" + std::string(1000, 'a'), "a.nrrd"),
                HasSubstr("need 40,000,000,000"));
    EXPECT_THAT(refusal(head + "gzip\n\n" + std::string(1000, 'a'), "a.nrrd"),
                HasSubstr("cannot hold the 40,000,000,000"));
    EXPECT_THAT(refusal(head + "ascii\n\n" + std::string(1000, '1'), "a.nrrd"),
                HasSubstr("too few for 10,000,000,000 numbers"));
}

TEST(Nrrd, TurnsSpacesToThePatientsLeftBackAndHead)
{
    const std::string lines = "space directions: (1,0,0) (0,2,0) (0,0,3)\nspace origin: (5,6,7)\n";
    const auto place = [&](const std::string& space) {
        return read_volume_bytes(nrrd_head("space: " + space + "\n" + lines) + "\n" + small_bytes(),
                                 "a.nrrd", "")
            .grid.to_metres;
    };
    testing::expect_same_place(place("left-posterior-superior"),
                               testing::upright_mm({1, 2, 3}, {5, 6, 7}));
    testing::expect_same_place(place("right-anterior-superior"),
                               testing::upright_mm({-1, -2, 3}, {-5, -6, 7}));
    testing::expect_same_place(place("left-anterior-superior"),
                               testing::upright_mm({1, -2, 3}, {5, -6, 7}));
}

TEST(Nrrd, RefusesColoursAndVectors)
{
    EXPECT_THAT(refusal("NRRD0004\ntype: uchar\ndimension: 4\nsizes: 3 5 4 3\nencoding: raw\n"
                        "kinds: RGB-color domain domain domain\n\n" +
                            std::string(180, 'a'),
                        "a.nrrd"),
                HasSubstr("one number at each point"));
    EXPECT_THAT(refusal("NRRD0004\ntype: uchar\ndimension: 4\nsizes: 3 5 4 3\nencoding: raw\n\n" +
                            std::string(180, 'a'),
                        "a.nrrd"),
                HasSubstr("4 dimensions"));
}

TEST(Nrrd, SaysWhereADistanceOfOneMayBeNone)
{
    const std::string plain = "space: left-posterior-superior\n"
                              "space directions: (1,0,0) (0,1,0) (0,0,1)\n";
    const auto notices = [&](const std::string& lines) {
        return read_volume_bytes(nrrd_head(lines) + "\n" + small_bytes(), "a.nrrd", "")
            .grid.notices;
    };
    EXPECT_THAT(notices(plain),
                ::testing::ElementsAre(HasSubstr("its samples are 1 apart along each axis, without "
                                                 "a unit, so it may not know their distance")));
    EXPECT_THAT(notices(plain + "space units: \"mm\" \"mm\" \"mm\"\n"), ::testing::IsEmpty());
}

TEST(Nrrd, SaysInItsOwnWordsWhatIsWrongInAHead)
{
    const auto why = [](const std::string& lines) {
        return refusal("NRRD0004\n" + lines + "\n" + small_bytes(), "a.nrrd");
    };
    const std::string front = "a.nrrd: the head of this NRRD file is damaged: ";
    EXPECT_EQ(why("type: short\ndimension: 3\nspace: left-posterior-superior\nsizes: 5 4 3\nspace "
                  "directions: (1,0,0 (0,1,0) (0,0,1)\nendian: little\nencoding: raw\n"),
              front + "its line 'space directions: (1,0,0 (0,1,0) (0,0,1)' cannot be read");
    EXPECT_EQ(why("type: banana\ndimension: 3\nsizes: 5 4 3\nencoding: raw\n"),
              front + "its line 'type: banana' cannot be read");
    EXPECT_EQ(why("type: short\ndimension: 3\nsizes: 5 4 3\ngarbage\nencoding: raw\n"),
              front + "its line 'garbage' is not 'field: value'");
    EXPECT_THAT(why("type: short\ndimension: 3\nsizes: 5 4 3\nencoding: raw\n"),
                HasSubstr("does not say the order of bytes"));
    EXPECT_THAT(why("type: short\ndimension: 3\nencoding: raw\nendian: little\n"),
                HasSubstr("a line is missing: type, dimension, sizes and encoding are needed"));
}

TEST(Nrrd, RefusesDirectionsInAPlane)
{
    EXPECT_THAT(refusal(nrrd_head("space: left-posterior-superior\n"
                                  "space directions: (1,0,0) (0,1,0) (1,1,0)\n") +
                            "\n" + small_bytes(),
                        "a.nrrd"),
                HasSubstr("do not span space"));
}

TEST(Nrrd, RoundsDoublesToFloatsAndSaysHowMany)
{
    std::string bytes = testing::packed<double>(testing::small_volume());
    const double tenth = 0.1, nan = std::nan("");
    std::memcpy(bytes.data(), &tenth, 8);
    std::memcpy(bytes.data() + 8, &nan, 8);
    const VoxelGrid read =
        read_volume_bytes(nrrd_head("spacings: 2 1 1\n", "raw", "double") + "\n" + bytes, "a.nrrd",
                          "")
            .grid;
    EXPECT_EQ(std::get<std::vector<float>>(read.samples)[0], 0.1f);
    EXPECT_THAT(read.notices,
                ::testing::ElementsAre("a.nrrd: 1 of its 64-bit floating point numbers was rounded "
                                       "to 32-bit floating point",
                                       "a.nrrd: 1 of its samples is not a number, infinite or "
                                       "beyond 1e30; the least value, 0.1, stands for it"));
}

TEST(Nrrd, PlacesWithoutDataHaveTheLeastValue)
{
    std::vector<float> samples(60, 3e-25f);
    samples[3] = -2e-25f;
    samples[5] = std::nanf("");
    samples[7] = std::numeric_limits<float>::infinity();
    samples[11] = 9.97e36f;
    const std::string bytes(reinterpret_cast<const char*>(samples.data()), 4 * samples.size());
    const VoxelGrid grid =
        read_volume_bytes(nrrd_head("spacings: 2 1 1\n", "raw", "float") + "\n" + bytes, "a.nrrd",
                          "")
            .grid;
    const auto& read = std::get<std::vector<float>>(grid.samples);
    ASSERT_EQ(read.size(), samples.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
        const bool least = i == 3 || i == 5 || i == 7 || i == 11;
        EXPECT_FLOAT_EQ(static_cast<float>(grid.value(read[i])), least ? -2e-25f : 3e-25f) << i;
        EXPECT_GT(std::abs(read[i]), 0.5f) << i; // as squares of slopes must not vanish
    }
    ASSERT_EQ(grid.notices.size(), 1u);
    EXPECT_THAT(grid.notices[0], ::testing::HasSubstr("3 of its samples are not a number"));
}

} // namespace
} // namespace trivar
