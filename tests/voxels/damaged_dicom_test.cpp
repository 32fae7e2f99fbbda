// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/dicom_file.h"
#include "tests/voxels/dicom_files.h"
#include "tests/voxels/reading.h"

#include <gmock/gmock.h>
#include <random>

namespace trivar {
namespace {

using testing::DicomPacking;

std::string frames_file()
{
    std::vector<testing::DicomSlice> frames;
    for (const testing::NamedSlice& each : testing::oblique_series(3)) frames.push_back(each.slice);
    return testing::dicom_frames_file(frames, testing::FramePlaces::enhanced);
}

std::string packed_file(DicomPacking packing)
{
    testing::DicomSlice slice = testing::oblique_series(2)[1].slice;
    slice.packing = packing;
    return testing::dicom_file(slice);
}

// Reads a file that may be damaged; whether its pixels were taken.
bool taken(const std::string& bytes)
{
    try {
        const DicomHead head = read_dicom_head(bytes, "a.dcm");
        if (head.frames.empty()) return false;
        const TakenSamples samples = read_dicom_samples(bytes, head, "a.dcm");
        const std::size_t count =
            std::visit([](const auto& all) { return all.size(); }, samples.samples);
        EXPECT_EQ(count, static_cast<std::size_t>(head.columns * head.rows) * head.frames.size());
        return true;
    } catch (const Rejected& rejected) {
        EXPECT_EQ(std::string(rejected.what()).find('\n'), std::string::npos);
        return false;
    }
}

TEST(DamagedDicom, IsNeverTakenWhereItIsCut)
{
    for (const std::string& bytes :
         {frames_file(), packed_file(DicomPacking::none), packed_file(DicomPacking::implicit)}) {
        EXPECT_TRUE(taken(bytes));
        for (std::size_t size = 133; size < bytes.size(); size += 1 + size / 200)
            EXPECT_FALSE(taken(bytes.substr(0, size))) << size;
        EXPECT_FALSE(taken(bytes.substr(0, bytes.size() - 1)));
    }
}

TEST(DamagedDicom, IsNeverTakenWhereItsPackedPixelsAreCut)
{
    for (const DicomPacking packing :
         {DicomPacking::rle, DicomPacking::jpeg_lossless, DicomPacking::jpeg_ls}) {
        const std::string bytes = packed_file(packing);
        EXPECT_TRUE(taken(bytes));
        for (std::size_t size = bytes.size() - 60; size < bytes.size() - 8; ++size)
            EXPECT_FALSE(taken(bytes.substr(0, size))) << size;
    }
}

TEST(DamagedDicom, IsRefusedOrSoundWithChangedBytes)
{
    std::mt19937 random(3);
    for (const std::string& sound :
         {frames_file(), packed_file(DicomPacking::none), packed_file(DicomPacking::rle),
          packed_file(DicomPacking::jpeg_lossless), packed_file(DicomPacking::jpeg_ls)})
        for (int k = 0; k < 400; ++k) {
            std::string bytes = sound;
            for (int changes = k % 4; changes >= 0; --changes)
                bytes[132 + random() % (bytes.size() - 132)] = static_cast<char>(random());
            taken(bytes);
        }
}

// DCMTK 3.6.7 never goes on from a marker that stands alone in packed pixels.
TEST(DamagedDicom, EndsWhereAMarkerOfItsPackedPixelsIsAnother)
{
    const std::string sound = packed_file(DicomPacking::jpeg_lossless);
    const std::size_t picture = sound.find("\xff\xd8\xff");
    ASSERT_NE(picture, std::string::npos);
    for (int marker = 0; marker < 256; ++marker) {
        std::string bytes = sound;
        bytes[picture + 3] = static_cast<char>(marker);
        taken(bytes);
    }
    std::string filled = sound; // fill bytes before the marker
    filled.replace(picture + 2, 5, "\xff\xff\xff\xff\x01");
    EXPECT_FALSE(taken(filled));
}

// Sequences in sequences take stack in DCMTK; 100,000 of them end a process that does not see to
// it.
TEST(DamagedDicom, MayBeNestedAsDeepAsItsBytesGo)
{
    using namespace std::string_literals;
    const std::string sound = packed_file(DicomPacking::none);
    const std::string level = "\x08\0\x40\x11SQ\0\0\xff\xff\xff\xff\xfe\xff\0\xe0\xff\xff\xff\xff"s;
    const std::size_t meta_end = 132 + 12 + static_cast<unsigned char>(sound[140]);
    for (const int depth : {400, 100'000, 300'000}) {
        std::string bytes = sound.substr(0, meta_end);
        for (int k = 0; k < depth; ++k) bytes += level;
        EXPECT_FALSE(taken(bytes)) << depth;
    }
}

} // namespace
} // namespace trivar
