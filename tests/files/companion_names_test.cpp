// SPDX-License-Identifier: GPL-3.0-or-later
// What a model names, its reader and companions_of find alike.
#include "core/files/companions.h"
#include "core/files/file_bytes.h"
#include "core/files/folder_files.h"
#include "core/files/gltf/glb_chunks.h"
#include "core/files/pictures/image.h"
#include "tests/files/sample_models.h"
#include "tests/files/text_models.h"
#include "tests/support/fixtures.h"

#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// A folder with a picture in it, and a model whose files name it.
struct NamedPicture {
    TemporaryFolder folder;

    explicit NamedPicture(const std::string& file)
    {
        write_file(folder.file(file), encoded_image(checker_image(), ".png"));
    }
    std::string obj(const std::string& map_line)
    {
        write_file(folder.file("m.mtl"), "newmtl a\n" + map_line + "\n");
        write_file(folder.file("m.obj"), "mtllib m.mtl\nusemtl a\n" + obj_text(square_model()));
        return folder.file("m.obj");
    }
    std::string gltf(const std::string& uri)
    {
        const std::string positions = "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
        write_file(folder.file("m.gltf"),
                   R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
                   R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],)"
                   R"("materials":[{"normalTexture":{"index":0}}],"textures":[{"source":0}],)"
                   R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
                   R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,)"
                   R"("uri":"data:application/octet-stream;base64,)" +
                       positions + R"("}],"images":[{"uri":")" + uri + R"("}]})");
        return folder.file("m.gltf");
    }
};

// The picture's name as written in an OBJ's and in a glTF's file, and the file it means.
struct Spelling {
    const char *line, *uri, *file;
};

class PictureNames : public ::testing::TestWithParam<Spelling> {};

TEST_P(PictureNames, AreFoundByTheReaderAndAmongTheCompanionsAlike)
{
    const auto [line, uri, file] = GetParam();
    NamedPicture disk(file);
    const std::string obj = disk.obj(std::string("map_Kd ") + line);
    EXPECT_TRUE(read_model(obj).materials.at(0).base_color_texture.image) << line;
    EXPECT_THAT(companions_of(obj), ::testing::UnorderedElementsAre("m.mtl", file)) << line;
    const std::string gltf = disk.gltf(uri);
    EXPECT_TRUE(read_model(gltf).materials.at(0).normal_texture.image) << uri;
    EXPECT_THAT(companions_of(gltf), ElementsAre(file)) << uri;
    for (const std::string& each : companions_of(gltf))
        EXPECT_NO_THROW(file_hash(disk.folder.file(each)));
}
INSTANTIATE_TEST_SUITE_P(
    Spellings, PictureNames,
    ::testing::Values(Spelling{"t.png", "t.png", "t.png"},
                      Spelling{".\\t.png", ".\\\\t.png", "t.png"},
                      Spelling{"./maps//t.png", "./maps//t.png", "maps/t.png"},
                      Spelling{"maps\\in\\t.png", "maps\\\\in\\\\t.png", "maps/in/t.png"},
                      Spelling{"  a grey  stone.png \t", "a%20grey%20%20stone.png",
                               "a grey  stone.png"},
                      Spelling{"\"a stone.png\"", "a stone.png", "a stone.png"},
                      Spelling{"a%20stone.png", "a%20stone.png", "a stone.png"},
                      Spelling{"Maps\\T.PNG", "Maps\\\\T.PNG", "maps/t.png"},
                      Spelling{"maps/../t.png", "maps/../t.png", "t.png"}));

TEST(FolderFiles, TakesOtherCapitalsOnlyWhereOneFileAloneIsCalledSo)
{
    const TemporaryFolder folder;
    write_file(folder.file("Stone.png"), "1");
    FolderFiles one(folder.path().string());
    EXPECT_TRUE(one.find("Stone.png") && !one.find("Stone.png")->in_other_case);
    EXPECT_TRUE(one.find("stone.PNG") && one.find("stone.PNG")->in_other_case);
    write_file(folder.file("stone.png"), "2");
    FolderFiles two(folder.path().string());
    EXPECT_EQ(two.find("stone.png")->name, "stone.png");
    EXPECT_FALSE(two.find("STONE.png"));
}

