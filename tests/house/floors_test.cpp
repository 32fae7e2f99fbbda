// SPDX-License-Identifier: GPL-3.0-or-later
// The house stands on its floors: an include goes downward only, nothing is above itself, and no
// file is two topics.
#include "tests/support/fixtures.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace trivar::testing {
namespace {

// The floors from the ground up; docs/architecture.md draws the same house. Rooms beside each other
// on one floor do not know each other. A room may be one file and its header.
const std::vector<std::vector<std::string>> floors{
    {"core/base"},
    {"core/animation"},
    {"core/kernel"},
    {"core/spline"},
    {"core/mesh"},
    {"core/rays", "core/walking", "core/plane"},
    {"core/text"},
    {"core/files"},
    {"core/simplify", "core/unwrap", "core/voxels"},
    {"core/patches", "core/limit"},
    {"core/ffd", "core/incise", "core/tiles"},
    {"core/refinement"},
    {"core/placement", "core/split"},
    {"core/simplex"},
    {"core/meshing", "core/tetrahedra"},
    {"core/field"},
    {"core/level"},
    {"core/silhouette"},
    {"core/lines"},
    {"core/casting", "core/drawing"},
    {"core/document"},
    {"core/commands/words", "core/commands/edits"},
    {"core/commands/objects"},
    {"core/commands/cutting", "core/commands/placement", "core/commands/tiles",
     "core/commands/volumes"},
    {"core/commands", "core/stages"},
    {"core/steps/bending", "core/steps/laying", "core/steps/moving"},
    {"core/steps/tiles"},
    {"core/steps"},
    {"core/evaluation"},
    {"core/scene", "core/scene_lines"},
    {"core/certificate"},
    {"core/export"},
    {"gpu"},
    {"ui"},
    {"editor/words", "editor/jobs", "editor/action", "editor/memory"},
    {"editor/preferences", "editor/picture"},
    {"editor/session"},
    {"editor/files", "editor/help", "editor/timeline", "editor/hands"},
    {"editor/tools/incise", "editor/tools/lattice", "editor/tools/place",
     "editor/tools/silhouettes", "editor/tools/split", "editor/tools/tetrahedra",
     "editor/tools/tiles"},
    {"editor/tools"},
    {"editor/commands", "editor/record", "editor/viewport"},
    {"editor/editor"},
    {"editor/actions"},
    {"editor/panels"},
    {"editor/window"},
    {"editor/command_line"},
    {"editor/main", "editor/carried"}};
constexpr int most_lines_header = 150, most_lines_source = 450;
constexpr std::size_t most_things_in_a_folder = 45;

// The rooms of core that gpu and ui may include: values alone.
const std::map<std::string, std::vector<std::string>> may_know{
    {"gpu", {"core/base", "core/casting", "core/ffd", "core/mesh", "core/patches"}},
    {"ui", {"core/base", "core/mesh", "core/casting"}}};

// Headers with a class that is a value. Any other class works with something, and the document
// sees none, as whatever sees the document sees it too.
const std::set<std::string> classes_that_are_values{"core/animation/track.h", "core/spline/knots.h",
                                                    "core/text/font.h"};

// A header and its source are one thing, which is called by the path of both.
std::string thing_of(const std::string& path)
{
    return path.substr(0, path.rfind('.'));
}

bool lies_in(const std::string& path, const std::string& room)
{
    return path.starts_with(room + "/") || thing_of(path) == room;
}

struct Place {
    int floor = -1; // none: it is no part of the house
    std::string room = {};
};
// Returns the floor and the room of a path below the top level.
Place place_of(const std::string& path)
{
    for (std::size_t i = 0; i < floors.size(); ++i)
        for (const std::string& room : floors[i])
            if (lies_in(path, room)) return {static_cast<int>(i), room};
    return {};
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

// Returns the faults of one file, one sentence each.
std::vector<std::string> complaints(const std::string& path, const std::string& text)
{
    std::vector<std::string> out;
    const Place here = place_of(path);
    if (here.floor < 0) out.push_back(path + " lies on no floor");
    for (const std::string& name : includes_of(text, '"', '"')) {
        const Place there = place_of(name);
        if (there.floor < 0) out.push_back(path + " includes " + name + ", which lies on no floor");
        if (there.floor > here.floor) out.push_back(path + " climbs to " + name);
        if (there.floor == here.floor && there.room != here.room)
            out.push_back(path + " crosses to " + name);
        const auto known = may_know.find(here.room);
        if (known != may_know.end() && name.starts_with("core/") &&
            std::ranges::none_of(known->second,
                                 [&](const std::string& room) { return lies_in(name, room); }))
            out.push_back(path + " must not know " + name);
    }
    const bool header = path.ends_with(".h");
    const auto lines = std::count(text.begin(), text.end(), '\n');
    if (lines > (header ? most_lines_header : most_lines_source))
        out.push_back(path + " has " + std::to_string(lines) + " lines: it is two topics");
    for (const std::string& name : includes_of(text, '<', '>'))
        if (name == "cassert" || name == "assert.h")
            out.push_back(path + " would end the program; core/base/mistake.h has `ensure`");
    return out;
}

using Files = std::map<std::string, std::string>; // path below the top level, text

// A header that shows somebody else's headers may only be used by sources of its own room, so
// that only they need to know what lies behind.
std::vector<std::string> leaks(const Files& files)
{
    std::vector<std::string> out;
    for (const auto& [path, text] : files)
        for (const std::string& name : includes_of(text, '"', '"')) {
            const auto header = files.find(name);
            if (header == files.end() || !shows_foreign_headers(header->second)) continue;
            if (path.ends_with(".cpp") && place_of(path).room == place_of(name).room) continue;
            out.push_back(path + " lets out what " + name + " includes of others");
        }
    return out;
}

// Arrows lead from each thing to the others that it includes.
using Arrows = std::map<std::string, std::set<std::string>>;
Arrows arrows_between(const Files& files)
{
    Arrows arrows;
    for (const auto& [path, text] : files)
        for (const std::string& name : includes_of(text, '"', '"'))
            if (thing_of(name) != thing_of(path)) arrows[thing_of(path)].insert(thing_of(name));
    return arrows;
}

// The shortest way along arrows from a thing back to itself, which stands at both ends; empty where
// there is none.
std::vector<std::string> way_back(const Arrows& arrows, const std::string& thing)
{
    std::map<std::string, std::string> from; // of each thing that was reached, the one before
    std::vector<std::string> reached{thing};
    for (std::size_t i = 0; i < reached.size() && !from.contains(thing); ++i) {
        const auto found = arrows.find(reached[i]);
        if (found == arrows.end()) continue;
        for (const std::string& next : found->second)
            if (from.emplace(next, reached[i]).second) reached.push_back(next);
    }
    std::vector<std::string> way;
    if (!from.contains(thing)) return way;
    for (std::string at = from[thing]; at != thing; at = from[at]) way.push_back(at);
    way.push_back(thing);
    std::ranges::reverse(way);
    way.push_back(thing);
    return way;
}

// The things that are above themselves, a sentence for each knot.
std::vector<std::string> knots(const Arrows& arrows)
{
    std::set<std::string> told;
    std::vector<std::string> out;
    for (const auto& [thing, below] : arrows) {
        const std::vector<std::string> way =
            told.contains(thing) ? std::vector<std::string>() : way_back(arrows, thing);
        if (way.empty()) continue;
        told.insert(way.begin(), way.end());
        out.push_back(thing + " is above itself");
        for (const std::string& step : way)
            out.back() += (&step == &way.front() ? ": " : ", ") + step;
    }
    return out;
}

// The folders of more things than one finds at a glance, a sentence for each.
std::vector<std::string> full_folders(const Files& files)
{
    std::map<std::string, std::set<std::string>> things;
    for (const auto& [path, text] : files)
        things[path.substr(0, path.rfind('/'))].insert(thing_of(path));
    std::vector<std::string> out;
    for (const auto& [folder, all] : things)
        if (all.size() > most_things_in_a_folder)
            out.push_back(folder + " holds " + std::to_string(all.size()) +
                          " things: give some a room of their own");
    return out;
}

bool defines_a_class(const std::string& text)
{
    for (std::size_t at = text.find("class "); at != std::string::npos;
         at = text.find("class ", at + 1)) {
        const std::size_t line = text.rfind('\n', at) + 1;
        const std::string before = text.substr(line, at - line);
        if (!before.empty() && !(before.starts_with("template") && before.ends_with("> ")))
            continue;
        if (text.find('{', at) < text.find(';', at)) return true;
    }
    return false;
}

// Returns a sentence for each header of the document that sees more of other rooms than values.
std::vector<std::string> more_than_values(const Files& files)
{
    std::set<std::string> seen;
    std::vector<std::string> open;
    for (const auto& [path, text] : files)
        if (lies_in(path, "core/document") && path.ends_with(".h")) open.push_back(path);
    std::vector<std::string> out;
    while (!open.empty()) {
        const auto file = files.find(open.back());
        open.pop_back();
        if (file == files.end() || !seen.insert(file->first).second) continue;
        const auto& [path, text] = *file;
        if (!lies_in(path, "core/document") && !lies_in(path, "core/base") &&
            !classes_that_are_values.contains(path) && defines_a_class(text))
            out.push_back("core/document sees " + path + ", which holds more than values");
        for (const std::string& name : includes_of(text, '"', '"')) open.push_back(name);
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
    for (const auto& some :
         {knots(arrows_between(files)), full_folders(files), more_than_values(files)})
        out.insert(out.end(), some.begin(), some.end());
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
    write("core/mesh/climbs.cpp", "#include \"core/files/pictures/image.h\"\n");
    const auto found = complaints_about(house.path());
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0], "core/mesh/climbs.cpp climbs to core/files/pictures/image.h");
}

TEST(Floors, OnlyAnArrowDownOrWithinARoomIsNoComplaint)
{
    for (std::size_t from = 0; from < floors.size(); ++from)
        for (std::size_t to = 0; to < floors.size(); ++to)
            for (const std::string& here : floors[from])
                for (const std::string& there : floors[to]) {
                    if (may_know.contains(here) && there.starts_with("core/")) continue;
                    const std::string text = "#include \"" + there + "/x.h\"\n";
                    EXPECT_EQ(complaints(here + "/y.cpp", text).empty(), to < from || here == there)
                        << here << " to " << there;
                }
}

TEST(Floors, AFileIsARoomWithItsHeaderAndNotTheFolderThatBeginsLikeIt)
{
    EXPECT_EQ(place_of("editor/action.h").room, "editor/action");
    EXPECT_EQ(place_of("editor/actions/undo.h").room, "editor/actions");
    EXPECT_EQ(place_of("editor/editor.cpp").room, place_of("editor/editor.h").room);
    EXPECT_EQ(place_of("editor/attic.h").floor, -1);
}

TEST(Knots, AreFoundThroughSourcesToo)
{
    Files files{{"ui/a.h", "#include \"ui/c.h\"\n"},
                {"ui/b.h", "#include \"ui/a.h\"\n"},
                {"ui/b.cpp", "#include \"ui/b.h\"\n"}};
    EXPECT_TRUE(knots(arrows_between(files)).empty());
    files["ui/c.cpp"] = "#include \"ui/b.h\"\n";
    const auto found = knots(arrows_between(files));
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0], "ui/a is above itself: ui/a, ui/c, ui/b, ui/a");
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

