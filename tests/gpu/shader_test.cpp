// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/program.h"
#include "gpu/shader_variants.h"
#include "tests/gpu/support.h"
#include "tests/support/fixtures.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
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
    for (const ProgramName& name : every_program()) {
        used.insert(name.vertex + ".vert.glsl");
        used.insert(name.fragment + ".frag.glsl");
    }
    const auto folder = std::filesystem::path(TRIVAR_SOURCE_DIR) / "gpu" / "shaders";
    for (const auto& file : std::filesystem::directory_iterator(folder)) {
        const std::string name = file.path().filename().string();
        const bool stage = name.ends_with(".vert.glsl") || name.ends_with(".frag.glsl");
        EXPECT_TRUE(!stage || used.count(name)) << name;
        std::ifstream in(file.path());
        const std::string text{std::istreambuf_iterator<char>(in), {}};
        EXPECT_EQ(shader_file(name), text) << name << " is embedded as it is";
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
        for (const char* stage : {"vert", "frag"}) {
            const std::string base = *stage == 'v' ? name.vertex : name.fragment;
            const std::string source = shader_source(base + '.' + stage + ".glsl", name.defines);
            if (!seen.insert(stage + source).second) continue;
            const std::string file = folder.file(base + std::to_string(count++) + '.' + stage);
            std::ofstream(file) << source;
            command += ' ' + file;
        }
    EXPECT_EQ(std::system((command + " > " + folder.file("out")).c_str()), 0)
        << std::ifstream(folder.file("out")).rdbuf();
}

} // namespace trivar::gpu::testing
