// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "gpu/program.h"
#include "tests/gpu/every_program.h"
#include "tests/gpu/support.h"
#include "tests/support/fixtures.h"

#include <algorithm>
#include <cstdlib>
#include <epoxy/gl.h>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <set>

namespace trivar::gpu::testing {

class Shaders : public WithContext {};

TEST_F(Shaders, CompileAndLinkInEveryVariant)
{
    for (const ProgramName& name : every_program()) Program program(name);
}

TEST_F(Shaders, AreAllPartOfSomeProgram)
{
    std::set<std::string> used;
    for (const ProgramName& name : every_program())
        for (const ShaderStage& stage : stages(name)) used.insert(stage.file);
    const auto folder = std::filesystem::path(TRIVAR_SOURCE_DIR) / "gpu" / "shaders";
    for (const auto& file : std::filesystem::directory_iterator(folder)) {
        const std::string name = file.path().filename().string();
        const bool stage = name.ends_with(".vert.glsl") || name.ends_with(".geom.glsl") ||
                           name.ends_with(".frag.glsl") || name.ends_with(".comp.glsl");
        EXPECT_TRUE(!stage || used.count(name)) << name;
        std::ifstream in(file.path());
        const std::string text{std::istreambuf_iterator<char>(in), {}};
        EXPECT_EQ(shader_file(name), text) << name << " is embedded as it is";
    }
}

TEST_F(Shaders, ThatADriverDoesNotTakeAreRefusedInASentence)
{
    glDisable(GL_DEBUG_OUTPUT); // which would fail the test for what it says
    try {
        Program({"line", "line", {"layout nonsense"}});
        FAIL() << "it was taken";
    } catch (const Rejected& error) {
        EXPECT_THAT(
            error.what(),
            ::testing::StartsWith("The graphics driver does not compile frame.glsl:5 (in line."));
    }
}

TEST_F(Shaders, PassTheReferenceCompiler)
{
    if (std::system("command -v glslangValidator > /dev/null") != 0)
        GTEST_SKIP() << "glslangValidator (package glslang-tools) is not installed";
    const trivar::testing::TemporaryFolder folder;
    std::string command = "glslangValidator";
    int count = 0;
    std::set<std::string> seen;
    for (const ProgramName& name : every_program())
        for (const ShaderStage& stage : stages(name)) {
            for (const int gl_version : {43, 33}) {
                const bool deforms = std::ranges::any_of(
                    name.defines, [](const std::string& d) { return d.starts_with("ORDER_U"); });
                if (gl_version == 33 && (deforms || stage.kind == "comp")) continue;
                const std::string source =
                    shader_source(stage.file, name.defines, nullptr, gl_version).text;
                if (!seen.insert(stage.kind + source).second) continue;
                const std::string file = folder.file(std::to_string(count++) + '.' + stage.kind);
                std::ofstream(file) << source;
                command += ' ' + file;
            }
        }
    EXPECT_EQ(std::system((command + " > " + folder.file("out")).c_str()), 0)
        << std::ifstream(folder.file("out")).rdbuf();
}

} // namespace trivar::gpu::testing
