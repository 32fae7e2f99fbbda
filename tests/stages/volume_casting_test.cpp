// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "core/casting/casting.h"
#include "core/commands/command.h"
#include "core/commands/objects/voxels.h"
#include "core/document/document_digest.h"
#include "core/document/parameters.h"
#include "core/evaluation/evaluate.h"
#include "core/stages/shown_volume.h"
#include "tests/support/fixtures.h"
#include "tests/voxels/volume_writers.h"

#include <gmock/gmock.h>

namespace trivar {
namespace {

class CastDocuments : public ::testing::Test {
protected:
    CastDocuments()
    {
        VoxelGrid grid;
        grid.size = {12, 10, 8};
        std::vector<std::uint8_t> samples;
        for (std::size_t i = 0; i < grid.count(); ++i)
            samples.push_back(static_cast<std::uint8_t>(i % 12 * 20));
        grid.samples = samples;
        testing::write_file(folder_.file("ramp.nrrd"), write_nrrd(grid));
    }
    Document with(const VolumeCasting& casting) const
    {
        return after({}, AddVoxels{.shape = {.path = "ramp.nrrd", .casting = casting},
                                   .transform = {.translation = {1, 2, 3}}});
    }
    Ref<EvaluatedObject> shown(const Document& document)
    {
        return evaluate_(document, 1).objects.at(1);
    }
    testing::TemporaryFolder folder_;
    Evaluator evaluate_{std::make_shared<AssetStore>(folder_.path())};
};

TEST_F(CastDocuments, AreCountedByTheirDigestOnlyWhereSomethingIsCast)
{
    EXPECT_EQ(digest(with({})), digest(with(VolumeCasting{})));
    EXPECT_NE(digest(with({.shown = true})), digest(with({})));
    EXPECT_NE(digest(with({.shown = true, .crop_high = {1, 1, 0.5f}})),
              digest(with({.shown = true})));
}

TEST_F(CastDocuments, ShowTheWholeDataByTheirHistogram)
{
    EXPECT_FALSE(shown(with({}))->shape->volume->casting);
    const Ref<EvaluatedObject> object = shown(with({.shown = true}));
    const ShownVolume& volume = *object->shape->volume;
    ASSERT_TRUE(volume.casting);
    EXPECT_EQ(volume.casting->transfer.least, 0);
    EXPECT_EQ(volume.casting->transfer.greatest, 220);
    EXPECT_TRUE(volume.casting->transfer.empty(0, 0.2));
    EXPECT_FALSE(volume.casting->transfer.empty(0.8, 1));
}

TEST_F(CastDocuments, AreAsLargeAsTheBoxThatIsSeen)
{
    const auto size = [&](const VolumeCasting& casting) {
        return shown(with(casting))->bounds->size();
    };
    const glm::dvec3 whole = size({.shown = true}),
                     half = size({.shown = true, .crop_low = {0.5f, 0, 0}});
    EXPECT_NEAR(half.x, whole.x / 2, 1e-9);
    EXPECT_NEAR(half.y, whole.y, 1e-9);
    const Box box = *shown(with({.shown = true}))->bounds;
    EXPECT_NEAR(box.lo.x, 1, 1e-9) << "where the object stands";
}

TEST_F(CastDocuments, KeepWhatIsReadyForRaysWhereOnlyTheLookChanges)
{
    const auto casting = [&](const VolumeCasting& c) {
        return shown(with(c))->shape->volume->casting;
    };
    const Ref<Casting> first = casting({.shown = true});
    EXPECT_EQ(casting({.shown = true, .density = 2, .shading = 0, .crop_high = {1, 1, 0.5f}}),
              first);
    EXPECT_NE(casting({.shown = true, .points = {{100, {1, 1, 1}, 0.5}}}), first);
}

TEST_F(CastDocuments, TakeKeys)
{
    std::vector<std::string> names;
    const Document document = with({.shown = true, .points = {{100, {1, 1, 1}, 0.5}}});
    for (const Parameter& each : parameters(*document.objects.at(1))) names.push_back(each.name);
    for (const char* ending : {"casting.density", "casting.shading", "casting.crop_low.z",
                               "casting.points.0.opacity", "casting.points.0.color.x"})
        EXPECT_THAT(names, ::testing::Contains(::testing::EndsWith(ending)));
}

TEST_F(CastDocuments, AreSeenByLinesAloneWhateverIsToBeSaidOfThem)
{
    std::string bare = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 12 10 8\nencoding: raw\n\n";
    for (int i = 0; i < 12 * 10 * 8; ++i) bare += static_cast<char>(i % 12 * 10);
    testing::write_file(folder_.file("bare.nrrd"), bare);
    const auto with_level = [&](bool lines) {
        return shown(after(
            {}, AddVoxels{.shape = {.path = "bare.nrrd",
                                    .levels = {{.value = 55, .surface = false, .lines = lines}}}}));
    };
    const Ref<EvaluatedObject> drawn = with_level(true);
    EXPECT_FALSE(drawn->notices.empty()); // the file tells no spacing
    EXPECT_TRUE(drawn->has_no_geometry());
    EXPECT_FALSE(drawn->shows_nothing());
    EXPECT_FALSE(drawn->bounds->empty());
    EXPECT_TRUE(with_level(false)->bounds->empty());
}

TEST_F(CastDocuments, RefuseABoxWithoutAnInside)
{
    EXPECT_THROW(with({.crop_low = {0, 0.6f, 0}, .crop_high = {1, 0.6f, 1}}), Rejected);
    EXPECT_THROW(with({.points = std::vector<TransferPoint>(257)}), Rejected);
}

TEST_F(CastDocuments, ShowNothingOfABoxThatKeysHaveMadeEmpty)
{
    ShownVolume volume = *shown(with({.shown = true}))->shape->volume;
    EXPECT_FALSE(volume.cast_box().empty());
    volume.seen_as.crop_low.y = 1;
    EXPECT_TRUE(volume.cast_box().empty());
    EXPECT_TRUE(volume.seen_corners(glm::dmat4(1)).empty());
}

} // namespace
} // namespace trivar
