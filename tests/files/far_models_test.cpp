// SPDX-License-Identifier: GPL-3.0-or-later
// Models far from the origin, as maps and plans of buildings have them.
#include "core/mesh/far_origin.h"
#include "core/mesh/pose.h"
#include "tests/files/text_models.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <random>

namespace trivar {
namespace {

using namespace testing;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const glm::dvec3 utm(684263.1, 5613583.1, 12);

// Points and where the file has them, to the nearest micrometre, as texts have them.
struct Written {
    std::vector<glm::dvec3> points;
    TextModel text;
};
Written random_soup(const glm::dvec3& place, double size, unsigned seed)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> anywhere(0, size);
    Written out;
    for (int v = 0; v < 30; ++v) {
        out.points.push_back(place +
                             glm::dvec3(anywhere(random), anywhere(random), anywhere(random)));
        const glm::dvec3& p = out.points.back();
        out.text.vertices.push_back(fmt::format("{:.9f} {:.9f} {:.9f}", p.x, p.y, p.z));
    }
    for (int v = 0; v < 30; v += 3) out.text.faces.push_back({v, v + 1, v + 2});
    return out;
}

// The corners of all faces where the model has them.
std::vector<glm::dvec3> corners_of(const Model& model)
{
    std::vector<glm::dvec3> out;
    const Stance stance = stance_at(model, nullptr, 0);
    for (std::size_t n = 0; n < model.nodes.size(); ++n)
        if (const int m = model.nodes[n].mesh; m >= 0)
            for (const std::uint32_t v : model.meshes[static_cast<std::size_t>(m)]->corners)
                out.emplace_back(
                    stance.to_model[n] *
                    glm::dvec4(model.meshes[static_cast<std::size_t>(m)]->positions[v], 1));
    return out;
}

double furthest(const std::vector<glm::dvec3>& a, const std::vector<glm::dvec3>& b)
{
    EXPECT_EQ(a.size(), b.size());
    double out = 0;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        out = std::max(out, glm::distance(a[i], b[i]));
    return out;
}

class FarModels : public ::testing::TestWithParam<const char*> {
protected:
    // In a PLY with numbers of that type
    static std::string file(const TextModel& model, const char* type)
    {
        std::string text = text_of(model, GetParam());
        for (std::size_t at = 0; (at = text.find("float", at)) != text.npos;)
            text.replace(at, 5, type);
        return text;
    }
};

} // namespace

TEST_P(FarModels, KeepTheirDetailWhereverTheyLie)
{
    for (const double size : {0.3, 10.0, 3000.0})
        for (const glm::dvec3& place : {utm, -utm, 1e3 * utm, glm::dvec3(0, 0, 2000 * size)}) {
            const Written far = random_soup(place, size, 1);
            const Model model = read_model_bytes(
                file(far.text, "double"), std::string("a") + GetParam(), "", {.up = UpAxis::z});
            EXPECT_LE(furthest(corners_of(model), far.points),
                      1e-5 * size + 1e-15 * glm::length(place));
            ASSERT_EQ(model.notices.size(), 1u);
            EXPECT_THAT(model.notices[0], HasSubstr("it lies"));
        }
}

TEST_P(FarModels, AreScaledAndTurnedUpWithTheirPlace)
{
    const Written far = random_soup(1000.0 * utm, 300, 2); // millimetres
    const Model model = read_model_bytes(file(far.text, "double"), std::string("a") + GetParam(),
                                         "", {.up = UpAxis::y, .scale = 1e-3});
    std::vector<glm::dvec3> expected;
    for (const glm::dvec3& p : far.points) expected.push_back(1e-3 * glm::dvec3(p.x, -p.z, p.y));
    EXPECT_LE(furthest(corners_of(model), expected), 1e-6);
}

TEST_P(FarModels, ThatAreNearEnoughStayWhereTheirVerticesSay)
{
    for (const glm::dvec3& place : {glm::dvec3(0), glm::dvec3(100, -50, 20)}) {
        const Written near = random_soup(place, 1, 3);
        const Model model = read_text_model(text_of(near.text, GetParam()), GetParam());
        EXPECT_THAT(model.notices, IsEmpty());
        EXPECT_EQ(model.nodes[0].to_parent, glm::dmat4(1));
    }
}

INSTANTIATE_TEST_SUITE_P(All, FarModels, ::testing::Values(".obj", ".ply", ".off", ".stl"));

// A place is taken from numbers of single precision without rounding, so that nothing changes.
TEST(FarModel, OfSinglePrecisionLiesToTheBitWhereTheFileHasIt)
{
    std::mt19937 random(4);
    std::uniform_real_distribution<float> anywhere(0, 3);
    std::string stl(80, ' ');
    const auto put = [&](const auto& value) {
        stl.append(reinterpret_cast<const char*>(&value), sizeof value);
    };
    put(std::uint32_t{40});
    std::vector<glm::dvec3> expected;
    for (int t = 0; t < 40; ++t) {
        put(glm::vec3(0));
        for (int i = 0; i < 3; ++i) {
            const glm::vec3 p = glm::vec3(4321.5f, -98765.4f, 0) +
                                glm::vec3(anywhere(random), anywhere(random), anywhere(random));
            put(p);
            expected.emplace_back(p);
        }
        put(std::uint16_t{0});
    }
    const Model model = read_text_model(stl, ".stl");
    ASSERT_EQ(model.notices.size(), 1u);
    EXPECT_EQ(corners_of(model), expected);
}

TEST(FarModel, BringsItsCurvesAlong)
{
    const std::string text = "v 684263.1 5613583.1 0\nv 684263.4 5613583.1 0\n"
                             "v 684263.4 5613583.3 0\nf 1 2 3\nl 1 2 3\n";
    const Model model = read_model_bytes(text, "a.obj", "", {.up = UpAxis::z});
    const Box box = bounding_box(*model.curves[0]->points, node_to_model(model, 0));
    EXPECT_NEAR(box.size().x, 0.3, 1e-6);
    EXPECT_NEAR(box.size().y, 0.2, 1e-6);
    EXPECT_NEAR(box.lo.y, 5613583.1, 1e-6);
}

TEST(FarOrigin, IsZeroUntilMoreThanAHundredThousandthOfTheSizeIsLost)
{
    const auto at = [](double x) { return Box{{x, 0, 0}, {x + 1, 1, 1}}; };
    EXPECT_EQ(far_origin(Box{}), glm::dvec3(0));
    EXPECT_EQ(far_origin(at(280)), glm::dvec3(0)); // 281 * 2^-24 / sqrt(3) < 1e-5
    EXPECT_EQ(far_origin(at(300)), glm::dvec3(300, 0, 0));
    EXPECT_EQ(far_origin(at(-1e6)), glm::dvec3(-1e6, 0, 0));
    EXPECT_EQ(far_origin(Box{{5, 5, 5}, {5, 5, 5}}), glm::dvec3(5)); // a point, to rounding
}

} // namespace trivar
