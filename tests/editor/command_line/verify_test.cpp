// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/files/gltf/glb_chunks.h"
#include "core/files/gltf/glb_content.h"
#include "core/files/gltf/second_reader.h"
#include "core/scene/log.h"
#include "editor/command_line/command_line.h"
#include "tests/editor/scenes.h"
#include "tests/support/fixtures.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <functional>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <sstream>

namespace trivar {
namespace {

using ::testing::HasSubstr, ::testing::Not;
using AnyJson = nlohmann::json;
using testing::TemporaryFolder, testing::write_file;

class CertifiedExport : public ::testing::Test {
protected:
    struct Ran {
        Status status;
        std::string text;
    };
    static Ran run_verb(const std::vector<std::string>& arguments)
    {
        std::ostringstream out, talk;
        const Status status = run_program(arguments, {out, talk});
        return {status, out.str() + talk.str()};
    }
    void SetUp() override { write_file(folder.file("pot.trivar"), testing::scene_text()); }
    Ran exported(const std::string& tolerance)
    {
        return run_verb({"replay", folder.file("pot.trivar"), "--epsilon", tolerance, "--export",
                         folder.file("pot.glb")});
    }
    Ran verified() { return run_verb({"verify", folder.file("pot.glb")}); }
    // Returns the words on the exported file after the JSON value of a name was replaced.
    std::string verified_with(const std::string& name, const std::string& value, bool last)
    {
        const std::string bytes = read_text_file(folder.file("pot.glb")), key = "\"" + name + "\":";
        const std::size_t place = (last ? bytes.rfind(key) : bytes.find(key)) + key.size();
        std::uint32_t length, all;
        std::memcpy(&length, bytes.data() + 12, 4);
        std::memcpy(&all, bytes.data() + 8, 4);
        const std::string old = bytes.substr(place, bytes.find_first_of(",}]", place) - place);
        std::string changed = bytes;
        changed.replace(place, old.size(), value);
        const auto more = static_cast<std::uint32_t>(value.size() - old.size());
        length += more;
        all += more;
        std::memcpy(changed.data() + 12, &length, 4);
        std::memcpy(changed.data() + 8, &all, 4);
        write_file(folder.file("pot.glb"), changed);
        const Ran ran = verified();
        EXPECT_EQ(ran.status, Status::check_failed) << name << " " << value;
        write_file(folder.file("pot.glb"), bytes);
        return ran.text;
    }

    std::string verified_after(const std::function<void(AnyJson&)>& change)
    {
        const std::string bytes = read_text_file(folder.file("pot.glb"));
        GlbChunks chunks = glb_chunks(bytes);
        AnyJson file = AnyJson::parse(chunks.json);
        change(file);
        chunks.json = file.dump();
        write_file(folder.file("pot.glb"), glb_container(chunks));
        const Ran ran = verified();
        EXPECT_EQ(ran.status, Status::check_failed) << ran.text;
        write_file(folder.file("pot.glb"), bytes);
        return ran.text;
    }

