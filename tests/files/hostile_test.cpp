// SPDX-License-Identifier: GPL-3.0-or-later
// Files that nobody should believe: a sentence or a stated repair, never a crash, hang or a memory
// that the bytes do not account for.
#include "core/base/rejected.h"
#include "core/files/pictures/image.h"
#include "core/files/read_model.h"
#include "tests/files/sample_models.h"
#include "tests/support/fixtures.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace trivar {
namespace {

using namespace testing;
using ::testing::HasSubstr;

std::string one_triangle(const std::string& extension)
{
    Mesh mesh = plane_mesh({1, 1}, {1, 1});
    return bytes_of(single_mesh_model("t", std::move(mesh)), extension);
}

// Empty where the file was read.
std::string refusal(const std::string& bytes, const std::string& name)
{
    try {
        const Model model = read_model_bytes(bytes, name, "");
        for (const Ref<Mesh>& mesh : model.meshes) validate(*mesh, name);
        return "";
    } catch (const Rejected& rejected) {
        std::string sentence = rejected.what();
        EXPECT_EQ(sentence.find('\n'), sentence.npos) << sentence;
        EXPECT_THAT(sentence, HasSubstr(name));
        return sentence;
    }
}

std::vector<std::string> notices(const std::string& bytes, const std::string& name)
{
    return read_model_bytes(bytes, name, "").notices;
}

void put32(std::string& bytes, std::size_t at, std::uint32_t value)
{
    std::memcpy(bytes.data() + at, &value, 4);
}

std::string gltf(const std::string& rest)
{
    return R"({"asset":{"version":"2.0"},)" + rest + "}";
}

class HostileFormats : public ::testing::TestWithParam<const char*> {};

TEST_P(HostileFormats, AreReadOrRefusedWhereverTheyAreCutOff)
{
    const std::string name = std::string("cut") + GetParam(), whole = one_triangle(GetParam());
    EXPECT_EQ(refusal(whole, name), "");
    for (std::size_t length = 0; length < whole.size(); ++length)
        refusal(whole.substr(0, length), name);
}

TEST_P(HostileFormats, AreReadOrRefusedWithAnyByteChanged)
{
    const std::string name = std::string("bent") + GetParam(), whole = one_triangle(GetParam());
    for (std::size_t at = 0; at < whole.size(); ++at)
        for (const unsigned change : {0x01u, 0x80u, 0xffu}) {
            std::string bent = whole;
            bent[at] = static_cast<char>(static_cast<unsigned char>(bent[at]) ^ change);
            refusal(bent, name);
        }
}

TEST_P(HostileFormats, SayThatAnEmptyFileIsEmpty)
{
    EXPECT_THAT(refusal("", std::string("nothing") + GetParam()), HasSubstr("empty"));
}
INSTANTIATE_TEST_SUITE_P(Formats, HostileFormats,
                         ::testing::Values(".obj", ".ply", ".stl", ".off", ".glb"));

TEST(HostileObj, IsRefusedWithTheLineThatIsWrong)
{
    EXPECT_THAT(refusal("v 0 0 0\nv nan 0 0\n", "a.obj"), HasSubstr("line 2"));
    EXPECT_THAT(refusal("v 0 0 0\nv 1 0\n", "a.obj"), HasSubstr("line 2"));
    EXPECT_THAT(refusal("v 0 0 0\n\n# x\nf 1 a 1\n", "a.obj"), HasSubstr("line 4"));
    EXPECT_THAT(refusal("v 0 0 0\nf 0 1 1\n", "a.obj"), HasSubstr("counted from 1"));
    EXPECT_THAT(refusal("v 1e999 0 0\n", "a.obj"), HasSubstr("line 1"));
}

TEST(HostileObj, MayNotAskForWhatIsNotThere)
{
    const std::string three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    for (const char* face : {"f 1 2 4", "f -1 -2 -4", "f 999999999 1 2", "f -999999999 1 2",
                             "f 99999999999999999999 1 2"})
        EXPECT_NE(refusal(three + face, "a.obj"), "") << face;
    EXPECT_EQ(refusal(three + "f -1 -2 -3", "a.obj"), "");
}

TEST(HostileObj, ReadsNothingOutsideItsFolder)
{
    const TemporaryFolder folder;
    write_image(checker_image(), folder.file("secret.png"));
    std::filesystem::create_directory(folder.path() / "inner");
    std::filesystem::create_symlink(folder.path() / "secret.png",
                                    folder.path() / "inner" / "link.png");
    for (const std::string& name :
         {std::string("../secret.png"), std::string("link.png"), folder.file("secret.png")}) {
        const std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nmtllib " + name + "\nf 1 2 3\n";
        const Model model = read_model_bytes(text, "a.obj", (folder.path() / "inner").string());
        ASSERT_EQ(model.notices.size(), 1u) << name;
        EXPECT_THAT(model.notices[0], HasSubstr("not in its folder"));
    }
}

TEST(HostilePly, DeclaresMoreThanItHolds)
{
    const std::string vertices = "property float x\nproperty float y\nproperty float z\n";
    for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"})
        EXPECT_THAT(refusal(std::string("ply\nformat ") + format +
                                " 1.0\nelement vertex 900000000\n" + vertices + "end_header\n",
                            "a.ply"),
                    HasSubstr("more than"));
    const std::string list = "element face 1\nproperty list uint int vertex_indices\nend_header\n";
    const std::string head =
        "ply\nformat binary_little_endian 1.0\nelement vertex 1\n" + vertices + list;
    EXPECT_THAT(refusal(head + std::string(12, '\0') + "\xff\xff\xff\xff" + "1234", "a.ply"),
                HasSubstr("length of a list"));
    EXPECT_THAT(refusal("ply\nformat ascii 1.0\nelement vertex 9999999999\n", "a.ply"),
                HasSubstr("line 3"));
}

TEST(HostilePly, IsRefusedInAWholeSentenceWhateverItsHeaderHolds)
{
    std::string text = "ply\nformat ascii 1.0\n";
    text += '\0';
    text += "\x1b[2Jx 1\n";
    EXPECT_THAT(refusal(text, "a.ply"), HasSubstr("'??[2Jx' does not belong in a PLY header"));
}

TEST(HostileStl, DeclaresMoreTrianglesThanItHolds)
{
    std::string bytes = one_triangle(".stl");
    put32(bytes, 80, 0xffffffffu);
    EXPECT_NE(refusal(bytes, "a.stl"), "");
    EXPECT_NE(refusal("solid x\nfacet\nvertex 0 0 0\nvertex 1 0 0\nendfacet", "a.stl"), "");
    EXPECT_NE(refusal("solid x\nfacet\nvertex 0 0 inf\n", "a.stl"), "");
}

TEST(HostileOff, DeclaresMoreThanItHolds)
{
    EXPECT_NE(refusal("OFF\n353535235358 6 0\n", "a.off"), "");
    EXPECT_NE(refusal("OFF\n900000000 6 0\n", "a.off"), "");
    EXPECT_NE(refusal("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n900000000 0 1 2\n", "a.off"), "");
    EXPECT_NE(refusal("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "a.off"), "");
    EXPECT_NE(refusal("OFF BINARY\n3 1 0\n", "a.off"), "");
}

TEST(HostileGltf, IsRefusedByNameForWhatIsNotSupported)
{
    EXPECT_THAT(refusal(gltf(R"("extensionsRequired":["KHR_draco_mesh_compression"])"), "a.gltf"),
                HasSubstr("KHR_draco_mesh_compression"));
    EXPECT_THAT(refusal(R"({"asset":{"version":"1.0"}})", "a.gltf"), HasSubstr("glTF 2"));
    EXPECT_THAT(refusal("not json", "a.gltf"), HasSubstr("damaged"));
}

TEST(HostileGltf, MayNotNestWithoutEnd)
{
    const std::string deep = std::string(100000, '[') + std::string(100000, ']');
    EXPECT_THAT(refusal(gltf("\"extras\":" + deep), "a.gltf"), HasSubstr("nested"));
}

TEST(HostileGltf, HasNodesInATree)
{
    EXPECT_THAT(refusal(gltf(R"("nodes":[{"children":[1]},{"children":[0]}],)"
                             R"("scenes":[{"nodes":[0]}])"),
                        "a.gltf"),
                HasSubstr("ancestor"));
    EXPECT_THAT(refusal(gltf(R"("nodes":[{"children":[7]}],"scenes":[{"nodes":[0]}])"), "a.gltf"),
                HasSubstr("not there"));
    EXPECT_NE(refusal(gltf(R"("nodes":[{"mesh":3}],"scenes":[{"nodes":[0]}])"), "a.gltf"), "");
    // A chain of a hundred thousand would end a recursive reader.
    std::string chain = R"("nodes":[)";
    for (int i = 1; i < 100000; ++i) chain += R"({"children":[)" + std::to_string(i) + "]},";
    EXPECT_THAT(refusal(gltf(chain + R"({}],"scenes":[{"nodes":[0]}])"), "a.gltf"),
                HasSubstr("no faces"));
}

TEST(HostileGltf, ReadsNoFileOutsideItsFolder)
{
    for (const char* uri : {"/etc/passwd", "../../etc/passwd", "file:///etc/passwd"})
        EXPECT_NE(
            refusal(gltf(R"("buffers":[{"byteLength":10,"uri":")" + std::string(uri) + R"("}])"),
                    "a.gltf"),
            "");
}

TEST(HostileGltf, MayNotReadOneAccessorThousandsOfTimes)
{
    std::string primitives, bytes(3000, '\0');
    for (int i = 0; i < 20000; ++i)
        primitives += R"({"attributes":{"POSITION":0,"X)" + std::to_string(i) + R"(":0}},)";
    primitives.pop_back();
    const std::string text =
        gltf(R"("buffers":[{"byteLength":3000}],"bufferViews":[{"buffer":0,"byteLength":3000}],)"
             R"("accessors":[{"bufferView":0,"componentType":5126,"count":250,"type":"VEC3"}],)"
             R"("meshes":[{"primitives":[)" +
             primitives + "]}]");
    std::string glb = "glTF....----....JSON" + text;
    glb.resize((glb.size() + 3) / 4 * 4, ' ');
    const auto json_size = static_cast<std::uint32_t>(glb.size() - 20);
    glb += "----BIN" + std::string(1, '\0') + bytes;
    put32(glb, 4, 2);
    put32(glb, 8, static_cast<std::uint32_t>(glb.size()));
    put32(glb, 12, json_size);
    put32(glb, 20 + json_size, 3000);
    EXPECT_THAT(refusal(glb, "a.glb"), HasSubstr("can hold"));
}

TEST(HostileImages, AreRefusedBeforeTheirPixelsAreAllocated)
{
    // Radiance's header is text: nothing else has to be forged to declare a size.
    for (const char* side : {"20000", "16000", "0", "99999999999"})
        EXPECT_THROW(
            PictureReader().read_bytes(std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y ") +
                                           side + " +X " + side + "\n",
                                       "a.hdr"),
            Rejected)
            << side;
    const std::string png = encoded_image(checker_image(), ".png");
    for (std::size_t length = 0; length < png.size(); ++length) try {
            PictureReader().read_bytes(png.substr(0, length), "a.png");
        } catch (const Rejected&) {
        }
}

TEST(Repairs, AreSaid)
{
    const std::string quad = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nv 9 9 9\n";
    EXPECT_TRUE(notices(quad + "f 1 2 3 4\nf 2 5 6 3\n", "a.obj").empty());
    EXPECT_THAT(notices(quad + "f 1 2 3 4\nf 2 5 6 3\nf 1 2\n", "a.obj").at(0),
                HasSubstr("fewer than three"));
    EXPECT_THAT(notices(quad + "f 1 2 2 3 4\nf 2 5 6 3\n", "a.obj").at(0), HasSubstr("repeat"));
    EXPECT_THAT(notices(quad + "f 1 2 3 4\nf 3 6 5 2\nf 2 5 6 3\n", "a.obj").size(), 0u)
        << "edges of three faces decide nothing";
    EXPECT_THAT(notices(quad + "f 1 2 3\nf 1 3 4\nf 3 6 5 2\n", "a.obj").at(0),
                HasSubstr("1 flipped face was corrected"));
    EXPECT_THAT(notices(quad + "f 1 2 3 4\nusemtl none\nf 2 5 6 3\n", "a.obj").at(0),
                HasSubstr("not defined"));
    EXPECT_THAT(notices("OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n5 5 5\n3 0 1 2\n", "a.off").at(0),
                HasSubstr("no face uses"));
}

TEST(Repairs, AreSummedOverTheMeshesOfAFile)
{
    Mesh plane = plane_mesh({1, 1}, {2, 2});
    std::reverse(plane.corners.begin(), plane.corners.begin() + 4);
    Model model = single_mesh_model("a", plane);
    for (int i = 1; i < 30; ++i) {
        model.meshes.push_back(model.meshes[0]);
        model.nodes.push_back({"b", -1, glm::dmat4(1), i});
    }
    EXPECT_THAT(notices(bytes_of(model, ".glb"), "a.glb"),
                ::testing::ElementsAre("a.glb: 60 flipped faces were corrected"));
}

TEST(Repairs, LeaveAMoebiusBandAsItIs)
{
    const Mesh band = moebius_mesh(1, 0.4, {30, 3});
    const Model back = read_model_bytes(write_ply(single_mesh_model("band", band)), "band.ply", "");
    EXPECT_TRUE(back.notices.empty());
    EXPECT_EQ(back.meshes[0]->corners, band.corners);
}

// Other projects' regressions: broken, hostile, or merely odd.
TEST(RealDataMalformed, EveryFileIsReadOrRefusedInASentence)
{
    const std::string folder = real_data_folder();
    if (folder.empty()) GTEST_SKIP() << "no folder of real data";
    int tried = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder + "/malformed")) {
        if (!entry.is_regular_file()) continue;
        ++tried;
        try {
            const Model model = read_model(entry.path().string());
            for (const Ref<Mesh>& mesh : model.meshes) validate(*mesh, entry.path());
        } catch (const Rejected& rejected) {
            const std::string sentence = rejected.what();
            EXPECT_THAT(sentence, HasSubstr(entry.path().filename().string()));
            EXPECT_EQ(sentence.find('\n'), sentence.npos);
        }
    }
    EXPECT_GT(tried, 40);
}

} // namespace
} // namespace trivar
