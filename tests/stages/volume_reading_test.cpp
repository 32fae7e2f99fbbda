// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/commands/command.h"
#include "core/commands/objects/voxels.h"
#include "core/document/document_digest.h"
#include "core/evaluation/evaluate.h"
#include "core/level/voxel_field.h"
#include "core/scene/log.h"
#include "core/scene/scene_file.h"
#include "core/stages/shown_volume.h"
#include "core/voxels/coarsened.h"
#include "core/voxels/read_volume.h"
#include "core/voxels/usual_level.h"
#include "tests/support/fixtures.h"
#include "tests/voxels/volume_writers.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

// A ball of values from 200 in its middle, in 21 x 18 x 15 samples one millimetre apart.
VoxelGrid fine_ball()
{
    VoxelGrid grid;
    grid.size = {21, 18, 15};
    std::vector<std::uint16_t> samples;
    for (int k = 0; k < 15; ++k)
        for (int j = 0; j < 18; ++j)
            for (int i = 0; i < 21; ++i)
                samples.push_back(static_cast<std::uint16_t>(
                    std::max(0.0, 200 - 20 * glm::length(glm::dvec3(i - 10, j - 9, k - 7)))));
    grid.samples = samples;
    grid.to_metres = glm::dmat4(glm::dmat3(0.001));
    return grid;
}

class CoarselyRead : public ::testing::Test {
protected:
    CoarselyRead() { testing::write_file(folder_.file("ball.nrrd"), write_nrrd(fine_ball())); }
    AddVoxels command(int coarsen) const
    {
        AddVoxels out;
        out.shape.path = "ball.nrrd";
        out.shape.levels = {{.value = 60.5}};
        out.shape.reading.coarsen = coarsen;
        return out;
    }
    testing::TemporaryFolder folder_;
    Ref<AssetStore> assets_ = std::make_shared<AssetStore>(folder_.path());
};

TEST_F(CoarselyRead, VolumesAreWhatTheReaderGivesForThatCoarsening)
{
    for (const int n : {1, 2, 3, 5}) {
        const VolumeReading reading{.coarsen = n};
        const AssetStore::LoadedVolume loaded = assets_->load_volume("ball.nrrd", {}, {}, reading);
        ReadVolumeOptions options;
        options.coarsen = n;
        const ReadVolume read = read_volume(folder_.file("ball.nrrd"), options);
        EXPECT_EQ(loaded.grid->samples, read.grid.samples);
        EXPECT_EQ(loaded.grid->to_metres, read.grid.to_metres);
        EXPECT_EQ(loaded.grid->samples, coarsened(fine_ball(), glm::ivec3(n)).samples);
        EXPECT_EQ(assets_->part_of_volume("ball.nrrd", reading), read.part);
        EXPECT_EQ(loaded.hash, assets_->load_volume("ball.nrrd", {}).hash) << "of the files";
    }
}

TEST_F(CoarselyRead, ScenesReplayUndoAndCountTheCoarsening)
{
    const std::string path = folder_.file("a.trivar");
    SceneFile scene;
    scene.save_as(path);
    scene.run(prepare(command(1), *assets_));
    const std::string fine = digest(scene.document());
    SetVoxels coarser{1, std::get<VoxelShape>(object(scene.document(), 1).source)};
    coarser.shape.reading.coarsen = 3;
    scene.run(prepare(coarser, *assets_));
    const std::string coarse = digest(scene.document());
    EXPECT_NE(coarse, fine);
    EXPECT_EQ(digest(SceneFile(path).document()), coarse);
    scene.undo();
    EXPECT_EQ(digest(scene.document()), fine);
    scene.redo();
    EXPECT_EQ(digest(scene.document()), coarse);
    Evaluator evaluate(assets_);
    const Evaluation shown = evaluate(SceneFile(path).document(), 1);
    EXPECT_EQ(shown.objects.at(1)->shape->volume->field->grid().size, glm::ivec3(7, 6, 5));
    EXPECT_FALSE(shown.objects.at(1)->parts.empty());
}

TEST_F(CoarselyRead, ScenesFromBeforeAreReadWhole)
{
    std::string line = command_line(command(1));
    const std::string field = "\"coarsen\":1,";
    const std::size_t reading = line.find("\"reading\":{");
    ASSERT_NE(reading, std::string::npos);
    const std::size_t at = line.find("\"coarsen\":1", reading);
    ASSERT_NE(at, std::string::npos);
    line.erase(line[at - 1] == ',' ? at - 1 : at, field.size());
    const Document before = replay(read_log(log_header() + line, "a.trivar")).document();
    EXPECT_EQ(digest(before), digest(after({}, command(1))));
    EXPECT_NE(digest(before), digest(after({}, command(2))));
}

TEST_F(CoarselyRead, ShowTheUsualLevelWhereALogNamesNone)
{
    const auto surface_of = [&](const AddVoxels& add) {
        Document document = after({}, add);
        const Evaluation shown = Evaluator(assets_)(document);
        EXPECT_TRUE(std::get<VoxelShape>(object(document, 1).source).levels.size() ==
                    add.shape.levels.size());
        return shown.objects.at(1)->shape->model->meshes.at(0)->positions;
    };
    AddVoxels none = command(1), usual = none;
    none.shape.levels.clear();
    const AssetStore::LoadedVolume loaded = assets_->load_volume("ball.nrrd", {});
    usual.shape.levels = {{.value = usual_level(*loaded.summary, *loaded.grid)}};
    EXPECT_EQ(surface_of(none), surface_of(usual));
    EXPECT_GT(surface_of(none).size(), 100u);
}

TEST_F(CoarselyRead, TakesOneToSixtyFourForOne)
{
    EXPECT_THROW(after({}, command(0)), Rejected);
    EXPECT_THROW(after({}, command(65)), Rejected);
}

} // namespace
} // namespace trivar