TEST(FolderFiles, FindsNothingOutsideTheFolder)
{
    const TemporaryFolder disk;
    write_file(disk.file("secret.png"), "s");
    write_file(disk.file("in/side.png"), "s");
    std::filesystem::create_symlink("../secret.png", disk.path() / "in" / "link.png");
    FolderFiles files(disk.file("in"));
    EXPECT_TRUE(files.find("side.png"));
    for (const std::string& name :
         {std::string("../secret.png"), std::string("..\\secret.png"),
          std::string("x/../../secret.png"), std::string("%2e%2e/secret.png"),
          std::string("link.png"), std::string("LINK.png"), disk.file("secret.png"),
          "file://" + disk.file("in/side.png"), std::string("."), std::string(),
          std::string("side.png\0x", 10), std::string(100000, 'a')})
        EXPECT_FALSE(files.find(name)) << name.substr(0, 100);
    EXPECT_FALSE(FolderFiles("").find("side.png"));
    EXPECT_FALSE(FolderFiles(disk.file("none")).find("side.png"));
}

TEST(Libraries, AreOneWithBlanksOrSeveralOnALine)
{
    const TemporaryFolder folder;
    for (const char* name : {"a.mtl", "b.mtl", "my own.mtl", "shared"})
        write_file(folder.file(name), "newmtl " + std::string(name) + "\n");
    const auto read = [&](const std::string& line) {
        const std::string path = folder.file("m.obj");
        write_file(path, line + "\n" + obj_text(square_model()));
        const Model model = read_model(path);
        EXPECT_TRUE(model.notices.empty()) << model.notices[0];
        std::vector<std::string> names;
        for (const Material& material : model.materials)
            if (!material.name.empty()) names.push_back(material.name);
        return std::pair(names, companions_of(path));
    };
    using Names = std::vector<std::string>;
    EXPECT_EQ(read("mtllib b.mtl a.mtl"),
              std::pair(Names({"b.mtl", "a.mtl"}), Names({"a.mtl", "b.mtl"})));
    EXPECT_EQ(read("mtllib my own.mtl"), std::pair(Names({"my own.mtl"}), Names({"my own.mtl"})));
    EXPECT_EQ(read("mtllib my own.mtl b.mtl"),
              std::pair(Names({"my own.mtl", "b.mtl"}), Names({"b.mtl", "my own.mtl"})));
    EXPECT_EQ(read("mtllib shared a.mtl"),
              std::pair(Names({"shared", "a.mtl"}), Names({"a.mtl", "shared"})));
    EXPECT_EQ(read("mtllib a.mtl \\\r\n b.mtl"),
              std::pair(Names({"a.mtl", "b.mtl"}), Names({"a.mtl", "b.mtl"})));
}

TEST(Libraries, ThatAreMissingAreSaidOnceWithTheirNumber)
{
    const TemporaryFolder folder;
    const Model model =
        read_model_bytes("mtllib a b.mtl c.mtl\nmtllib c.mtl\n" + obj_text(square_model()), "m.obj",
                         folder.path().string());
    EXPECT_THAT(
        model.notices,
        ElementsAre("m.obj: 2 material libraries are not in its folder: a b.mtl and c.mtl"));
}

// Longer than a library may be, which is as good as one that the system does not let us read.
TEST(Libraries, ThatCannotBeReadLeaveTheModel)
{
    const TemporaryFolder folder;
    write_file(folder.file("big.mtl"), "");
    std::filesystem::resize_file(folder.file("big.mtl"), 65 << 20);
    write_file(folder.file("wide.mtl"), std::string("n\0e\0w\0m\0", 8));
    std::filesystem::create_directory(folder.path() / "dir.mtl");
    write_file(folder.file("m.obj"),
               "mtllib big.mtl wide.mtl dir.mtl\n" + obj_text(square_model()));
    const Model model = read_model(folder.file("m.obj"));
    EXPECT_THAT(
        model.notices,
        ElementsAre(HasSubstr("more than the 67,108,864 allowed; its materials were left out"),
                    HasSubstr("save it as UTF-8; its materials were left out"),
                    "m.obj: 1 material library is not in its folder: dir.mtl"));
    EXPECT_THAT(companions_of(folder.file("m.obj")), ElementsAre("big.mtl", "wide.mtl"));
}

TEST(Companions, OfAGlbAreThePicturesBesideIt)
{
    NamedPicture disk("t.png");
    const std::string glb =
        glb_container({R"({"images":[{"uri":".\\t.png"},{"uri":"gone.png"}]})", ""});
    write_file(disk.folder.file("m.glb"), glb);
    EXPECT_THAT(companions_of(disk.folder.file("m.glb")), ElementsAre("t.png"));
    write_file(disk.folder.file("m.glb"), glb.substr(0, 30));
    EXPECT_THAT(companions_of(disk.folder.file("m.glb")), IsEmpty());
}

} // namespace
} // namespace trivar
