// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/text.h"
#include "core/document/log.h"
#include "core/files/glb_content.h"
#include "editor/command_line/command_line.h"
#include "tests/support/fixtures.h"

#include <cstring>
#include <filesystem>
#include <gmock/gmock.h>
#include <sstream>

namespace trivar {
namespace {

using ::testing::HasSubstr;
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
    void SetUp() override
    {
        AddBox table;
        table.shape.size = {4, 4, 0.5};
        AddTeapot pot;
        pot.shape = {.height = 0.3, .resolution = 4};
        Sketch sketch;
        sketch.camera.eye = {0, -4, 4};
        for (int i = 0; i < 9; ++i) sketch.samples.push_back({{440 + 50 * i, 360}, 0.1 * i, 1});
        write_file(folder.file("pot.trivar"), log_header() + command_line(table) +
                                                  command_line(pot) +
                                                  command_line(Place{2, sketch, {}, {1}}));
    }
    Ran exported(const std::string& tolerance)
    {
        return run_verb({"replay", folder.file("pot.trivar"), "--epsilon", tolerance, "--export",
                         folder.file("pot.glb")});
    }
    Ran verified() { return run_verb({"verify", folder.file("pot.glb")}); }

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

TEST_F(CertifiedExport, FailsWhereAVertexWasMoved)
{
    ASSERT_EQ(exported("0.001").status, Status::done);
    const GlbContent content = glb_content(folder.file("pot.glb"));
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

TEST_F(CertifiedExport, SaysWhatIsWrongWithItsInput)
{
    EXPECT_EQ(exported("0").status, Status::usage);
    EXPECT_EQ(exported("-1").status, Status::usage);
    const Ran fine = exported("1e-9");
    EXPECT_EQ(fine.status, Status::check_failed);
    EXPECT_THAT(fine.text, HasSubstr("finer than single precision"));
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
