// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/voxels/segments.h"
#include "core/voxels/volume_summary.h"
#include "tests/support/fixtures.h"
#include "tests/voxels/reading.h"

#include <gmock/gmock.h>
#include <numeric>

namespace trivar {
namespace {

class RealDataVolumes : public ::testing::Test {
protected:
    void SetUp() override
    {
        if (testing::real_data_folder().empty()) GTEST_SKIP() << "no folder of real data";
    }
    static VoxelGrid read(const std::string& name)
    {
        return read_volume(testing::real_data_folder() + "/volumes/" + name).grid;
    }
    static double sum(const VoxelGrid& grid)
    {
        return std::visit(
            [](const auto& all) { return std::accumulate(all.begin(), all.end(), 0.0); },
            grid.samples);
    }
};

TEST_F(RealDataVolumes, ABallIsTheSameInEveryEncoding)
{
    const std::string ball = "nrrd-pynrrd/BallBinary30x30x30";
    const VoxelGrid plain = read(ball + ".nrrd");
    EXPECT_EQ(plain.size, glm::ivec3(30));
    for (const char* ending :
         {".nhdr", "_bz2.nrrd", "_gz.nrrd", "_gz_lineskip.nrrd", "_gz_byteskip_minus_one.nrrd",
          ".nii.gz", "_byteskip_minus_one.nhdr", "_byteskip_minus_one_nifti.nhdr"})
        EXPECT_EQ(read(ball + ending).samples, plain.samples) << ending;
    // These name fewer bytes than there are: the head of the NIfTI file, or four behind the end.
    for (const char* ending : {"_nifti.nhdr", "_byteskip_minus_five.nhdr"})
        EXPECT_THROW(read(ball + ending), Rejected) << ending;
}

TEST_F(RealDataVolumes, AHeadOfManyFilesIsOne)
{
    const VoxelGrid head = read("headsq/quarter.nhdr");
    EXPECT_EQ(head.size, glm::ivec3(64, 64, 93));
    const VolumeSummary summary = summary_of(head);
    EXPECT_NEAR(summary.spacing_mm.x, 3.2, 1e-12);
    EXPECT_NEAR(summary.spacing_mm.z, 1.5, 1e-12);
    EXPECT_GT(summary.greatest, 2000);
}

TEST_F(RealDataVolumes, OtherFormatsGiveSizesAndSums)
{
    struct Expected {
        const char* name;
        glm::ivec3 size;
        const char* type;
    };
    for (const Expected& each :
         {Expected{"ironProt.vtk", {68, 68, 68}, "unsigned 8-bit whole numbers"},
          {"tooth.nrrd", {103, 94, 161}, "unsigned 8-bit whole numbers"},
          {"HeadMRVolume.mhd", {48, 62, 42}, "unsigned 8-bit whole numbers"},
          {"anatomical.nii", {33, 41, 25}, "signed 16-bit whole numbers"}}) {
        const VoxelGrid grid = read(each.name);
        EXPECT_EQ(grid.size, each.size) << each.name;
        EXPECT_EQ(summary_of(grid).type, each.type) << each.name;
        EXPECT_GT(sum(grid), 0) << each.name;
    }
}

// Small files of kinds that other programs write and that were refused or misread once.
class RealDataOddVolumes : public RealDataVolumes {
protected:
    static ReadVolume read_odd(const std::string& name, int time = 1)
    {
        return read_volume(testing::real_data_folder() + "/found3/" + name, {}, {}, time);
    }
};

TEST_F(RealDataOddVolumes, SeriesAreReadWithoutTheirScout)
{
    for (const char* name : {"42_scout_direction", "42_scout_size"}) {
        const VoxelGrid grid = read_odd(name).grid;
        EXPECT_EQ(grid.size.z, 6) << name;
        EXPECT_THAT(grid.notices,
                    ::testing::Contains(::testing::HasSubstr("was left out: scout.dcm")))
            << name;
    }
}

TEST_F(RealDataOddVolumes, DeflatedSlicesAreRead)
{
    const VoxelGrid grid = read_odd("39_deflated").grid;
    EXPECT_EQ(grid.size.z, 3);
    EXPECT_GT(sum(grid), 0);
}

TEST_F(RealDataOddVolumes, EachOfThreeTimesIsRead)
{
    const VoxelGrid first = read_odd("37_three_times.nii").grid;
    EXPECT_EQ(read_odd("37_three_times.nii", 1).grid.samples, first.samples);
    EXPECT_EQ(read_odd("37_three_times.nii", 3).grid.size, first.size);
    EXPECT_THROW(read_odd("37_three_times.nii", 4), Rejected);
}

TEST_F(RealDataOddVolumes, TwoPlacesThatDifferAreTold)
{
    EXPECT_THAT(read_odd("35_q_and_s_differ.nii").grid.notices,
                ::testing::Contains(::testing::HasSubstr("its two places differ")));
}

TEST_F(RealDataOddVolumes, SegmentsHaveTheirNames)
{
    const auto segments = segments_of(testing::real_data_folder() + "/found3/38_labels.seg.nrrd");
    ASSERT_EQ(segments.size(), 2u);
    EXPECT_EQ(segments[0].name, "bone");
    EXPECT_EQ(segments[1].name, "marrow");
}

} // namespace
} // namespace trivar
