// SPDX-License-Identifier: GPL-3.0-or-later
// The house stands on its floors: an include goes downward only, and no file is two topics.
#include "tests/support/fixtures.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <string>
#include <vector>

namespace trivar::testing {
namespace {

// From the ground up; docs/architecture.md draws the same house.
constexpr std::array floors{"core/base",
                            "core/animation",
                            "core/kernel",
                            "core/spline",
                            "core/mesh",
                            "core/plane",
                            "core/text",
                            "core/files",
                            "core/simplify",
                            "core/ffd",
                            "core/refinement",
                            "core/placement",
                            "core/document",
                            "core/export",
                            "gpu",
                            "ui",
                            "editor"};
constexpr int most_lines_header = 150, most_lines_source = 450;

// The floor of a path below the top level, or -1 for what is no part of the house.
int floor_of(const std::string& path)
{
    for (std::size_t i = 0; i < floors.size(); ++i)
        if (path.starts_with(std::string(floors[i]) + "/")) return static_cast<int>(i);
    return -1;
}

// The names between quotes, or between angle brackets, of a file's include lines.
std::vector<std::string> includes_of(const std::string& text, char open, char close)
{
    std::vector<std::string> out;
    std::size_t line = 0;
    while (line < text.size()) {
        const std::size_t end = std::min(text.find('\n', line), text.size());
        std::string one = text.substr(line, end - line);
        std::erase_if(one, [](char c) { return c == ' ' || c == '\t'; });
        const std::string start = std::string("#include") + open;
        const std::size_t last = one.find(close, start.size());
        if (one.starts_with(start) && last != std::string::npos)
            out.push_back(one.substr(start.size(), last - start.size()));
        line = end + 1;
    }
    return out;
}

bool shows_foreign_headers(const std::string& text)
{
    const auto names = includes_of(text, '<', '>');
    return std::any_of(names.begin(), names.end(), [](const std::string& name) {
        return name.find_first_of("./") != std::string::npos && !name.starts_with("glm/") &&
               !name.ends_with("_fwd.hpp"); // names alone: what lies behind stays there
    });
}

// What is wrong with one file, one sentence each.
std::vector<std::string> complaints(const std::string& path, const std::string& text)
{
    std::vector<std::string> out;
    const int here = floor_of(path);
    if (here < 0) out.push_back(path + " lies on no floor");
    for (const std::string& name : includes_of(text, '"', '"')) {
        const int there = floor_of(name);
        if (there < 0) out.push_back(path + " includes " + name + ", which lies on no floor");
        if (there > here) out.push_back(path + " climbs to " + name);
    }
    const bool header = path.ends_with(".h");
    const auto lines = std::count(text.begin(), text.end(), '\n');
    if (lines > (header ? most_lines_header : most_lines_source))
        out.push_back(path + " has " + std::to_string(lines) + " lines: it is two topics");
    return out;
}

using Files = std::map<std::string, std::string>; // path below the top level, text

// A header that shows somebody else's headers may only be used by sources of its own floor, so
// that only they need to know what lies behind.
std::vector<std::string> leaks(const Files& files)
{
    std::vector<std::string> out;
    for (const auto& [path, text] : files)
        for (const std::string& name : includes_of(text, '"', '"')) {
            const auto header = files.find(name);
            if (header == files.end() || !shows_foreign_headers(header->second)) continue;
            if (path.ends_with(".cpp") && floor_of(path) == floor_of(name)) continue;
            out.push_back(path + " lets out what " + name + " includes of others");
        }
    return out;
}

// Every header and source of the house.
Files files_of(const std::filesystem::path& top)
{
    Files out;
    for (const char* floor : {"core", "gpu", "ui", "editor"}) {
        if (!std::filesystem::exists(top / floor)) continue;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(top / floor)) {
            const std::filesystem::path& path = entry.path();
            if (path.extension() != ".h" && path.extension() != ".cpp") continue;
            std::ifstream file(path, std::ios::binary);
            out[std::filesystem::relative(path, top).generic_string()] =
                std::string(std::istreambuf_iterator<char>(file), {});
        }
    }
    return out;
}

std::vector<std::string> complaints_about(const std::filesystem::path& top)
{
    const Files files = files_of(top);
    std::vector<std::string> out = leaks(files);
    for (const auto& [path, text] : files) {
        const auto some = complaints(path, text);
        out.insert(out.end(), some.begin(), some.end());
    }
    return out;
}

TEST(Floors, StandAsDrawn)
{
    EXPECT_GT(files_of(TRIVAR_SOURCE_DIR).size(), 30u) << "the house was not found";
    for (const std::string& sentence : complaints_about(TRIVAR_SOURCE_DIR))
        ADD_FAILURE() << sentence;
}

TEST(Floors, AHouseWithAStairUpIsNoticed)
{
    const TemporaryFolder house;
    const auto write = [&](const std::string& path, const std::string& text) {
        const auto full = house.path() / path;
        std::filesystem::create_directories(full.parent_path());
        std::ofstream(full) << text;
    };
    write("core/mesh/mesh.h", "#pragma once\n#include \"core/spline/knots.h\"\n");
    EXPECT_TRUE(complaints_about(house.path()).empty());
    write("core/mesh/climbs.cpp", "#include \"core/files/image.h\"\n");
    const auto found = complaints_about(house.path());
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0], "core/mesh/climbs.cpp climbs to core/files/image.h");
}

