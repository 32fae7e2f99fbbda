// SPDX-License-Identifier: GPL-3.0-or-later
// Caches and USD text, read by parsers of their own.
#include "core/base/rejected.h"
#include "core/base/text.h"
#include "core/export/animated_files.h"
#include "tests/export/scenes.h"

#include <cstring>
#include <filesystem>
#include <gmock/gmock.h>
#include <sstream>

namespace trivar {
namespace {

namespace fs = std::filesystem;

class PointFiles : public testing::ExportedScenes {
protected:
    PointFiles() : document_(travelling(laid(), {.speed = 1.5})) {}
    AnimatedFile written(const std::string& name, const Progress& progress = {}) const
    {
        return write_animated({document_, {2, 5}, 1e-3, ""}, assets_, folder_.file(name), progress);
    }
    // The bar's vertices in a frame, in the world.
    std::vector<glm::vec3> bar_at(double frame) const
    {
        Evaluator evaluate(assets_);
        return evaluate(document_, frame).objects.at(5)->parts.front().mesh()->positions;
    }
    std::size_t files_named(const std::string& part) const
    {
        std::size_t count = 0;
        for (const auto& entry : fs::directory_iterator(folder_.path()))
            count += entry.path().filename().string().find(part) != std::string::npos;
        return count;
    }
    Document document_;
};

std::uint32_t word_at(const std::string& bytes, std::size_t at, bool big)
{
    std::uint32_t out = 0;
    for (std::size_t i = 0; i < 4; ++i)
        out |= std::uint32_t{static_cast<unsigned char>(bytes.at(at + i))}
               << (8 * (big ? 3 - i : i));
    return out;
}

float float_at(const std::string& bytes, std::size_t at, bool big)
{
    const std::uint32_t word = word_at(bytes, at, big);
    float out;
    std::memcpy(&out, &word, 4);
    return out;
}

// The v lines of an OBJ.
std::vector<glm::vec3> obj_places(const std::string& path)
{
    std::istringstream text(read_text_file(path));
    std::vector<glm::vec3> out;
    for (std::string line; std::getline(text, line);)
        if (line.starts_with("v ")) {
            std::istringstream numbers(line.substr(2));
            glm::vec3 p;
            numbers >> p.x >> p.y >> p.z;
            out.push_back(p);
        }
    return out;
}

// Whether each place of a cache, Y up, is one of the mesh's at that frame, in its order.
void expect_places(const std::string& bytes, std::size_t at, bool big, std::size_t points,
                   const std::vector<glm::vec3>& mesh)
{
    std::size_t v = 0;
    for (std::size_t i = 0; i < points; ++i, at += 12) {
        const glm::vec3 p(float_at(bytes, at, big), -float_at(bytes, at + 8, big),
                          float_at(bytes, at + 4, big));
        while (v < mesh.size() && mesh[v] != p) ++v; // copies at a seam are left out
        ASSERT_LT(v, mesh.size()) << "place " << i;
    }
}

TEST_F(PointFiles, OfPc2HaveEveryFrameInTheOrderOfTheObj)
{
    const AnimatedFile made = written("a.pc2");
    EXPECT_THAT(made.files, ::testing::Contains(folder_.file("a.Bar.pc2")));
    const std::string bytes = read_text_file(folder_.file("a.Bar.pc2"));
    EXPECT_EQ(bytes.substr(0, 12), std::string("POINTCACHE2\0", 12));
    EXPECT_EQ(word_at(bytes, 12, false), 1u);
    const std::size_t points = word_at(bytes, 16, false);
    EXPECT_EQ(float_at(bytes, 20, false), 2.0f);
    EXPECT_EQ(float_at(bytes, 24, false), 1.0f);
    ASSERT_EQ(word_at(bytes, 28, false), 4u);
    ASSERT_EQ(bytes.size(), 32 + 4 * points * 12);
    for (std::size_t i = 0; i < 4; ++i)
        expect_places(bytes, 32 + i * points * 12, false, points,
                      bar_at(2 + static_cast<double>(i)));
    const std::vector<glm::vec3> obj = obj_places(folder_.file("a.Bar.obj"));
    ASSERT_EQ(obj.size(), points);
    for (std::size_t v = 0; v < points; ++v)
        for (int a = 0; a < 3; ++a)
            EXPECT_NEAR(obj[v][a],
                        float_at(bytes, 32 + 12 * v + 4 * static_cast<std::size_t>(a), false),
                        1e-6);
}

TEST_F(PointFiles, OfMddHaveTheirTimesInSecondsAndTheLargestByteFirst)
{
    written("a.mdd");
    const std::string bytes = read_text_file(folder_.file("a.Bar.mdd"));
    ASSERT_EQ(word_at(bytes, 0, true), 4u);
    const std::size_t points = word_at(bytes, 4, true);
    for (std::size_t i = 0; i < 4; ++i)
        EXPECT_FLOAT_EQ(float_at(bytes, 8 + 4 * i, true), static_cast<float>(i) / 12);
    ASSERT_EQ(bytes.size(), 24 + 4 * points * 12);
    for (std::size_t i = 0; i < 4; ++i)
        expect_places(bytes, 24 + i * points * 12, true, points,
                      bar_at(2 + static_cast<double>(i)));
}

// The tuples of a list that begins at a place in a text.
std::vector<glm::vec3> usd_places(const std::string& text, std::size_t at)
{
    std::vector<glm::vec3> out;
    std::string list = text.substr(text.find('[', at) + 1);
    list.resize(list.find(']'));
    for (char& c : list)
        if (c == '(' || c == ')' || c == ',') c = ' ';
    std::istringstream numbers(list);
    for (glm::vec3 p; numbers >> p.x >> p.y >> p.z;) out.push_back(p);
    return out;
}

TEST_F(PointFiles, OfUsdHaveTimeSamplesInTheWorld)
{
    written("a.usda");
    const std::string text = read_text_file(folder_.file("a.usda"));
    EXPECT_TRUE(text.starts_with("#usda 1.0\n"));
    for (const char* word : {"upAxis = \"Z\"", "metersPerUnit = 1", "timeCodesPerSecond = 12",
                             "startTimeCode = 2", "endTimeCode = 5", "subdivisionScheme = \"none\"",
                             "UsdPreviewSurface", "material:binding"})
        EXPECT_THAT(text, ::testing::HasSubstr(word));
    const std::size_t bar = text.find("def Mesh \"Bar_"),
                      points = text.find("points.timeSamples", bar);
    for (int frame = 2; frame <= 5; ++frame) {
        const std::size_t at = text.find(" " + std::to_string(frame) + ": [", points);
        EXPECT_EQ(usd_places(text, at), bar_at(frame)) << frame;
    }
    EXPECT_EQ(std::count(text.begin(), text.end(), '{'), std::count(text.begin(), text.end(), '}'));
}

TEST_F(PointFiles, ThatAreStoppedLeaveNothing)
{
    for (const char* name : {"b.pc2", "b.mdd", "b.usda", "b.glb"}) {
        int calls = 0;
        EXPECT_THROW(written(name,
                             [&](double, std::string_view) {
                                 if (++calls > 8) throw Cancelled();
                             }),
                     Cancelled);
        EXPECT_EQ(files_named("b."), 0u) << name;
    }
}

TEST_F(PointFiles, WithoutAFolderOrAKnownEndingAreRefused)
{
    EXPECT_THROW(written("nowhere/a.pc2"), Rejected);
    EXPECT_THROW(written("a.abc"), Rejected);
}

} // namespace
} // namespace trivar