TEST(Floors, WhatDrawsKnowsValuesAlone)
{
    EXPECT_TRUE(complaints("gpu/a.cpp", "#include \"core/mesh/mesh.h\"\n").empty());
    EXPECT_EQ(complaints("gpu/a.h", "#include \"core/document/bases.h\"\n").size(), 1u);
    EXPECT_EQ(complaints("gpu/a.cpp", "#include \"core/document/document.h\"\n").size(), 1u);
    EXPECT_EQ(complaints("ui/a.cpp", "#include \"core/silhouette/silhouettes.h\"\n").size(), 1u);
}

TEST(Floors, TheDocumentSeesValuesAlone)
{
    Files files{{"core/document/a.h", "#include \"core/mesh/b.h\"\n"},
                {"core/mesh/b.h", "#include \"core/mesh/c.h\"\n"},
                {"core/mesh/c.h", "class Later;\nenum class E { a };\nstruct C { int c; };\n"}};
    EXPECT_TRUE(more_than_values(files).empty());
    files["core/mesh/c.h"] += "class D {\n};\n";
    EXPECT_EQ(more_than_values(files).size(), 1u);
    files["core/document/a.h"] = "";
    EXPECT_TRUE(more_than_values(files).empty());
}

TEST(Floors, FullFoldersAreComplaints)
{
    Files files;
    for (std::size_t i = 0; i < most_things_in_a_folder; ++i) {
        files["ui/a" + std::to_string(i) + ".h"] = "";
        files["ui/a" + std::to_string(i) + ".cpp"] = "";
    }
    EXPECT_TRUE(full_folders(files).empty());
    files["ui/one_more.h"] = "";
    EXPECT_EQ(full_folders(files).size(), 1u);
}

TEST(Floors, AssertionsThatEndTheProgramAreComplaints)
{
    EXPECT_EQ(complaints("ui/a.cpp", "#include <cassert>\n").size(), 1u);
    EXPECT_TRUE(complaints("ui/a.cpp", "#include \"core/base/mistake.h\"\n").empty());
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
