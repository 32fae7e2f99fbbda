// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/fixtures.h"
#include "tests/voxels/dicom_files.h"
#include "tests/voxels/reading.h"

#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace trivar {
namespace {

using testing::DicomPacking;
using testing::DicomSlice;
using ::testing::ElementsAre;
using testing::FramePlaces;
using ::testing::HasSubstr;
using testing::NamedSlice;

class DicomSeries : public ::testing::Test {
protected:
    void write(const std::vector<NamedSlice>& slices)
    {
        for (const NamedSlice& each : slices)
            testing::write_file(folder_.file(each.name), testing::dicom_file(each.slice));
    }
    ReadVolume read(const ReadVolumeOptions& options = {}) const
    {
        return read_volume(folder_.path().string(), options);
    }
    std::string refusal() const
    {
        try {
            read();
        } catch (const Rejected& rejected) {
            return rejected.what();
        }
        return {};
    }
    testing::TemporaryFolder folder_;
};

// Sample i of slice k of oblique_series() is 100 k + i.
void expect_series(const VoxelGrid& grid, int count)
{
    ASSERT_EQ(grid.size, glm::ivec3(6, 5, count));
    const auto& samples = std::get<std::vector<std::int16_t>>(grid.samples);
    for (int k = 0; k < count; ++k)
        for (int i = 0; i < 30; ++i)
            ASSERT_EQ(samples[static_cast<std::size_t>(30 * k + i)], 100 * k + i) << k << ' ' << i;
}

TEST_F(DicomSeries, IsOrderedByPlaceAndNotByName)
{
    write(testing::oblique_series(20));
    const ReadVolume read = this->read();
    expect_series(read.grid, 20);
    testing::expect_same_place(read.grid.to_metres, testing::oblique_place(), 1e-8);
    EXPECT_EQ(read.grid.intercept, -1024);
    EXPECT_EQ(read.grid.value_unit, "HU");
    EXPECT_TRUE(read.grid.notices.empty()) << read.grid.notices[0];
    EXPECT_EQ(read.companions.size(), 20u);
}

TEST_F(DicomSeries, IsReadWholeFromOneOfItsFiles)
{
    write(testing::oblique_series(4));
    const ReadVolume read = read_volume(folder_.file("im003.dcm"));
    expect_series(read.grid, 4);
    EXPECT_EQ(read.companions.size(), 3u);
}

TEST_F(DicomSeries, IsReadInEveryPackingThatCanBeDecoded)
{
    for (const DicomPacking packing :
         {DicomPacking::big_endian, DicomPacking::implicit, DicomPacking::rle,
          DicomPacking::deflated, DicomPacking::jpeg_lossless, DicomPacking::jpeg_ls}) {
        std::vector<NamedSlice> slices = testing::oblique_series(3);
        for (NamedSlice& each : slices) each.slice.packing = packing;
        write(slices);
        expect_series(read().grid, 3);
    }
}

TEST_F(DicomSeries, NamesThePackingThatCannotBeDecoded)
{
    std::vector<NamedSlice> slices = testing::oblique_series(2);
    for (NamedSlice& each : slices) each.slice.packing = DicomPacking::jpeg2000_claimed;
    write(slices);
    EXPECT_THAT(refusal(), HasSubstr("JPEG 2000"));
    EXPECT_THAT(refusal(), HasSubstr("not read; JPEG, JPEG-LS, RLE"));
    EXPECT_THAT(refusal(), HasSubstr("gdcmconv --raw IN OUT"));
}

TEST_F(DicomSeries, TakesTheLargestAndNamesTheOthers)
{
    write(testing::oblique_series(5));
    for (NamedSlice other : testing::oblique_series(3)) {
        other.name = "other" + other.name;
        other.slice.series = "1.2.3.2";
        other.slice.description = "scout";
        write({other});
    }
    const ReadVolume largest = read();
    expect_series(largest.grid, 5);
    EXPECT_THAT(largest.grid.notices,
                ElementsAre("the folder has 1 other series that was not read: scout (3 slices)"));
    ReadVolumeOptions asked;
    asked.series = "1.2.3.2";
    expect_series(read(asked).grid, 3);
    asked.series = "9";
    EXPECT_THROW(read(asked), Rejected);
}

TEST_F(DicomSeries, IsReadBesideReportsInColoursOfOtherSeries)
{
    write(testing::oblique_series(4));
    NamedSlice report = testing::oblique_series(1)[0];
    report.name = "report.dcm";
    report.slice.colours = "RGB";
    write({report});
    EXPECT_THAT(read().grid.notices.at(0),
                HasSubstr("1 file was left out (report.dcm: its pixels are colours"));
    report.slice.series = "1.2.3.9";
    write({report});
    const VoxelGrid grid = read().grid;
    expect_series(grid, 4);
    EXPECT_THAT(
        grid.notices,
        ElementsAre("1 file was left out (report.dcm: its pixels are colours (RGB); a volume "
                    "has one number at each point)"));
}

TEST_F(DicomSeries, IsReadBesideDamagedFilesThatAreNamed)
{
    write(testing::oblique_series(4));
    const std::string whole = testing::dicom_file({});
    testing::write_file(folder_.file("cut.dcm"), whole.substr(0, 500));
    testing::write_file(folder_.file("empty.dcm"), "");
    testing::write_file(folder_.file("notes.txt"), "no slice");
    for (const VoxelGrid& grid : {read().grid, read_volume(folder_.file("im003.dcm")).grid}) {
        expect_series(grid, 4);
        ASSERT_EQ(grid.notices.size(), 1u);
        EXPECT_THAT(grid.notices[0], HasSubstr("2 files were left out (the first: cut.dcm: this "
                                               "DICOM file is damaged or ends too early"));
    }
    EXPECT_THAT(
        [&] { read_volume(folder_.file("cut.dcm")); },
        ::testing::ThrowsMessage<Rejected>(HasSubstr("cut.dcm: this DICOM file is damaged")));
    std::filesystem::remove(folder_.file("cut.dcm"));
    EXPECT_THAT(read().grid.notices.at(0),
                HasSubstr("empty.dcm: this is no DICOM file, or its head is missing"));
}

TEST_F(DicomSeries, InterpolatesWhereADamagedSliceIsLeftOut)
{
    std::vector<NamedSlice> slices = testing::oblique_series(6);
    for (NamedSlice& each : slices) each.slice.packing = DicomPacking::jpeg_lossless;
    write(slices);
    const std::string path = folder_.file(slices[2].name);
    std::string bytes = testing::dicom_file(slices[2].slice);
    const std::size_t frame = bytes.rfind("\xff\xd8\xff"); // begins a picture
    ASSERT_NE(frame, bytes.npos);
    for (std::size_t k = frame; k < bytes.size() - 8; ++k) bytes[k] = '\0';
    testing::write_file(path, bytes);
    const VoxelGrid grid = read().grid;
    expect_series(grid, 6); // the samples of the series are linear
    EXPECT_THAT(grid.notices,
                ::testing::Contains(HasSubstr("1 file was left out (" + slices[2].name)));
    EXPECT_THAT([&] { read_volume(path); },
                ::testing::ThrowsMessage<Rejected>(HasSubstr("packed pixels are damaged")));
}

TEST_F(DicomSeries, LeavesAScoutOfAnotherDirectionOrSizeOut)
{
    for (const bool turned : {true, false}) {
        write(testing::oblique_series(5));
        NamedSlice scout = testing::oblique_series(1)[0];
        scout.name = "a_scout.dcm";
        if (turned) {
            scout.slice.along_column = {0, 0, -1};
        } else {
            scout.slice.rows = 3;
            scout.slice.samples.resize(18);
        }
        write({scout});
        const VoxelGrid grid = read().grid;
        expect_series(grid, 5);
        EXPECT_THAT(grid.notices,
                    ElementsAre("1 slice of other size, type, direction or distance of pixels was "
                                "left out: a_scout.dcm"));
        EXPECT_THAT([&] { read_volume(folder_.file("a_scout.dcm")); },
                    ::testing::ThrowsMessage<Rejected>(HasSubstr("it has 1 slice")));
    }
}

TEST_F(DicomSeries, FillsAGapByInterpolationAndSaysSo)
{
    std::vector<NamedSlice> slices = testing::oblique_series(8);
    slices.erase(slices.begin() + 3, slices.begin() + 5);
    write(slices);
    const VoxelGrid grid = read().grid;
    expect_series(grid, 8); // the samples of the series are linear
    testing::expect_same_place(grid.to_metres, testing::oblique_place(), 1e-8);
    ASSERT_EQ(grid.notices.size(), 1u);
    EXPECT_THAT(grid.notices[0], HasSubstr("3.75 mm from im017.dcm to im038.dcm, where 1.25 mm are "
                                           "usual; 8 slices 1.25 mm apart were interpolated"));
}

TEST_F(DicomSeries, TakesDistancesWithinAHundredthAsEven)
{
    std::vector<NamedSlice> slices = testing::oblique_series(5);
    slices[2].slice.position += 0.005 * glm::dvec3(0, -std::sin(0.3), std::cos(0.3));
    write(slices);
    EXPECT_TRUE(read().grid.notices.empty());
    slices[2].slice.position += 0.1 * glm::dvec3(0, -std::sin(0.3), std::cos(0.3));
    write(slices);
    EXPECT_THAT(read().grid.notices.at(0), HasSubstr("not evenly apart"));
}

TEST_F(DicomSeries, RefusesAGapThatIsTooWide)
{
    std::vector<NamedSlice> slices = testing::oblique_series(4);
    slices[3].slice.position += 1000.0 * glm::dvec3(0, -std::sin(0.3), std::cos(0.3));
    write(slices);
    EXPECT_THAT(refusal(), HasSubstr("so much cannot be interpolated"));
}

TEST_F(DicomSeries, TakesOneOfSeveralSlicesAtAPlace)
{
    std::vector<NamedSlice> slices = testing::oblique_series(4);
    slices.push_back(slices[1]);
    slices.back().name = "zagain.dcm";
    for (std::int16_t& sample : slices.back().slice.samples) sample = 0;
    write(slices);
    const VoxelGrid copied = read().grid;
    expect_series(copied, 4);
    EXPECT_THAT(copied.notices.at(0),
                HasSubstr("up to 2 slices lie at one place, such as im010.dcm "
                          "and zagain.dcm: times, echoes or copies; number 1 "
                          "was taken"));
}

TEST_F(DicomSeries, TakesTheTimeThatIsAskedFor)
{
    // The times follow each other as a whole by their numbers; by name they are mixed.
    constexpr int places = 4, times = 3;
    std::vector<NamedSlice> slices;
    for (int time = 0; time < times; ++time)
        for (NamedSlice each : testing::oblique_series(places)) {
            const int k = each.slice.samples[0] / 100;
            each.slice.number = 1 + places * time + k;
            each.name = fmt::format("{}_{}.dcm", (7 * each.slice.number) % 13, time);
            for (std::int16_t& sample : each.slice.samples)
                sample = static_cast<std::int16_t>(sample + 1000 * time);
            slices.push_back(each);
        }
    write(slices);
    for (int time = 1; time <= times; ++time) {
        const VoxelGrid grid = read_volume(folder_.path().string(), {}, {}, time).grid;
        ASSERT_EQ(grid.size, glm::ivec3(6, 5, places));
        const auto& samples = std::get<std::vector<std::int16_t>>(grid.samples);
        for (std::size_t i = 0; i < samples.size(); ++i)
            ASSERT_EQ(samples[i], static_cast<int>(100 * (i / 30) + i % 30) + 1000 * (time - 1));
        EXPECT_THAT(grid.notices.at(0), HasSubstr("3 slices lie at each place"));
    }
    EXPECT_THAT([&] { read_volume(folder_.path().string(), {}, {}, 4); },
                ::testing::ThrowsMessage<Rejected>(
                    HasSubstr("it has 3 slices at each place; there is no time 4")));
}

TEST_F(DicomSeries, TakesPlacesThatAreRoundedAsOnALine)
{
    std::vector<NamedSlice> slices = testing::oblique_series(7);
    slices[3].slice.position.x += 0.05; // of pixels of 0.7 mm
    write(slices);
    const VoxelGrid grid = read().grid;
    expect_series(grid, 7);
    EXPECT_THAT(grid.notices, ElementsAre(HasSubstr("its slices lie up to 0.05 mm beside a line")));
}

TEST_F(DicomSeries, IsObliqueWhereTheGantryWasTilted)
{
    std::vector<NamedSlice> slices = testing::oblique_series(6);
    const glm::dvec3 down = slices[0].slice.along_column;
    for (std::size_t k = 0; k < slices.size(); ++k)
        slices[k].slice.position += 0.5 * static_cast<double>(k) * down;
    write(slices);
    const VoxelGrid grid = read().grid;
    expect_series(grid, 6);
    glm::dmat4 place = testing::oblique_place();
    place[2] += glm::dvec4(0.0005 * down, 0);
    testing::expect_same_place(grid.to_metres, place, 1e-8);
    EXPECT_THAT(grid.notices.at(0), HasSubstr("tilted by 21.8 degrees"));
}

TEST_F(DicomSeries, RefusesASliceBesideTheLine)
{
    std::vector<NamedSlice> slices = testing::oblique_series(4);
    slices[1].slice.position.x += 1;
    write(slices);
    EXPECT_THAT(refusal(), HasSubstr("im010.dcm lies 1 mm beside the line"));
}

TEST_F(DicomSeries, ScalesEachSliceByItsOwnNumbers)
{
    std::vector<NamedSlice> slices = testing::oblique_series(3);
    slices[1].slice.slope = 2;
    slices[1].slice.intercept = 0;
    write(slices);
    const VoxelGrid grid = read().grid;
    const auto& samples = std::get<std::vector<float>>(grid.samples);
    EXPECT_EQ(samples[1], 1 - 1024);
    EXPECT_EQ(samples[31], 202);
    EXPECT_EQ(grid.slope, 1);
    EXPECT_EQ(grid.intercept, 0);
    EXPECT_THAT(grid.notices.at(0), HasSubstr("scaled differently"));
}

TEST_F(DicomSeries, KeepsTwelveBitsAndNoOthers)
{
    std::vector<NamedSlice> slices = testing::oblique_series(2);
    for (NamedSlice& each : slices) {
        each.slice.bits_stored = 12;
        each.slice.samples[0] = static_cast<std::int16_t>(0x7fff); // -1 in 12 bits
        each.slice.samples[1] = static_cast<std::int16_t>(0x5801); // -2047
    }
    write(slices);
    const VoxelGrid grid = read().grid;
    EXPECT_EQ(std::get<std::vector<std::int16_t>>(grid.samples)[0], -1);
    EXPECT_EQ(std::get<std::vector<std::int16_t>>(grid.samples)[1], -2047);
    for (NamedSlice& each : slices) each.slice.is_signed = false;
    write(slices);
    EXPECT_EQ(std::get<std::vector<std::uint16_t>>(read().grid.samples)[0], 4095);
}

TEST_F(DicomSeries, RefusesColoursAndSingleSlices)
{
    std::vector<NamedSlice> slices = testing::oblique_series(1);
    write(slices);
    EXPECT_THAT(refusal(), HasSubstr("it has 1 slice"));
    slices[0].slice.colours = "PALETTE COLOR";
    write(slices);
    EXPECT_THAT(refusal(), HasSubstr("colours (PALETTE COLOR)"));
}

TEST(DicomFrames, AreReadWithTheirPlaces)
{
    std::vector<DicomSlice> frames;
    for (const NamedSlice& each : testing::oblique_series(6)) frames.push_back(each.slice);
    std::swap(frames[1], frames[4]);
    const VoxelGrid grid =
        read_volume_bytes(testing::dicom_frames_file(frames, FramePlaces::enhanced), "a.dcm", "")
            .grid;
    expect_series(grid, 6);
    testing::expect_same_place(grid.to_metres, testing::oblique_place(), 1e-8);
    std::swap(frames[1], frames[4]);
    const VoxelGrid spaced =
        read_volume_bytes(testing::dicom_frames_file(frames, FramePlaces::spacing), "a.dcm", "")
            .grid;
    expect_series(spaced, 6);
    testing::expect_same_place(spaced.to_metres, testing::oblique_place(), 1e-8);
    EXPECT_THAT(testing::refusal(testing::dicom_frames_file(frames, FramePlaces::none), "a.dcm"),
                HasSubstr("6 frames have no places"));
}

} // namespace
} // namespace trivar
