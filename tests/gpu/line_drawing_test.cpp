// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gpu/support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace trivar::gpu::testing {
namespace {

constexpr glm::ivec2 drawing_px{160, 120}; // 20 pixels a unit
constexpr float unbounded = std::numeric_limits<float>::infinity();

// White lines on black, seen along +Y: x to the right, z up.
class LineDrawings : public WithContext {
protected:
    LineDrawings() { look_along_y(picture); }
    static Curve curve(const std::vector<glm::vec3>& points, const CurveStyle& style, int id)
    {
        return {.line = make_ref(Polyline{points, {}}), .style = style, .id = id};
    }
    // A ball of a few triangles, dark, of one id.
    void add_ball(int id, const glm::dvec3& at)
    {
        Material dark;
        dark.base_color = {0.02f, 0.02f, 0.02f, 1};
        picture.instances.push_back(
            instance_of(sphere_mesh(2, 8, 6), moved(at.x, at.y, at.z), dark));
        picture.instances.back().id = id;
    }
    // A ring about the view in a plane.
    static std::vector<glm::vec3> ring(float radius, float y)
    {
        std::vector<glm::vec3> out;
        for (int i = 0; i <= 64; ++i) {
            const float a = 2 * std::acos(-1.0f) * static_cast<float>(i % 64) / 64;
            out.emplace_back(radius * std::cos(a), y, radius * std::sin(a));
        }
        return out;
    }
    // How many of the points of a ring are white in the picture.
    int white_on(float radius) const
    {
        int out = 0;
        for (const glm::vec3& p : ring(radius, 0))
            out += rgb_at(image, {static_cast<int>(80 + 20 * p.x), static_cast<int>(60 - 20 * p.z)})
                       .g > 160;
        return out;
    }
    void draw() { image = renderer.render(picture, drawing_px); }
    Picture picture;
    Renderer renderer;
    Image image;
};

TEST_F(LineDrawings, HaveDashesOfOneLengthHoweverManyPiecesALineHas)
{
    std::vector<glm::vec3> many;
    for (int i = 0; i <= 90; ++i) many.emplace_back(-3 + 6 * std::pow(i / 90.0f, 1.7f), 0, 0);
    const CurveStyle dashed{.width_px = 4, .hidden = HiddenParts::as_seen, .dash_px = 6};
    std::vector<Image> images;
    for (const auto& points : {std::vector<glm::vec3>{{-3, 0, 0}, {3, 0, 0}}, many}) {
        picture.curves = {curve(points, dashed, 5)};
        draw();
        images.push_back(image);
        for (int x = 21; x < 139; ++x) { // each dash and each gap has 6 pixels
            const bool on = (x - 20) / 6 % 2 == 0;
            const bool between = (x - 20) % 6 == 0 || (x - 20) % 6 == 5; // rounding
            EXPECT_TRUE(between || (rgb_at(image, {x, 60}).g > 128) == on) << x;
        }
    }
    for (int x = 20; x < 140; ++x)
        EXPECT_NEAR(rgb_at(images[0], {x, 60}).g, rgb_at(images[1], {x, 60}).g, 40) << x;
    picture.curves.clear();
    add_ball(9, {0, -4, 0}); // what hides a line that is dashed by itself changes nothing
    picture.curves = {curve({{-3, 0, 0}, {3, 0, 0}}, dashed, 5)};
    draw();
    for (int x = 20; x < 140; ++x)
        EXPECT_EQ(rgb_at(images[0], {x, 60}).g > 150, rgb_at(image, {x, 60}).g > 150) << x;
}

TEST_F(LineDrawings, HaveNoRimWhereOneLiesOverTheOther)
{
    const CurveStyle wide{.width_px = 5.4f, .as_ink = true};
    picture.curves = {curve({{-3, -1, 0}, {3, -1, 0}}, wide, 5),
                      curve({{-3, 0, -0.15f}, {3, 0, -0.15f}}, wide, 6)};
    draw();
    for (int y = 58; y < 65; ++y) EXPECT_GT(rgb_at(image, {80, y}).g, 250) << y;
    EXPECT_EQ(renderer.pick({80, 60}), 5);
    EXPECT_EQ(renderer.pick({80, 64}), 6);
    picture.curves = {
        curve({{-3, 0, 0.025f}, {3, 0, 0.025f}}, {.width_px = 0.8f, .as_ink = true}, 5)};
    draw();
    EXPECT_EQ(renderer.pick({80, 59}), 5) << "also what covers no pixel wholly";
}

TEST_F(LineDrawings, LookAsThickAsTheyAreOnBlackAndOnWhite)
{
    // Returns how much of a line across pixels is seen in their bytes, in pixels.
    const auto thickness = [&](float color, const glm::vec3& paper) {
        picture.backdrop = Backdrop{paper, paper, paper, 0};
        const glm::vec4 ink(color, color, color, 1);
        const Polyline line{{{-3, 0, 0.02f}, {3, 0, 0.02f}}, {ink, ink}};
        picture.curves = {
            {.line = make_ref(line), .style = {.width_px = 1.3f, .as_ink = true}, .id = 5}};
        draw();
        float out = 0;
        for (int y = 50; y < 70; ++y)
            out += std::abs(static_cast<float>(rgb_at(image, {80, y}).g) / 255 - paper.g);
        return out;
    };
    EXPECT_NEAR(thickness(0, glm::vec3(1)), 1.3, 0.2);
    EXPECT_NEAR(thickness(1, glm::vec3(0)), 1.3, 0.2);
}

TEST_F(LineDrawings, AreNotHiddenByTheSurfaceOfTheirOwnObjectWhereTheyAreKnownToBeSeen)
{
    add_ball(7, {0, 0, 0});
    const auto seen = [&](float reach, int id) {
        picture.curves = {
            curve(ring(1.2f, 1),
                  {.width_px = 4, .hidden = HiddenParts::left_out, .own_reach_world = reach}, id)};
        draw();
        return white_on(1.2f);
    };
    EXPECT_EQ(seen(0, 7), 0) << "it lies in the ball";
    EXPECT_EQ(seen(unbounded, 7), 65);
    EXPECT_EQ(seen(0.1f, 7), 0) << "farther in than that";
    EXPECT_EQ(seen(unbounded, 8), 0) << "of another object";
    EXPECT_EQ(renderer.pick({80 + 24, 60}), 7);
    add_ball(9, {2, -5, 0}); // another object hides it all the same
    const int left = seen(unbounded, 7);
    EXPECT_GT(left, 15);
    EXPECT_LT(left, 50);
}

TEST_F(LineDrawings, LieOnPaperOfTheColorThatWasChosen)
{
    picture.camera.perspective = true;
    for (const char* look : {"studio", "clay", "dark", "paper", "black"})
        for (const int samples : {1, 4, 16})
            for (const glm::ivec3 rgb : {glm::ivec3(255), glm::ivec3(255, 0, 0), glm::ivec3(0),
                                         glm::ivec3(241, 34, 137)}) {
                picture.instances.clear();
                add_ball(7, {0, 0, 0});
                picture.instances[0].flat_color = glm::vec3(rgb) / 255.0f;
                picture.settings.look = look;
                picture.settings.exposure = 1.5f;
                picture.samples = samples;
                draw();
                for (const glm::ivec2 at : {glm::ivec2(80, 60), glm::ivec2(64, 51),
                                            glm::ivec2(90, 77), glm::ivec2(71, 66)})
                    EXPECT_EQ(rgb_at(image, at), rgb) << look << ' ' << samples;
            }
}

TEST_F(LineDrawings, LeaveWhitePaperWhite)
{
    picture.backdrop.reset();
    picture.settings.look = "paper";
    picture.settings.ground = true;
    picture.camera.perspective = true;
    picture.camera.eye = {2, -9, 5};
    add_ball(7, {0, 0, 0});
    picture.instances[0].flat_color = glm::vec3(1);
    for (const int samples : {1, 4, 16}) {
        picture.samples = samples;
        picture.draft = samples == 1;
        draw();
        int other = 0;
        for (int y = 0; y < drawing_px.y; ++y)
            for (int x = 0; x < drawing_px.x; ++x)
                other += rgb_at(image, {x, y}) != glm::ivec3(255);
        EXPECT_EQ(other, 0) << samples;
    }
}

TEST_F(LineDrawings, LieOverTheOutlineOfWhatIsSelected)
{
    add_ball(7, {0, 0, 0});
    picture.instances[0].highlighted = true;
    picture.outline = {.color = {1, 0, 0, 1}, .halo = {0, 0, 0, 0}, .width_px = 6};
    draw();
    const auto edge = [&](int beside) { return rgb_at(image, {80 + 40 + beside, 60}); };
    ASSERT_EQ(edge(3), glm::ivec3(255, 0, 0));
    picture.curves = {curve({{2.15f, -1, -2}, {2.15f, -1, 2}}, {.width_px = 2}, 8)};
    draw();
    for (const int beside : {2, 3}) { // nothing of the outline's red
        EXPECT_GT(edge(beside).r, 220);
        EXPECT_EQ(edge(beside), glm::ivec3(edge(beside).r));
    }
    EXPECT_EQ(edge(5), glm::ivec3(255, 0, 0));
    EXPECT_EQ(edge(0), glm::ivec3(255, 0, 0));
    picture.curves[0].style.width_px = 0;        // nothing there: no gap
    picture.curves[0].to_world = moved(0, 9, 0); // behind the ball
    picture.curves[0].line = make_ref(Polyline{{{0, 0, 0}, {1, 0, 0}}, {}});
    draw();
    EXPECT_EQ(edge(3), glm::ivec3(255, 0, 0));
}

} // namespace
} // namespace trivar::gpu::testing
