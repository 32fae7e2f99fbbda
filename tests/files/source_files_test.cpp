// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/files/source_files.h"

#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/files/read_model.h"
#include "core/files/write_model.h"
#include "core/mesh/primitives.h"
#include "tests/support/fixtures.h"

#include <filesystem>
#include <gmock/gmock.h>
#include <limits>

namespace trivar {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr, ::testing::ThrowsMessage;

TEST(SourceFiles, AreKnownByWhateverNameLeadsToThem)
{
    const testing::TemporaryFolder folder;
    testing::write_file(folder.file("in/model.obj"), "v");
    testing::write_file(folder.file("copy.obj"), "v");
    fs::create_symlink("in/model.obj", folder.file("link.obj"));
    fs::create_symlink("in", folder.file("other folder"));
    fs::create_hard_link(folder.file("in/model.obj"), folder.file("second.obj"));
    SourceFiles sources("or say so");
    sources.add(folder.file("link.obj"));
    sources.add(folder.file("missing.obj"));
    for (const char* name : {"in/model.obj", "link.obj", "second.obj", "other folder/model.obj",
                             "other folder/../in/model.obj"})
        EXPECT_THAT([&] { sources.check(folder.file(name)); },
                    ThrowsMessage<Rejected>(HasSubstr("choose another name, or say so")))
            << name;
    for (const char* name : {"copy.obj", "missing.obj", "new.obj"})
        EXPECT_NO_THROW(sources.check(folder.file(name))) << name;
}

class WrittenModels : public ::testing::Test {
protected:
    Model ball() const
    {
        Model model = single_mesh_model("ball", sphere_mesh(1, 8, 4));
        Image picture;
        picture.size_px = {2, 2};
        picture.rgba.assign(16, 255);
        model.materials.front().base_color_texture.image = make_ref(picture);
        return model;
    }
    std::size_t files() const
    {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()));
    }
    testing::TemporaryFolder folder;
};

TEST_F(WrittenModels, TakeThePlaceOfASourceWithNoneOfTheirFiles)
{
    for (const char* name : {"a.obj", "a.mtl", "a_0.png"}) {
        const testing::TemporaryFolder own;
        testing::write_file(own.file(name), "source");
        SourceFiles sources;
        sources.add(own.file(name));
        EXPECT_THAT([&] { write_model(ball(), own.file("a.obj"), sources); },
                    ThrowsMessage<Rejected>(HasSubstr(std::string(name) + ": the scene uses")));
        EXPECT_EQ(read_text_file(own.file(name)), "source");
        EXPECT_EQ(std::distance(fs::directory_iterator(own.path()), fs::directory_iterator()), 1);
    }
}

TEST_F(WrittenModels, WithBlanksInTheirNameNameTheirMaterialsAsTheyAreWritten)
{
    write_model(ball(), folder.file("a red ball.obj"));
    const Model back = read_model(folder.file("a red ball.obj"));
    EXPECT_TRUE(back.materials.front().base_color_texture.image);
}

TEST_F(WrittenModels, HaveFacesAndNumbersThatCanBeRead)
{
    Model far = ball(), bright = ball(), none = ball();
    far.nodes.front().to_parent[0][0] = 1e300;
    none.nodes.front().mesh = -1;
    for (const char* name : {"a.glb", "a.obj", "a.ply", "a.stl", "a.off"}) {
        EXPECT_THAT([&] { write_model(far, folder.file(name)); },
                    ThrowsMessage<Rejected>(HasSubstr("too large (beyond 1e15 m")));
        EXPECT_THAT([&] { write_model(none, folder.file(name)); },
                    ThrowsMessage<Rejected>(HasSubstr("there are no faces to write")));
    }
    bright.materials.front().emissive.x = std::numeric_limits<float>::infinity();
    for (const char* name : {"a.glb", "a.obj"})
        EXPECT_THAT([&] { write_model(bright, folder.file(name)); },
                    ThrowsMessage<Rejected>(HasSubstr("has a number that is not finite")));
    EXPECT_EQ(files(), 0u);
}

} // namespace
} // namespace trivar
