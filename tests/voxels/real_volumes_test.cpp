// SPDX-License-Identifier: GPL-3.0-or-later
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

} // namespace
} // namespace trivar