TEST(Floors, EveryArrowUpIsAComplaintAndNoArrowDown)
{
    for (std::size_t from = 0; from < floors.size(); ++from)
        for (std::size_t to = 0; to < floors.size(); ++to) {
            const std::string text = "#include \"" + std::string(floors[to]) + "/x.h\"\n";
            EXPECT_EQ(complaints(std::string(floors[from]) + "/y.cpp", text).empty(), to <= from)
                << floors[from] << " to " << floors[to];
        }
}

TEST(Floors, IncludesAreFoundHoweverTheyAreSpaced)
{
    EXPECT_FALSE(complaints("gpu/a.cpp", "int a;\n  #  include   \"ui/b.h\"").empty());
    EXPECT_FALSE(complaints("gpu/a.cpp", "#include\t\"editor/b.h\" // \"why\"\r\n").empty());
    EXPECT_FALSE(complaints("gpu/a.cpp", "#include \"tests/support/fixtures.h\"\n").empty());
    EXPECT_TRUE(complaints("gpu/a.cpp", "// see \"ui/b.h\"\n#include <vector>\n").empty());
}

TEST(Floors, LongFilesAndFilesOnNoFloorAreComplaints)
{
    const auto lines = [](int n) { return std::string(static_cast<std::size_t>(n), '\n'); };
    EXPECT_TRUE(complaints("ui/a.h", lines(most_lines_header)).empty());
    EXPECT_EQ(complaints("ui/a.h", lines(most_lines_header + 1)).size(), 1u);
    EXPECT_TRUE(complaints("ui/a.cpp", lines(most_lines_source)).empty());
    EXPECT_EQ(complaints("ui/a.cpp", lines(most_lines_source + 1)).size(), 1u);
    EXPECT_EQ(complaints("attic/a.h", "").size(), 1u);
}

TEST(Floors, ForeignHeadersStayBehindSources)
{
    const std::string uses = "#include \"ui/inner.h\"\n";
    Files files{{"ui/inner.h", "#include <imgui.h>\n"}, {"ui/a.cpp", uses}};
    EXPECT_TRUE(leaks(files).empty());
    files["editor/a.cpp"] = uses;
    EXPECT_EQ(leaks(files).size(), 1u);
    files["ui/a.h"] = uses;
    EXPECT_EQ(leaks(files).size(), 2u);
    files["ui/inner.h"] = "#include <glm/glm.hpp>\n#include <vector>\n";
    EXPECT_TRUE(leaks(files).empty());
}

} // namespace
} // namespace trivar::testing
