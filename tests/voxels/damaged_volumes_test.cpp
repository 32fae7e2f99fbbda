// SPDX-License-Identifier: GPL-3.0-or-later
// Files that are cut and bytes that are changed: refused in a sentence, or a sound volume.
#include "core/voxels/volume_summary.h"
#include "tests/voxels/reading.h"
#include "tests/voxels/volume_files.h"

#include <random>

namespace trivar {
namespace {

void expect_sound(const VoxelGrid& grid)
{
    EXPECT_GE(std::min({grid.size.x, grid.size.y, grid.size.z}), 2);
    EXPECT_EQ(grid.count(), std::visit([](const auto& all) { return all.size(); }, grid.samples));
    EXPECT_NE(glm::determinant(glm::dmat3(grid.to_metres)), 0);
    EXPECT_NE(grid.slope, 0);
    summary_of(grid);
}

// Reads bytes that may be damaged; whether they were taken.
bool taken(const std::string& bytes, const std::string& name)
{
    try {
        expect_sound(read_volume_bytes(bytes, name, "").grid);
        return true;
    } catch (const Rejected& rejected) {
        const std::string sentence = rejected.what();
        EXPECT_GT(sentence.size(), 10u);
        EXPECT_EQ(sentence.find('\n'), sentence.npos);
        return false;
    }
}

// Bytes behind the samples may be missing: the end of the XML, the last end of line.
std::size_t bytes_needed(const testing::NamedBytes& file)
{
    const std::size_t tail = file.bytes.find("</AppendedData");
    if (tail != std::string::npos) return tail - 1;
    const bool blank_behind = file.bytes.ends_with('\n');
    const bool number_behind = file.name == "ascii.vtk" || file.name == "ascii.nrrd";
    std::size_t end = file.bytes.size() - (blank_behind ? 1 : 0);
    // A number that is cut is another number, and one.
    while (number_behind && file.bytes[end - 1] <= ' ') --end;
    while (number_behind && file.bytes[end - 1] > ' ') --end;
    return number_behind ? end + 1 : end;
}

TEST(DamagedVolumes, AreNeverTakenWhereSamplesAreCutOff)
{
    for (const testing::NamedBytes& file : testing::sound_volumes()) {
        EXPECT_TRUE(taken(file.bytes, file.name)) << file.name;
        const std::size_t needed = bytes_needed(file);
        for (std::size_t size = 0; size < needed; ++size)
            EXPECT_FALSE(taken(file.bytes.substr(0, size), file.name)) << file.name << ' ' << size;
    }
}

TEST(DamagedVolumes, AreRefusedOrSoundWithChangedBytes)
{
    std::mt19937 random(7);
    for (const testing::NamedBytes& file : testing::sound_volumes())
        for (int k = 0; k < 250; ++k) {
            std::string bytes = file.bytes;
            const std::size_t reach =
                k % 2 == 0 ? std::min<std::size_t>(bytes.size(), 400) : bytes.size();
            for (int changes = k % 5; changes >= 0; --changes)
                bytes[random() % reach] = static_cast<char>(random());
            taken(bytes, file.name);
        }
}

TEST(DamagedVolumes, AreRefusedOrSoundWithChangedDigits)
{
    std::mt19937 random(11);
    for (const testing::NamedBytes& file : testing::sound_volumes())
        for (int k = 0; k < 150; ++k) {
            std::string bytes = file.bytes;
            for (std::size_t at = 0; at < std::min<std::size_t>(bytes.size(), 700); ++at)
                if (bytes[at] >= '0' && bytes[at] <= '9' && random() % 20 == 0)
                    bytes[at] = "0123456789-.e"[random() % 13];
            taken(bytes, file.name);
        }
}

} // namespace
} // namespace trivar
