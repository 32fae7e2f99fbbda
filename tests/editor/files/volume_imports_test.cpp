// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/stages/shown_volume.h"
#include "editor/files/volume_names.h"
#include "editor/files/volume_slices.h"
#include "editor/session/session_facts.h"
#include "tests/editor/volume_rig.h"

#include <gmock/gmock.h>
#include <imgui_internal.h>

namespace trivar {
namespace {

using ::testing::HasSubstr;
using testing::VolumeRig, testing::write_file, testing::write_slices;

TEST(VolumeImports, ShowWhatWasReadBeforeItIsTaken)
{
    VolumeRig rig;
    rig.drop({rig.folder.file("ball.nrrd")});
    const VolumeOffer* offer = rig.editor.files.volumes.offered();
    ASSERT_TRUE(offer);
    EXPECT_TRUE(rig.editor.files.asking());
    EXPECT_EQ(rig.steps(), 0u);
    EXPECT_EQ(offer->summary->size, glm::ivec3(24));
    for (const VolumeSlice& slice : offer->slices) {
        EXPECT_EQ(slice.image.size_px, glm::ivec2(24));
        EXPECT_NEAR(slice.shape, 1, 1e-6);
    }
    rig.key({ui::key_enter});
    rig.wait();
    ASSERT_EQ(rig.steps(), 1u);
    EXPECT_FALSE(rig.editor.files.asking());
    EXPECT_EQ(object(rig.editor.session.committed(), 1).name, "ball");
    EXPECT_EQ(rig.shape().levels.size(), 1u);
    EXPECT_TRUE(rig.editor.session.selected.contains(1));
    const Box box = bounds_of(rig.editor.session, 1);
    EXPECT_NEAR(box.center().x, 0, 1e-3) << "in the middle";
    const PicturePoint seen = project(rig.editor.session.view.camera, box.center());
    const glm::dvec2 middle = glm::dvec2(rig.editor.session.view.camera.size_px) / 2.0;
    EXPECT_LT(glm::distance(seen.p_px, middle), 60) << "the view shows it";
}

TEST(VolumeImports, LeaveNothingWhereTheyAreCancelled)
{
    VolumeRig rig;
    rig.drop({rig.folder.file("ball.nrrd"), rig.folder.file("ball.nrrd")});
    rig.key({ui::key_escape});
    EXPECT_TRUE(rig.editor.files.volumes.offering()) << "one after the other";
    rig.key({ui::key_escape});
    EXPECT_FALSE(rig.editor.files.volumes.offering());
    EXPECT_EQ(rig.steps(), 0u);
}

TEST(VolumeImports, AreCancelledByEscapeOnlyWhereNoListIsOpen)
{
    VolumeRig rig;
    rig.drop({rig.folder.file("ball.nrrd")});
    const auto open = [] { return ImGui::GetCurrentContext()->OpenPopupStack.Size; };
    ASSERT_EQ(open(), 1);
    const ImRect dialog = ImGui::GetCurrentContext()->OpenPopupStack[0].Window->Rect();
    for (const float share : {0.2f, 0.35f, 0.6f, 0.85f})
        for (float y = dialog.Min.y + 40; y < dialog.Max.y - 110 && open() == 1; y += 16)
            rig.click({dialog.Min.x + share * dialog.GetWidth(), y});
    ASSERT_EQ(open(), 2) << "it has a row with a list";
    rig.key({ui::key_escape});
    EXPECT_EQ(open(), 1);
    EXPECT_TRUE(rig.editor.files.volumes.offering());
    rig.key({ui::key_escape});
    EXPECT_FALSE(rig.editor.files.volumes.offering());
}

TEST(VolumeImports, StandAsTheOfferSays)
{
    VolumeRig rig;
    rig.drop({rig.folder.file("ball.nrrd")});
    VolumeOffer& offer = *rig.editor.files.volumes.offered();
    const double wide = size_of(offer).x;
    for (const DataUp up :
         {DataUp::minus_z, DataUp::y, DataUp::minus_y, DataUp::x, DataUp::minus_x}) {
        offer.up = up;
        offer.scale = 10;
        EXPECT_NEAR(size_of(offer).z, 10 * wide, 1e-9);
        const AddVoxels command = command_of(offer);
        EXPECT_EQ(command.shape.scale, 10);
        EXPECT_NEAR(glm::abs(glm::determinant(command.transform.matrix())), 1, 1e-9);
    }
    offer.centered = false;
    EXPECT_EQ(command_of(offer).transform.translation, glm::dvec3(0));
}

TEST(VolumeImports, ShowTheirSlicesAsTheyWillStand)
{
    VolumeRig rig;
    VoxelGrid grid = testing::ball_grid(); // with a bright slab at its top
    auto& samples = std::get<std::vector<std::uint8_t>>(grid.samples);
    for (std::size_t k = 20; k < 24; ++k)
        for (std::size_t j = 0; j < 24; ++j)
            for (std::size_t i = 0; i < 24; ++i) samples[i + 24 * (j + 24 * k)] = 250;
    testing::write_file(rig.folder.file("marked.nrrd"), write_nrrd(grid));
    rig.drop({rig.folder.file("marked.nrrd")});
    VolumeOffer& offer = *rig.editor.files.volumes.offered();
    // The share of bright pixels in the upper and in the lower quarter of the front.
    const auto bright = [&] {
        const Image image = turned_slices(offer)[1].image;
        std::array<int, 2> out{};
        for (int y = 0; y < image.size_px.y; ++y)
            for (int x = 0; x < image.size_px.x; ++x) {
                const auto at = static_cast<std::size_t>(4 * (x + image.size_px.x * y));
                if (image.rgba[at] > 200 && y < image.size_px.y / 4) ++out[0];
                if (image.rgba[at] > 200 && y >= image.size_px.y * 3 / 4) ++out[1];
            }
        return out;
    };
    offer.up = DataUp::z;
    EXPECT_GT(bright()[0], 50);
    EXPECT_EQ(bright()[1], 0);
    offer.up = DataUp::minus_z;
    EXPECT_EQ(bright()[0], 0);
    EXPECT_GT(bright()[1], 50);
    offer.up = DataUp::z;
    EXPECT_EQ(turned_slices(offer)[1].image.rgba,
              middle_slices(*offer.grid, *offer.summary)[1].image.rgba);
}

TEST(VolumeImports, HaveALevelForEachSegmentOfALabelMap)
{
    VolumeRig rig;
    std::string labels;
    for (int i = 0; i < 512; ++i) labels.push_back(static_cast<char>(i / 171));
    testing::write_file(rig.folder.file("a.seg.nrrd"),
                        "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 8 8 8\nencoding: raw\n"
                        "Segment0_Name:=bone\nSegment0_LabelValue:=1\nSegment1_Name:=marrow\n"
                        "Segment1_LabelValue:=2\n\n" +
                            labels);
    rig.drop({rig.folder.file("a.seg.nrrd")});
    const VoxelShape& shape = rig.editor.files.volumes.offered()->command.shape;
    ASSERT_EQ(shape.levels.size(), 2u);
    EXPECT_EQ(shape.levels[0].name, "bone");
    EXPECT_EQ(shape.levels[0].value, 0.5);
    EXPECT_EQ(shape.levels[1].name, "marrow");
    EXPECT_EQ(shape.levels[1].value, 1.5);
    EXPECT_EQ(shape.spline, FieldSpline::smoothing);
}

TEST(VolumeImports, TakeFoldersOfPictures)
{
    VolumeRig rig;
    write_slices(rig.folder.file("head"));
    rig.drop({rig.folder.file("head") + "/"});
    ASSERT_TRUE(rig.editor.files.volumes.offering());
    EXPECT_TRUE(rig.editor.files.volumes.offered()->says_no_spacing);
    rig.key({ui::key_enter});
    rig.wait();
    ASSERT_EQ(rig.steps(), 1u);
    EXPECT_EQ(object(rig.editor.session.committed(), 1).name, "head");
    EXPECT_FALSE(rig.editor.session.evaluated().objects.at(1)->parts.empty());
}

TEST(VolumeImports, SayWhyNothingCame)
{
    VolumeRig rig;
    write_file(rig.folder.file("empty/about.txt"), "no slices");
    write_file(rig.folder.file("cut.nrrd"), "NRRD0004\nencoding: raw\n");
    rig.drop({rig.folder.file("empty"), rig.folder.file("cut.nrrd")});
    EXPECT_FALSE(rig.editor.files.volumes.offering());
    EXPECT_EQ(rig.steps(), 0u);
    EXPECT_FALSE(rig.editor.session.notices.all().empty());
}

TEST(VolumeImports, AskHowAFileWithoutAHeadLies)
{
    VolumeRig rig;
    const VoxelGrid grid = testing::ball_grid();
    const auto& samples = std::get<std::vector<std::uint8_t>>(grid.samples);
    write_file(rig.folder.file("ball.raw"), "head" + std::string(samples.begin(), samples.end()));
    rig.drop({rig.folder.file("ball.raw")});
    VolumeImports& imports = rig.editor.files.volumes;
    ASSERT_TRUE(imports.offering());
    EXPECT_TRUE(imports.offered()->raw);
    imports.offered()->command.shape.reading = {.size = glm::ivec3(24), .header_bytes = 3};
    imports.read_again();
    rig.wait();
    EXPECT_FALSE(imports.offered()->grid);
    EXPECT_THAT(imports.offered()->trouble, HasSubstr("13,82"));
    imports.offered()->command.shape.reading.header_bytes = 4;
    imports.read_again();
    rig.wait();
    ASSERT_TRUE(imports.offered()->grid);
    EXPECT_EQ(imports.offered()->grid->samples, grid.samples);
    rig.key({ui::key_enter});
    rig.wait();
    ASSERT_EQ(rig.steps(), 1u);
    EXPECT_EQ(rig.shape().reading.header_bytes, 4);
    EXPECT_FALSE(rig.editor.session.evaluated().objects.at(1)->parts.empty());
}

// The ball has 24 x 24 x 24 samples of a byte, and takes 6 for each with the
// spline through them.
TEST(VolumeImports, AreCoarsenedSoFarThatTheyFitIntoTheMemory)
{
    VolumeRig rig;
    VolumeImports& imports = rig.editor.files.volumes;
    imports.memory_bytes = 24 * 24 * 24;
    rig.drop({rig.folder.file("ball.nrrd")});
    ASSERT_TRUE(imports.offering());
    EXPECT_EQ(imports.offered()->command.shape.reading.coarsen, 2);
    EXPECT_EQ(imports.offered()->grid->size, glm::ivec3(12));
    EXPECT_EQ(imports.offered()->keepings.front(), (Keeping{2, 12 * 12 * 12, 6 * 12 * 12 * 12}));
    EXPECT_TRUE(asks_what_is_kept(*imports.offered()));
    ASSERT_FALSE(imports.offered()->notices.empty());
    EXPECT_THAT(imports.offered()->notices.front(),
                HasSubstr("every voxel would take 14 KB, 83 KB with what the window makes of them, "
                          "more than the 14 KB that volume data may take; one voxel for 2 along "
                          "each axis is kept"));
    imports.offered()->command.shape.reading.coarsen = 3; // the person's choice stays
    imports.read_again();
    rig.wait();
    EXPECT_EQ(imports.offered()->grid->size, glm::ivec3(8));
    imports.offered()->command.shape.reading.coarsen = 1; // does not fit
    imports.read_again();
    rig.wait();
    EXPECT_EQ(imports.offered()->grid->size, glm::ivec3(12));
    rig.key({ui::key_enter});
    rig.wait();
    ASSERT_EQ(rig.steps(), 1u);
    EXPECT_EQ(rig.shape().reading.coarsen, 2);
    EXPECT_EQ(rig.editor.session.evaluated().objects.at(1)->shape->volume->field->grid().size,
              glm::ivec3(12));
}

TEST(VolumeImports, SayThatNothingOfThemFitsIntoTheMemory)
{
    VolumeRig rig;
    rig.editor.files.volumes.memory_bytes = 4;
    rig.drop({rig.folder.file("ball.nrrd")});
    EXPECT_FALSE(rig.editor.files.volumes.offering());
    EXPECT_FALSE(rig.editor.session.notices.all().empty());
}

TEST(VolumeImports, AskWhatIsKeptOfLargeDataOnly)
{
    VolumeRig rig;
    rig.drop({rig.folder.file("ball.nrrd")});
    ASSERT_TRUE(rig.editor.files.volumes.offering());
    EXPECT_FALSE(asks_what_is_kept(*rig.editor.files.volumes.offered()));
    GridPart part;
    part.whole = {1024, 1024, 64};
    part.box = {glm::ivec3(0), part.whole - 1};
    part.bytes_per_sample = 2;
    const std::vector<Keeping> ways = keepings(part, std::uint64_t{450} << 20);
    ASSERT_FALSE(ways.empty());
    EXPECT_EQ(ways.front(), (Keeping{1, 128 << 20, 448 << 20}));
    EXPECT_EQ(words_of(ways.front()), "Every voxel, 134 MB");
    EXPECT_EQ(words_of(ways[1]), "1 for 2 per axis, 16.8 MB");
    for (std::size_t i = 1; i < ways.size(); ++i) EXPECT_LT(ways[i].bytes, ways[i - 1].bytes);
}

TEST(VolumeImports, KnowTheirFilesByName)
{
    for (const char* name : {"a.nrrd", "b.NII.GZ", "c.mhd", "d.dcm", "e.raw"})
        EXPECT_TRUE(is_volume(name)) << name;
    for (const char* name : {"a.obj", "b.gz", "c.png", "d"}) EXPECT_FALSE(is_volume(name)) << name;
    EXPECT_EQ(volume_name("x/anatomical.nii.gz"), "anatomical");
    EXPECT_TRUE(is_raw_volume("head.RAW"));
    const testing::TemporaryFolder folder;
    testing::write_file(folder.file("IM0001"), write_nrrd(testing::ball_grid(4)));
    testing::write_file(folder.file("readme"), "no volume");
    EXPECT_TRUE(is_volume(folder.file("IM0001")));
    EXPECT_FALSE(is_volume(folder.file("readme")));
}

} // namespace
} // namespace trivar
