// SPDX-License-Identifier: GPL-3.0-or-later
// Files that hold several volumes: times, echoes or layers, behind one another or sample by sample.
#include "core/voxels/segments.h"
#include "tests/support/fixtures.h"
#include "tests/voxels/reading.h"
#include "tests/voxels/volume_files.h"
#include "tests/voxels/volume_writers.h"

#include <cstring>
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace trivar {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr int volumes = 3;

// The small volume with all its samples greater by a thousand for each number from 0.
VoxelGrid volume_of(int number)
{
    VoxelGrid out = testing::small_volume();
    for (std::int16_t& sample : std::get<std::vector<std::int16_t>>(out.samples))
        sample = static_cast<std::int16_t>(sample + 1000 * number);
    return out;
}

std::string behind_one_another()
{
    std::string out;
    for (int k = 0; k < volumes; ++k) out += testing::packed<std::int16_t>(volume_of(k));
    return out;
}

std::string sample_by_sample()
{
    std::string out;
    std::vector<std::string> all;
    for (int k = 0; k < volumes; ++k) all.push_back(testing::packed<std::int16_t>(volume_of(k)));
    for (std::size_t at = 0; at < all[0].size(); at += 2)
        for (const std::string& each : all) out += each.substr(at, 2);
    return out;
}

std::string times_of_nifti()
{
    std::string bytes = write_nifti(testing::small_volume());
    const std::int16_t four = 4, count = volumes;
    std::memcpy(bytes.data() + 40, &four, 2);
    std::memcpy(bytes.data() + 48, &count, 2);
    return bytes.substr(0, 352) + behind_one_another();
}

std::string nrrd(const std::string& sizes, const std::string& lines, const std::string& encoding,
                 const std::string& data)
{
    return "NRRD0004\ntype: short\ndimension: 4\nsizes: " + sizes + "\nendian: little\n" + lines +
           "encoding: " + encoding + "\n\n" + data;
}

std::string meta_image(bool packed)
{
    const std::string data = behind_one_another();
    return fmt::format("ObjectType = Image\nNDims = 4\nBinaryData = True\n"
                       "CompressedData = {}\nElementSpacing = 1 1 1 2\nDimSize = 5 4 3 3\n"
                       "ElementType = MET_SHORT\nElementDataFile = LOCAL\n{}",
                       packed ? "True" : "False", packed ? testing::zlib_packed(data) : data);
}

// Files with the three volumes by the name of what they are.
std::vector<testing::NamedBytes> files()
{
    const std::string first = "kinds: list domain domain domain\n",
                      last = "kinds: domain domain domain time\n", flat = behind_one_another(),
                      mixed = sample_by_sample();
    std::string words;
    for (int k = 0; k < volumes; ++k) words += testing::in_words(volume_of(k)) + "\n";
    return {{"times.nii", times_of_nifti()},
            {"packed.nii.gz", testing::gzipped(times_of_nifti())},
            {"first.nrrd", nrrd("3 5 4 3", first, "raw", mixed)},
            {"first_packed.nrrd", nrrd("3 5 4 3", first, "gzip", testing::gzipped(mixed))},
            {"last.nrrd", nrrd("5 4 3 3", last, "raw", flat)},
            {"last_packed.nrrd", nrrd("5 4 3 3", last, "bzip2", testing::bzip2_packed(flat))},
            {"words.nrrd", nrrd("5 4 3 3", last, "ascii", words)},
            {"no_direction.nrrd",
             nrrd("3 5 4 3",
                  "space: left-posterior-superior\nspace directions: none (1,0,0) (0,1,0) "
                  "(0,0,1)\n",
                  "raw", mixed)},
            {"meta.mha", meta_image(false)},
            {"meta_packed.mha", meta_image(true)}};
}

TEST(SeveralVolumes, GiveTheFirstOrTheOneThatIsAskedFor)
{
    const testing::TemporaryFolder folder;
    for (const testing::NamedBytes& file : files()) {
        const std::string path = folder.file(file.name);
        testing::write_file(path, file.bytes);
        EXPECT_EQ(read_volume(path).grid.samples, volume_of(0).samples) << file.name;
        for (int time = 1; time <= volumes; ++time) {
            const ReadVolume read = read_volume(path, {}, {}, time);
            EXPECT_EQ(read.grid.size, glm::ivec3(5, 4, 3)) << file.name;
            EXPECT_EQ(read.grid.samples, volume_of(time - 1).samples) << file.name << time;
            EXPECT_THAT(read.grid.notices,
                        ::testing::Contains(HasSubstr(fmt::format(
                            "it holds 3 volumes, such as times, echoes or layers; number {} was "
                            "taken",
                            time))))
                << file.name;
        }
        EXPECT_THAT([&] { read_volume(path, {}, {}, 4); },
                    ::testing::ThrowsMessage<Rejected>(
                        HasSubstr("it holds 3 volumes; there is no number 4")))
            << file.name;
    }
}

TEST(SeveralVolumes, GiveAPartAsTheWholeHasIt)
{
    ReadVolumeOptions part;
    part.box = SampleBox{{1, 1, 1}, {3, 2, 2}};
    const testing::TemporaryFolder folder;
    for (const testing::NamedBytes& file : files()) {
        const std::string path = folder.file(file.name);
        testing::write_file(path, file.bytes);
        const VoxelGrid whole = read_volume(path, {}, {}, 2).grid;
        const auto& all = std::get<std::vector<std::int16_t>>(whole.samples);
        std::vector<std::int16_t> wanted;
        for (int z = 1; z <= 2; ++z)
            for (int y = 1; y <= 2; ++y)
                for (int x = 1; x <= 3; ++x)
                    wanted.push_back(all[static_cast<std::size_t>(x + 5 * (y + 4 * z))]);
        EXPECT_EQ(std::get<std::vector<std::int16_t>>(read_volume(path, part, {}, 2).grid.samples),
                  wanted)
            << file.name;
    }
}

TEST(SeveralVolumes, AreRefusedWhereverTheyWereCut)
{
    for (const testing::NamedBytes& file : files())
        for (std::size_t size = 0; size + 7 < file.bytes.size(); size += 7)
            EXPECT_NE(testing::refusal(file.bytes.substr(0, size), file.name), "")
                << file.name << ' ' << size;
}

TEST(Nifti, SaysWhereItsTwoPlacesDiffer)
{
    std::string bytes = write_nifti(testing::small_volume());
    const auto set = [&](std::size_t at, auto value) {
        std::memcpy(bytes.data() + at, &value, sizeof(value));
    };
    for (std::size_t k = 0; k < 3; ++k) {
        set(80 + 4 * k, 2.0f); // distances of the turn, which is none
        for (std::size_t column = 0; column < 4; ++column)
            set(280 + 16 * k + 4 * column, column == k ? 1.0f : 0.0f);
    }
    set(252, std::int16_t{1}), set(254, std::int16_t{1});
    for (std::size_t k = 0; k < 3; ++k) set(256 + 4 * k, 0.0f);
    const VoxelGrid grid = read_volume_bytes(bytes, "a.nii", "").grid;
    EXPECT_NEAR(glm::length(glm::dvec3(grid.to_metres[0])), 1e-3, 1e-9);
    EXPECT_THAT(
        grid.notices,
        ElementsAre("a.nii: its two places differ: samples are 1 x 1 x 1 apart by its matrix "
                    "(sform) and 2 x 2 x 2 by its turn (qform); the matrix was taken"));
}

TEST(Segments, OfALabelMapHaveTheirNamesAndLevelsBetweenLabels)
{
    const testing::TemporaryFolder folder;
    const std::string path = folder.file("labels.seg.nrrd"),
                      head = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n";
    testing::write_file(path, head +
                                  "Segment1_Name:=marrow\nSegment1_LabelValue:=4\n"
                                  "Segment0_LabelValue:=1\nSegment0_Name:=compact bone\n"
                                  "Segment2_Name:=of another layer\nSegment2_LabelValue:=1\n"
                                  "Segment2_Layer:=1\n\n" +
                                  std::string(8, '\1'));
    const std::vector<VolumeSegment> segments = segments_of(path);
    ASSERT_EQ(segments.size(), 2u);
    EXPECT_EQ(segments[0].name, "compact bone");
    EXPECT_EQ(segments[0].level, 0.5);
    EXPECT_EQ(segments[1].name, "marrow");
    EXPECT_EQ(segments[1].level, 2.5);
    testing::write_file(path, head + "\n" + std::string(8, '\1'));
    EXPECT_TRUE(segments_of(path).empty());
    EXPECT_TRUE(segments_of(folder.file("missing.nrrd")).empty());
}

TEST(VolumeFiles, AreKnownByTheirFirstBytesWhateverTheirName)
{
    const testing::TemporaryFolder folder;
    for (const testing::NamedBytes& each : testing::sound_volumes()) {
        testing::write_file(folder.file("1.2.840.7"), each.bytes);
        EXPECT_TRUE(is_volume_file(folder.file("1.2.840.7"))) << each.name;
    }
    testing::write_file(folder.file("text"), "no volume at all, but longer than a head may be");
    EXPECT_FALSE(is_volume_file(folder.file("text")));
    EXPECT_FALSE(is_volume_file(folder.file("missing")));
    EXPECT_FALSE(is_volume_file(folder.path().string()));
}

} // namespace
} // namespace trivar
