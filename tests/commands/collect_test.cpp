// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/collect.h"
#include "core/commands/objects/voxels.h"
#include "core/commands/tiles/heights.h"
#include "core/commands/tiles/mask_tiles.h"
#include "core/commands/tiles/tiles.h"

#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/files/companions.h"
#include "core/files/pictures/image.h"
#include "tests/support/fixtures.h"
#include "tests/support/scenes/full_disk.h"

#include <filesystem>
#include <gmock/gmock.h>

namespace trivar {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre, ::testing::HasSubstr;
using testing::FullDisk;
using testing::TemporaryFolder, testing::write_file;

const std::string rock = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

Document with_imports(const std::vector<std::string>& paths)
{
    Document document;
    for (const std::string& path : paths) {
        ImportModel import;
        import.file.path = path;
        document = after(document, import);
    }
    return document;
}

std::string path_of(const Document& document, Id id)
{
    return std::get<ImportedFile>(object(document, id).source).path;
}

std::vector<std::string> all_in(const fs::path& folder)
{
    std::vector<std::string> names;
    for (const auto& each : fs::recursive_directory_iterator(folder))
        if (each.is_regular_file())
            names.push_back(each.path().lexically_relative(folder).string());
    std::ranges::sort(names);
    return names;
}

TEST(Collect, CopiesEachFileOnceAndTakesTheModelsFromThere)
{
    const TemporaryFolder disk;
    const std::string folder = disk.file("scene/a.assets");
    write_file(disk.file("one/rock.obj"), rock);
    write_file(disk.file("two/leaf.obj"), rock + "# leaf\n");
    const AssetStore assets(disk.file("scene"));
    Document document = with_imports({"../one/rock.obj", "../one/rock.obj", "../two/leaf.obj"});
    const Collection done = collect_files(document, assets, folder);
    EXPECT_THAT(all_in(folder), ElementsAre("leaf.obj", "rock.obj"));
    EXPECT_EQ(done.copied, 2u);
    document = after(document, *done.command);
    EXPECT_EQ(path_of(document, 2), "a.assets/rock.obj");
    EXPECT_EQ(path_of(document, 3), "a.assets/leaf.obj");
    ImportedFile leaf;
    leaf.path = path_of(document, 3);
    EXPECT_TRUE(assets.load(leaf).model);
    EXPECT_FALSE(collect_files(document, assets, folder).command) << "nothing is left to do";
}

TEST(Collect, TakesWhatGoesWithAModelAlong)
{
    const TemporaryFolder disk;
    write_file(disk.file("one/rock.obj"), "mtllib my rock.mtl\n" + rock);
    write_file(disk.file("one/my rock.mtl"), "newmtl a\nmap_Kd -s 1 1 1 maps/grey stone.png\n"
                                             "map_Bump ../../secret.png\n");
    write_file(disk.file("one/maps/grey stone.png"), "picture");
    write_file(disk.file("secret.png"), "secret");
    write_file(
        disk.file("two/shell.gltf"),
        R"({"buffers":[{"uri":"shell%201.bin"},{"uri":"data:,x"}],"images":[{"uri":"/etc/passwd"}]})");
    write_file(disk.file("two/shell 1.bin"), "bytes");
    EXPECT_THAT(companions_of(disk.file("one/rock.obj")),
                ElementsAre("maps/grey stone.png", "my rock.mtl"));
    const AssetStore assets(disk.file("scene"));
    const Document document = with_imports({"../one/rock.obj", "../two/shell.gltf"});
    collect_files(document, assets, disk.file("scene/a.assets"));
    EXPECT_THAT(all_in(disk.file("scene/a.assets")),
                ElementsAre("rock/maps/grey stone.png", "rock/my rock.mtl", "rock/rock.obj",
                            "shell/shell 1.bin", "shell/shell.gltf"));
}

// A sheet of heights, and a layer of tiles with a mask, by two pictures.
Document with_pictures(const std::string& heights, const std::string& mask)
{
    Document document = after(Document{}, AddHeights{.shape = {.image = heights}});
    document = after(after(document, AddPlane{}), AddPlane{});
    document = after(document, CoverWithTiles{3, 2, {.pattern = TilePattern::grid, .size = 0.5}});
    document = after(document, MaskTiles{3, 0, {.from = MaskFrom::line}});
    return after(document, MaskTiles{3, 0, {.from = MaskFrom::image, .image = mask}});
}

TEST(Collect, TakesThePicturesOfMasksAndHeightsAlong)
{
    const TemporaryFolder disk;
    write_file(disk.file("one/hills.png"), "hills");
    write_file(disk.file("two/spots.png"), "spots");
    const std::string folder = disk.file("scene/a.assets");
    const AssetStore assets(disk.file("scene"));
    Document document = with_pictures("../one/hills.png", "../two/spots.png");
    const Collection done = collect_files(document, assets, folder);
    EXPECT_THAT(all_in(folder), ElementsAre("hills.png", "spots.png"));
    EXPECT_EQ(done.copied, 2u);
    ASSERT_TRUE(done.command);
    document = after(document, *done.command);
    EXPECT_EQ(std::get<HeightShape>(object(document, 1).source).image, "a.assets/hills.png");
    EXPECT_EQ(object(document, 3).tiles->masks[1].image, "a.assets/spots.png");
    EXPECT_EQ(object(document, 3).tiles->masks[0].image, "");
    EXPECT_FALSE(collect_files(document, assets, folder).command);
    fs::remove(disk.file("one/hills.png"));
    EXPECT_THROW(collect_files(with_pictures("../one/hills.png", "../two/spots.png"), assets,
                               disk.file("scene/b.assets")),
                 Rejected);
}

TEST(Relink, RefusesPicturesThatNobodyUses)
{
    const Document document = with_pictures("hills.png", "spots.png");
    const auto refused = [&](const RelinkedPicture& picture) -> std::string {
        try {
            after(document, Relink{.objects = {}, .files = {}, .pictures = {picture}});
        } catch (const Rejected& why) {
            return why.what();
        }
        return {};
    };
    EXPECT_EQ(refused({1, 0, "other.png", {}}), "");
    EXPECT_EQ(refused({3, 2, "other.png", {}}), "");
    EXPECT_THAT(refused({3, 1, "other.png", {}}), HasSubstr("no mask 1 by a picture"));
    EXPECT_THAT(refused({3, 3, "other.png", {}}), HasSubstr("no mask 3 by a picture"));
    EXPECT_THAT(refused({2, 0, "other.png", {}}), HasSubstr("no sheet of heights"));
    EXPECT_THAT(refused({1, 0, "", {}}), HasSubstr("names no picture"));
    EXPECT_THAT(refused({7, 0, "other.png", {}}), HasSubstr("7"));
}

TEST(Collect, NeverWritesOverAnotherContentAndReusesAnEqualOne)
{
    const TemporaryFolder disk;
    const fs::path folder = disk.file("scene/a.assets");
    write_file(disk.file("one/rock.obj"), rock);
    write_file(disk.file("two/rock.obj"), rock + "# other\n");
    write_file(folder / "rock.obj", rock + "# of somebody else\n");
    const AssetStore assets(disk.file("scene"));
    const Document document = with_imports({"../one/rock.obj", "../two/rock.obj"});
    const Collection done = collect_files(document, assets, folder.string());
    EXPECT_THAT(all_in(folder), ElementsAre("rock.obj", "rock/rock.obj", "rock_2/rock.obj"));
    EXPECT_EQ(read_text_file((folder / "rock.obj").string()), rock + "# of somebody else\n");
    const Collection again = collect_files(document, assets, folder.string());
    EXPECT_EQ(again.copied, 0u);
    EXPECT_EQ(again.reused, 2u);
    EXPECT_EQ(again.command, done.command);
}

TEST(Collect, LeavesNothingBehindWhereAFileIsMissingOrTheDiskIsFull)
{
    const TemporaryFolder disk;
    write_file(disk.file("one/a.obj"), rock);
    write_file(disk.file("one/b.obj"), rock + std::string(100'000, '#') + "\n");
    fs::create_directories(disk.file("scene"));
    const std::string folder = disk.file("scene/a.assets");
    const AssetStore assets(disk.file("scene"));
    const auto why_not = [&](const Document& document) -> std::string {
        try {
            collect_files(document, assets, folder);
        } catch (const Rejected& why) {
            return why.what();
        }
        return "";
    };
    EXPECT_THAT(why_not(with_imports({"../one/a.obj", "../one/c.obj"})), HasSubstr("is missing"));
    {
        const FullDisk full(5000);
        EXPECT_THAT(why_not(with_imports({"../one/a.obj", "../one/b.obj"})),
                    HasSubstr("b.obj: cannot be copied"));
    }
    EXPECT_FALSE(fs::exists(folder));
}

std::string volume_path(const Document& document, Id id)
{
    return std::get<VoxelShape>(object(document, id).source).path;
}

TEST(Collect, TakesAllFilesOfVolumeData)
{
    const TemporaryFolder disk;
    const std::string folder = disk.file("scene/a.assets");
    write_file(disk.file("one/head.mhd"), "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\n"
                                          "ElementType = MET_UCHAR\n"
                                          "ElementDataFile = head.raw\n");
    write_file(disk.file("one/head.raw"), "01234567");
    const AssetStore assets(disk.file("scene"));
    Document document =
        after(after({}, AddVoxels{.shape = {.path = "../one/head.mhd", .levels = {{.value = 50}}}}),
              AddVoxels{.shape = {.path = "../one/head.mhd"}});
    const Collection done = collect_files(document, assets, folder);
    EXPECT_THAT(all_in(folder), ElementsAre("head/head.mhd", "head/head.raw"));
    document = after(document, *done.command);
    for (const Id id : {1, 2}) EXPECT_EQ(volume_path(document, id), "a.assets/head/head.mhd");
    EXPECT_TRUE(assets.load_volume(volume_path(document, 1), {}).grid);
    EXPECT_FALSE(collect_files(document, assets, folder).command) << "nothing is left to do";
}

TEST(Collect, TakesFoldersOfSlices)
{
    const TemporaryFolder disk;
    const std::string folder = disk.file("scene/a.assets");
    for (const char* slice : {"s1.png", "s2.png"}) {
        Image image;
        image.size_px = {2, 2};
        image.rgba.assign(16, 200);
        fs::create_directories(disk.file("two"));
        write_image(image, disk.file(std::string("two/") + slice));
    }
    write_file(disk.file("two/about.txt"), "no slice");
    write_file(disk.file("scene/a.assets/two/s3.png"), "a slice of other data");
    const AssetStore assets(disk.file("scene"));
    Document document = after({}, AddVoxels{.shape = {.path = "../two"}});
    const Collection done = collect_files(document, assets, folder);
    EXPECT_EQ(done.copied, 2u);
    document = after(document, *done.command);
    EXPECT_EQ(volume_path(document, 1), "a.assets/two_2") << "no slices of other data are in it";
    EXPECT_EQ(assets.load_volume("a.assets/two_2", {}).hash, assets.load_volume("../two", {}).hash);
}

} // namespace
} // namespace trivar