    TemporaryFolder folder;
};

TEST_F(CertifiedExport, IsVerifiedAgainstTheSceneBesideIt)
{
    EXPECT_EQ(exported("0.001").status, Status::done);
    const Ran ran = verified();
    EXPECT_EQ(ran.status, Status::done);
    EXPECT_THAT(ran.text, HasSubstr("what it claims holds"));
    EXPECT_THAT(ran.text, HasSubstr("samples"));
}

TEST_F(CertifiedExport, IsReadByTinygltfAsItIsByUs)
{
    ASSERT_EQ(exported("0.001").status, Status::done);
    const std::string bytes = read_text_file(folder.file("pot.glb"));
    const std::vector<GlbContent::Node> nodes = nodes_by_tinygltf(bytes);
    EXPECT_GT(nodes.size(), 1u);
    EXPECT_EQ(nodes, glb_content_of(bytes, "pot.glb").nodes);
    EXPECT_THROW(nodes_by_tinygltf(bytes.substr(0, bytes.size() / 2)), Rejected);
}

TEST_F(CertifiedExport, FailsWhereAVertexWasMoved)
{
    ASSERT_EQ(exported("0.001").status, Status::done);
    const GlbContent content = glb_content_of(read_text_file(folder.file("pot.glb")), "pot.glb");
    const glm::vec3 vertex = content.nodes.back().positions.at(50), moved = vertex + 0.01f;
    std::string bytes = read_text_file(folder.file("pot.glb")), as_bytes(sizeof vertex, ' ');
    std::memcpy(as_bytes.data(), &vertex, sizeof vertex);
    const std::size_t place = bytes.find(as_bytes);
    ASSERT_NE(place, std::string::npos);
    std::memcpy(bytes.data() + place, &moved, sizeof moved);
    write_file(folder.file("pot.glb"), bytes);
    const Ran ran = verified();
    EXPECT_EQ(ran.status, Status::check_failed);
    EXPECT_THAT(ran.text, HasSubstr("further off than it claims"));
}

TEST_F(CertifiedExport, FailsForAnotherScene)
{
    ASSERT_EQ(exported("0.001").status, Status::done);
    write_file(folder.file("pot.trivar"),
               read_text_file(folder.file("pot.trivar")) + command_line(SetTime{{1, 9, 24}}));
    const Ran ran = verified();
    EXPECT_EQ(ran.status, Status::check_failed);
    EXPECT_THAT(ran.text, HasSubstr("is not the scene"));
}

TEST_F(CertifiedExport, OfAnEarlierStepIsVerifiedAtThatStep)
{
    const std::string before = read_text_file(folder.file("pot.trivar"));
    const auto lines = std::ranges::count(before, '\n');
    write_file(folder.file("pot.trivar"), before + command_line(Hide{{2}}));
    ASSERT_EQ(run_verb({"replay", folder.file("pot.trivar"), "--to", std::to_string(lines),
                        "--epsilon", "0.001", "--export", folder.file("pot.glb")})
                  .status,
              Status::done);
    const Ran ran = verified();
    EXPECT_EQ(ran.status, Status::done) << ran.text;
    EXPECT_THAT(ran.text, HasSubstr("samples"));
    EXPECT_THAT(verified_with("lines", std::to_string(lines - 1), false),
                HasSubstr("is not the scene"));
    EXPECT_THAT(verified_with("lines", "0", false), HasSubstr("is not the scene"));
}

TEST_F(CertifiedExport, ChecksEveryFigureOfTheClaim)
{
    ASSERT_EQ(exported("0.001").status, Status::done);
    EXPECT_THAT(verified_with("bound_m", "1e-9", false), HasSubstr("furthest of its parts"));
    EXPECT_THAT(verified_with("bound_m", "1", false), HasSubstr("furthest of its parts"));
    EXPECT_THAT(verified_with("tolerance_m", "0.5", true), HasSubstr("were asked for"));
    for (const char* count : {"triangles_before", "triangles", "degenerate", "not_certified"})
        EXPECT_THAT(verified_with(count, "7", true), HasSubstr("other numbers of triangles"));
    // One part twice, as where another is left out.
    const std::string bytes = read_text_file(folder.file("pot.glb"));
    const std::size_t begin = bytes.find("[", bytes.find("\"parts\":")) + 1;
    const std::string part = bytes.substr(begin, bytes.find("]", begin) - begin);
    EXPECT_THAT(verified_with("rule", "\"\"}," + part.substr(0, part.size() - 1), true),
                HasSubstr("is claimed twice"));
    EXPECT_EQ(verified().status, Status::done);
}

TEST_F(CertifiedExport, FailsWhereAViewerWouldShowAnythingElse)
{
    ASSERT_EQ(exported("0.001").status, Status::done);
    const auto fails = [&](const char* sentence, const std::function<void(AnyJson&)>& change) {
        EXPECT_THAT(verified_after(change), HasSubstr(sentence));
    };
    const AnyJson some{{{"any", 1}}};
    fails("it has \"animations\"", [&](AnyJson& file) { file["animations"] = some; });
    fails("nodes[1] has \"skin\"", [](AnyJson& file) { file["nodes"][1]["skin"] = 0; });
    fails("nodes[1] has \"weights\"", [](AnyJson& file) { file["nodes"][1]["weights"] = {1}; });
    fails("nodes[0].matrix[12]", [](AnyJson& file) { file["nodes"][0]["matrix"][12] = 3; });
    fails("its nodes has 3 entries", [](AnyJson& file) { file["nodes"].push_back({{"mesh", 1}}); });
    fails("its scenes[0].nodes", [](AnyJson& file) { file["scenes"][0]["nodes"] = {0}; });
    fails("its scene is 1", [](AnyJson& file) { file["scene"] = 1; });
    fails("primitives[0] has \"mode\"",
          [](AnyJson& file) { file["meshes"][1]["primitives"][0]["mode"] = 1; });
    fails("\"targets\"",
          [&](AnyJson& file) { file["meshes"][1]["primitives"][0]["targets"] = some; });
    for (AnyJson::size_type i : {0u, 3u}) {
        fails("\"sparse\"", [&](AnyJson& file) { file["accessors"][i]["sparse"] = some; });
        fails("\"byteOffset\"", [&](AnyJson& file) { file["accessors"][i]["byteOffset"] = 4; });
        fails("componentType is",
              [&](AnyJson& file) { file["accessors"][i]["componentType"] = 1; });
        fails("\"byteStride\"", [&](AnyJson& file) { file["bufferViews"][i]["byteStride"] = 24; });
    }
    EXPECT_EQ(verified().status, Status::done);
}

TEST_F(CertifiedExport, FailsWhereAClaimNamesWhatTheSceneDoesNot)
{
    ASSERT_EQ(exported("0.001").status, Status::done);
    EXPECT_THAT(verified_with("method", "\"magic\"", true), HasSubstr("claims magic and"));
    EXPECT_THAT(verified_with("rule", "\"magic\"", true), HasSubstr("and magic where"));
    EXPECT_THAT(verified_after([](AnyJson& file) {
                    file["extras"]["trivar_certificate"]["parts"][0]["name"] = "Other";
                }),
                HasSubstr("Other (part 1) is called Teapot in the scene"));
    EXPECT_THAT(verified_with("tolerance_m", "1e-5", true),
                HasSubstr("claims to be within 0.00001 m where 0.001 m were asked for"));
    EXPECT_THAT(verified_with("bound_m", "null", true), HasSubstr("where the furthest"));
}

TEST_F(CertifiedExport, ListsWhatDoesNotLieWhereItShould)
{
    ImportModel gone;
    gone.file.path = "gone.obj";
    Place stroke = testing::placed(3, 1);
    const std::string before = testing::scene_text();
    write_file(folder.file("pot.trivar"), before + command_line(gone) + command_line(stroke));
    EXPECT_EQ(exported("0.001").status, Status::rejected);
    const Ran ran = run_verb({"replay", folder.file("pot.trivar"), "--epsilon", "0.001", "--export",
                              folder.file("pot.glb"), "--keep-going"});
    EXPECT_EQ(ran.status, Status::check_failed);
    EXPECT_THAT(ran.text, HasSubstr("is not certified: it does not lie where it should"));
    const Ran checked = verified();
    EXPECT_EQ(checked.status, Status::check_failed);
    EXPECT_THAT(checked.text, HasSubstr("is not certified: it does not lie where it should"));
    EXPECT_THAT(verified_after([](AnyJson& file) {
                    file["extras"]["trivar_certificate"]["not_laid"] = AnyJson::array();
                }),
                HasSubstr("does not lie where it should, which it leaves out"));
}

TEST_F(CertifiedExport, SaysWhereThereIsNothingToCertify)
{
    write_file(folder.file("pot.trivar"), log_header() + command_line(AddBox{}));
    const Ran ran = exported("0.001");
    EXPECT_EQ(ran.status, Status::done);
    EXPECT_THAT(ran.text, HasSubstr("nothing in it lies in a volume"));
    EXPECT_THAT(verified().text, HasSubstr("nothing lies in a volume, it claims nothing"));
}

TEST_F(CertifiedExport, SaysWhatIsNotRefinedInWords)
{
    // Only one of two laid objects is refined; the other keeps its triangles.
    AddBox second;
    Refine refine;
    refine.objects = {2};
    write_file(folder.file("pot.trivar"), testing::scene_text() + command_line(second) +
                                              command_line(testing::placed(3, 1)) +
                                              command_line(refine));
    ASSERT_EQ(
        run_verb({"replay", folder.file("pot.trivar"), "--export", folder.file("pot.glb")}).status,
        Status::done);
    const Ran ran = verified();
    EXPECT_EQ(ran.status, Status::check_failed);
    EXPECT_THAT(ran.text, HasSubstr("is not certified: it is not refined"));
    EXPECT_THAT(ran.text, HasSubstr("claimed: no bound"));
    EXPECT_THAT(ran.text, Not(HasSubstr("the scene gives")));
    EXPECT_THAT(ran.text, Not(HasSubstr("claimed: 0 m")));
}

TEST_F(CertifiedExport, IsRefusedWhereItNestsOrMultiplies)
{
    const auto refused = [&](const std::string& json, std::size_t data) {
        write_file(folder.file("bad.glb"), glb_container({json, std::string(data, '\0')}));
        const Ran ran = run_verb({"verify", folder.file("bad.glb")});
        EXPECT_EQ(ran.status, Status::rejected);
        return ran.text;
    };
    const std::string deep = std::string(100000, '[') + std::string(100000, ']');
    EXPECT_THAT(refused("{\"extras\":" + deep + "}", 0), HasSubstr("nested too deep"));
    EXPECT_THAT(refused("{\"nodes\":" + deep + "}", 0), HasSubstr("nested too deep"));
    std::string nodes = "{\"mesh\":0}";
    for (int i = 0; i < 1000; ++i) nodes += ",{\"mesh\":0}";
    EXPECT_THAT(refused(R"({"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":0}]}],)"
                        R"("accessors":[{"bufferView":0,"count":9000}],)"
                        R"("bufferViews":[{"byteOffset":0,"byteLength":120000}],"nodes":[)" +
                            nodes + "]}",
                        120000),
                HasSubstr("over and over"));
}

TEST_F(CertifiedExport, SaysWhatIsWrongWithItsInput)
{
    EXPECT_EQ(exported("0").status, Status::usage);
    for (const char* none : {"-1", "", "inf", "nan", "1mm"})
        EXPECT_EQ(exported(none).status, Status::usage) << none;
    EXPECT_EQ(run_verb({"replay", folder.file("pot.trivar"), "--frame", ""}).status, Status::usage);
    EXPECT_FALSE(std::filesystem::exists(folder.file("pot.glb")));
    const Ran fine = exported("1e-9");
    EXPECT_EQ(fine.status, Status::check_failed);
    EXPECT_THAT(fine.text, HasSubstr("finer than the precision of the coordinates"));
    ASSERT_EQ(
        run_verb({"replay", folder.file("pot.trivar"), "--export", folder.file("pot.glb")}).status,
        Status::done);
    EXPECT_THAT(verified().text, HasSubstr("has no certificate"));
    write_file(folder.file("pot.glb"), "glTF but no more");
    EXPECT_EQ(verified().status, Status::rejected);
    ASSERT_EQ(exported("0.01").status, Status::done);
    std::filesystem::remove(folder.file("pot.trivar"));
    EXPECT_THAT(verified().text, HasSubstr("--log"));
}

} // namespace
} // namespace trivar
