// SPDX-License-Identifier: GPL-3.0-or-later
// What goes with a model never costs a scene the model.
#include "core/commands/collect.h"
#include "core/document/asset_store.h"
#include "core/files/pictures/image.h"
#include "tests/support/fixtures.h"

#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace trivar {
namespace {

using namespace testing;
using ::testing::HasSubstr;

namespace fs = std::filesystem;

// A model whose material library and picture are named as another system does.
struct ForeignModel {
    TemporaryFolder folder;

    ForeignModel()
    {
        Image image;
        image.size_px = {1, 1};
        image.rgba = {1, 2, 3, 255};
        write_file(folder.file("one/maps/grey stone.png"), encoded_image(image, ".png"));
        write_file(folder.file("one/rock.mtl"),
                   "newmtl a\nmap_Kd -s 1 1 1 .\\Maps\\grey stone.PNG\n");
        write_file(folder.file("one/rock.obj"),
                   "mtllib .\\rock.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n");
    }
    static AssetStore::LoadedModel load(const fs::path& path)
    {
        ImportedFile file;
        file.path = path.filename().string();
        return AssetStore(path.parent_path().string()).load(file);
    }
    static bool textured(const AssetStore::LoadedModel& loaded)
    {
        return loaded.model && loaded.model->materials.at(0).base_color_texture.image;
    }
};

TEST(CompanionsInScenes, AreFoundThroughNamesOfOtherSystems)
{
    const ForeignModel disk;
    const AssetStore::LoadedModel loaded = disk.load(disk.folder.file("one/rock.obj"));
    EXPECT_TRUE(disk.textured(loaded));
    write_file(disk.folder.file("one/maps/grey stone.png"), "another picture");
    EXPECT_NE(disk.load(disk.folder.file("one/rock.obj")).content, loaded.content);
}

TEST(CompanionsInScenes, AreCollectedToWhereTheirNamesFindThemAgain)
{
    const ForeignModel disk;
    ImportModel import;
    import.file.path = "../one/rock.obj";
    const Document document = after(Document(), import);
    const AssetStore assets(disk.folder.file("scene"));
    EXPECT_EQ(collect_files(document, assets, disk.folder.file("scene/kept")).copied, 3u);
    EXPECT_TRUE(disk.textured(disk.load(disk.folder.file("scene/kept/rock/rock.obj"))));
}

// Whoever is root may read everything, so the model is read as somebody else then.
class AsNobody {
public:
    AsNobody() { switched_ = ::geteuid() == 0 && ::seteuid(65534) == 0; }
    ~AsNobody()
    {
        if (switched_ && ::seteuid(0) != 0) ADD_FAILURE() << "root is gone";
    }

private:
    bool switched_;
};

TEST(CompanionsInScenes, LeaveTheModelWhereTheyCannotBeRead)
{
    for (const char* name : {"one/rock.mtl", "one/maps/grey stone.png"}) {
        const ForeignModel disk;
        for (const char* open : {"", "one", "one/maps"})
            fs::permissions(disk.folder.path() / open, fs::perms(0755));
        fs::permissions(disk.folder.file(name), fs::perms::none);
        AssetStore::LoadedModel loaded;
        {
            const AsNobody nobody;
            loaded = disk.load(disk.folder.file("one/rock.obj"));
        }
        ASSERT_TRUE(loaded.model) << name;
        EXPECT_FALSE(disk.textured(loaded));
        EXPECT_THAT(loaded.notices.front(), HasSubstr("cannot be opened (Permission denied)"));
    }
}

} // namespace
} // namespace trivar
