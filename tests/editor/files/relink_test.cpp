// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/commands/tiles/heights.h"
#include "core/commands/tiles/mask_tiles.h"
#include "editor/files/relink.h"

#include "core/files/pictures/image.h"
#include "tests/editor/notice_buttons.h"
#include "tests/editor/volume_rig.h"
#include "tests/support/fixtures.h"

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>

namespace trivar {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre, ::testing::IsEmpty;
using testing::Rig, testing::TemporaryFolder;

void write_triangle(const std::string& path, double width)
{
    std::ofstream(path) << "v 0 0 0\nv " << width << " 0 0\nv 0 1 0\nf 1 2 3\n";
}

// Two models, one of them twice.
struct ThreeImports : Rig {
    TemporaryFolder folder;
    ThreeImports()
    {
        for (const char* name : {"a.obj", "b.obj"}) write_triangle(folder.file(name), 1);
        for (const char* name : {"a.obj", "b.obj", "a.obj"}) {
            editor.files.import(folder.file(name));
            wait();
        }
    }
    bool has_shape(Id id) { return !editor.session.evaluated().objects.at(id)->parts.empty(); }
};

TEST(Relink, FindsWhatIsMissingBesideTheFileThatWasShown)
{
    ThreeImports rig;
    Session& session = rig.editor.session;
    EXPECT_THAT(missing_files(session), IsEmpty());
    fs::create_directory(rig.folder.file("moved"));
    for (const char* name : {"a.obj", "b.obj"})
        fs::rename(rig.folder.file(name), rig.folder.file(std::string("moved/") + name));
    EXPECT_THAT(missing_files(session), ElementsAre(1, 2, 3));
    relink(session, 1, rig.folder.file("moved/a.obj"));
    rig.wait();
    EXPECT_THAT(missing_files(session), IsEmpty());
    EXPECT_EQ(rig.steps(), 6u);
    for (const Id id : {1, 2, 3}) EXPECT_TRUE(rig.has_shape(id));
}

TEST(Relink, IsOfferedInTheNoticeOfWhatCannotBeShown)
{
    for (const bool by_notice : {true, false}) {
        const TemporaryFolder folder;
        const std::string scene = folder.file("a.trivar");
        std::ofstream(scene) << "{\"trivar\": 1, \"units\": \"m\", \"up\": \"z\"}\n"
                             << "{\"do\": \"import\", \"path\": \"a.obj\", \"name\": \"A\"}\n";
        Rig rig;
        Session& session = rig.editor.session;
        rig.editor.files.open_scene(scene);
        rig.wait();
        ASSERT_THAT(session.not_shown(), ElementsAre(1));
        testing::press_button(rig.editor, "Find...");
        EXPECT_TRUE(rig.editor.files.asking());
        rig.key({ui::key_escape});
        write_triangle(folder.file("a.obj"), 1);
        if (by_notice)
            testing::press_button(rig.editor, "Reload");
        else
            rig.editor.files.ask_missing(); // reads it instead of saying that nothing is missing
        rig.wait();
        EXPECT_THAT(session.not_shown(), IsEmpty());
        const auto offers = [](const ui::Notices::Notice& each) { return !each.actions.empty(); };
        EXPECT_TRUE(std::ranges::none_of(session.notices.all(), offers)) << "it is told no more";
    }
}

TEST(Relink, RefusesWhatCannotBeRead)
{
    ThreeImports rig;
    std::ofstream(rig.folder.file("c.obj")) << "f 1 2 3\n";
    relink(rig.editor.session, 2, rig.folder.file("c.obj"));
    rig.wait();
    EXPECT_EQ(rig.steps(), 3u);
    ASSERT_FALSE(rig.editor.session.notices.all().empty());
}

TEST(Relink, TakesTheChosenFileWhereItsNeighbourCannotBeRead)
{
    ThreeImports rig;
    fs::create_directory(rig.folder.file("moved"));
    fs::rename(rig.folder.file("a.obj"), rig.folder.file("moved/a.obj"));
    fs::remove(rig.folder.file("b.obj"));
    std::ofstream(rig.folder.file("moved/b.obj")) << "f 1 2 3\n";
    const std::size_t said = rig.editor.session.notices.all().size();
    relink(rig.editor.session, 1, rig.folder.file("moved/a.obj"));
    rig.wait();
    EXPECT_THAT(missing_files(rig.editor.session), ElementsAre(2));
    EXPECT_EQ(rig.editor.session.notices.all().size(), said + 1);
}

TEST(Relink, LeavesAnotherSceneAlone)
{
    ThreeImports rig;
    read_anew(rig.editor.session, {1, 2, 3});
    rig.editor.session.replace_scene(SceneFile());
    rig.wait();
    EXPECT_EQ(rig.steps(), 0u);
}

void write_grey(const std::string& path, std::uint16_t grey)
{
    const DeepImage image{{1, 1}, {grey, grey, grey, 65535}};
    testing::write_file(path, encoded_image(image, ".png"));
}

// A plane that is displaced by one picture, and in its layer a mask by another.
struct DisplacedRig : Rig {
    TemporaryFolder folder;
    static constexpr Id sheet = 2;
    DisplacedRig()
    {
        write_grey(folder.file("hills.png"), 32768);
        write_grey(folder.file("spots.png"), 65535);
        EXPECT_TRUE(editor.session.run(AddPlane{}));
        EXPECT_TRUE(editor.session.run(
            Displace{.base = 1, .shape = {.image = folder.file("hills.png"), .segments = 2}}));
        TileMask mask;
        mask.from = MaskFrom::image;
        mask.image = folder.file("spots.png");
        EXPECT_TRUE(editor.session.run(MaskTiles{sheet, 0, mask}));
        wait();
    }
    float height() { return editor.session.evaluated().objects.at(sheet)->bounds->hi.z; }
};

TEST(Relink, FindsPicturesOfMasksAndHeights)
{
    DisplacedRig rig;
    Session& session = rig.editor.session;
    EXPECT_THAT(missing_files(session), IsEmpty());
    EXPECT_EQ(kind_to_relink(session, DisplacedRig::sheet), FileKind::image);
    fs::create_directory(rig.folder.file("moved"));
    for (const char* name : {"hills.png", "spots.png"})
        fs::rename(rig.folder.file(name), rig.folder.file(std::string("moved/") + name));
    session.assets()->forget(rig.folder.file("hills.png"));
    EXPECT_THAT(missing_files(session), ElementsAre(DisplacedRig::sheet));
    relink(session, DisplacedRig::sheet, rig.folder.file("moved/hills.png"));
    rig.wait();
    EXPECT_THAT(missing_files(session), IsEmpty());
    const Object& layer = object(session.committed(), DisplacedRig::sheet);
    EXPECT_EQ(fs::path(std::get<HeightShape>(layer.source).image).filename(), "hills.png");
    EXPECT_EQ(fs::path(layer.tiles->masks[0].image).filename(), "spots.png");
    EXPECT_EQ(rig.steps(), 5u); // one each
}

TEST(Relink, ReadsPicturesAnewThatHaveChanged)
{
    DisplacedRig rig;
    const float before = rig.height();
    write_grey(rig.folder.file("hills.png"), 65535);
    read_anew(rig.editor.session, {DisplacedRig::sheet});
    rig.wait();
    EXPECT_GT(rig.height(), 1.9f * before);
    EXPECT_THAT(rig.editor.session.evaluated().objects.at(DisplacedRig::sheet)->notices, IsEmpty());
}

TEST(Relink, ReadsAFileAnewThatHasChanged)
{
    ThreeImports rig;
    write_triangle(rig.folder.file("b.obj"), 5);
    read_anew(rig.editor.session, {2});
    rig.wait();
    EXPECT_EQ(rig.steps(), 4u);
    const EvaluatedObject& object = *rig.editor.session.evaluated().objects.at(2);
    EXPECT_THAT(object.notices, IsEmpty());
    EXPECT_EQ(object.parts.at(0).mesh()->positions.at(1).x, 5);
}

TEST(Relink, FindsVolumeDataAndFoldersOfSlices)
{
    testing::VolumeRig rig;
    Session& session = rig.editor.session;
    rig.add_ball({50});
    testing::write_slices(rig.folder.file("head"));
    AddVoxels head;
    head.shape.path = rig.folder.file("head");
    ASSERT_TRUE(session.run(prepare(head, *session.assets())));
    rig.wait();
    fs::create_directory(rig.folder.file("moved"));
    for (const char* name : {"ball.nrrd", "head"})
        fs::rename(rig.folder.file(name), rig.folder.file(std::string("moved/") + name));
    EXPECT_THAT(missing_files(session), ElementsAre(1, 2));
    EXPECT_EQ(kind_to_relink(session, 2), FileKind::volume);
    relink(session, 2, rig.folder.file("moved/head"));
    rig.wait();
    EXPECT_THAT(missing_files(session), IsEmpty());
    for (const Id id : {1, 2})
        EXPECT_TRUE(session.evaluated().objects.at(id)->shape->volume) << "it was read there";
}

} // namespace
} // namespace trivar
