// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gpu/support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace trivar::gpu::testing {
namespace {

constexpr glm::ivec2 curve_px{160, 120};
constexpr double px_a_unit = 120 / 6.0; // of the camera below

double linear(int byte)
{
    const double c = byte / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

Curve curve_through(const std::vector<glm::vec3>& points, CurveStyle style = {})
{
    return {.line = make_ref(Polyline{points, {}}), .style = style, .id = 5};
}

// White on black, seen along +Y: x to the right, z up.
class Curves : public WithContext {
protected:
    Curves() { look_along_y(picture); }
    // A block that hides what is behind it and left of the middle.
    void hide_the_left()
    {
        Material dark;
        dark.base_color = {0.03f, 0.03f, 0.03f, 1};
        picture.instances = {
            instance_of(box_mesh({4, 1, 6}, glm::ivec3(1)), moved(-2, -3, 0), dark)};
        picture.instances[0].id = 9;
    }
    void draw(const std::vector<Curve>& curves)
    {
        picture.curves = curves;
        image = renderer.render(picture, curve_px);
    }
    // How many pixels of white a column holds.
    double white_in(int x, int channel = 1) const
    {
        double sum = 0;
        for (int y = 0; y < image.size_px.y; ++y) sum += linear(rgb_at(image, {x, y})[channel]);
        return sum;
    }
    // Returns what the curve adds to the pixels of a row, between two columns.
    std::vector<int> added(const Image& without, int y, int from, int to) const
    {
        std::vector<int> out;
        for (int x = from; x < to; ++x)
            out.push_back(std::abs(rgb_at(image, {x, y}).g - rgb_at(without, {x, y}).g));
        return out;
    }
    Picture picture;
    Renderer renderer;
    Image image;
};

TEST_F(Curves, AreAsWideAsTheyAreAskedToBeWhateverTheirSlope)
{
    for (const float width : {0.3f, 1.0f, 2.5f, 9.0f})
        for (const float slope : {0.0f, 0.4f, 1.0f}) {
            draw({curve_through({{-3, 0, -3 * slope}, {3, 0, 3 * slope}}, {.width_px = width})});
            const double across = std::sqrt(1 + double{slope} * slope) * width;
            EXPECT_NEAR(white_in(80), across, 0.06 * across + 0.08) << width << ' ' << slope;
        }
}

TEST_F(Curves, OfAWidthInTheWorldAreThinnerFartherAway)
{
    const CurveStyle half_a_unit{.width_world = 0.5f};
    draw({curve_through({{-3, 0, 0}, {3, 0, 0}}, half_a_unit)});
    EXPECT_NEAR(white_in(80), 0.5 * px_a_unit, 0.2);
    picture.camera.perspective = true;
    picture.camera.fov_y = 2 * std::atan(0.3); // as large at the target
    draw({curve_through({{-3, 0, 0}, {3, 0, 0}}, half_a_unit)});
    EXPECT_NEAR(white_in(80), 0.5 * px_a_unit, 0.2);
    draw({curve_through({{-3, 10, 0}, {3, 10, 0}}, half_a_unit)});
    EXPECT_NEAR(white_in(80), 0.25 * px_a_unit, 0.2);
    draw({curve_through({{-9, 30, 0}, {3, 0, 0}}, half_a_unit)}); // narrows as a band does
    EXPECT_NEAR(white_in(100) / white_in(70), 1.7, 0.35);
}

TEST_F(Curves, GrowWithWhatTheyBelongTo)
{
    Curve curve = curve_through({{-1, 0, 0}, {1, 0, 0}}, {.width_world = 0.25f});
    curve.to_world = glm::scale(glm::dmat4(1), glm::dvec3(2));
    draw({curve});
    EXPECT_NEAR(white_in(80), 0.5 * px_a_unit, 0.2);
    EXPECT_NEAR(white_in(80 + 35), 0.5 * px_a_unit, 0.2) << "twice as long, too";
}

TEST_F(Curves, TaperOverAShareOfTheirLengthHoweverManyPiecesTheyHave)
{
    const CurveStyle tapered{.width_px = 12, .taper = {0.5f, 0.25f}};
    std::vector<glm::vec3> many;
    for (int i = 0; i <= 60; ++i) many.emplace_back(-3 + i * 0.1f, 0, 0);
    for (const auto& points : {std::vector<glm::vec3>{{-3, 0, 0}, {3, 0, 0}}, many}) {
        draw({curve_through(points, tapered)});
        const auto width_at = [&](double share) {
            return white_in(static_cast<int>(20 + share * 120));
        };
        EXPECT_NEAR(width_at(0.25), 6, 0.4);
        EXPECT_NEAR(width_at(0.5), 12, 0.4);
        EXPECT_NEAR(width_at(0.7), 12, 0.4);
        EXPECT_NEAR(width_at(0.875), 6, 0.5);
        EXPECT_LT(width_at(0), 0.5);
        EXPECT_LT(width_at(1), 0.5);
    }
}

TEST_F(Curves, RunFromColourToColourInLinearLight)
{
    Polyline line{{{-3, 0, 0}, {0, 0, 0}, {3, 0, 0}}, {{1, 0, 0, 1}, {0, 1, 0, 1}, {0, 0, 1, 1}}};
    draw({{.line = make_ref(line), .style = {.width_px = 8}}});
    const auto color_at = [&](int x) {
        const glm::ivec3 rgb = rgb_at(image, {x, 60});
        return glm::dvec3(linear(rgb.r), linear(rgb.g), linear(rgb.b));
    };
    const auto is_near = [](const glm::dvec3& a, const glm::dvec3& b) {
        return glm::distance(a, b) < 0.04;
    };
    EXPECT_TRUE(is_near(color_at(21), {1, 0, 0}));
    EXPECT_TRUE(is_near(color_at(50), {0.5, 0.5, 0}));
    EXPECT_TRUE(is_near(color_at(80), {0, 1, 0}));
    EXPECT_TRUE(is_near(color_at(110), {0, 0.5, 0.5}));
}

TEST_F(Curves, ShowWhatIsHiddenDashedFaintOrNotAtAll)
{
    hide_the_left();
    draw({});
    const Image without = image;
    const auto hidden_of = [&](HiddenParts hidden) {
        draw({curve_through({{-3, 0, 0.1f}, {3, 0, 0.1f}}, {.width_px = 4, .hidden = hidden})});
        EXPECT_GT(added(without, 58, 100, 101)[0], 200) << "is seen on the right";
        return added(without, 58, 30, 70);
    };
    const std::vector<int> dashed = hidden_of(HiddenParts::dashed);
    int dashes = 0;
    for (std::size_t i = 1; i < dashed.size(); ++i) dashes += dashed[i] > 20 && dashed[i - 1] <= 20;
    EXPECT_NEAR(dashes, 40 / 7, 1);
    const std::vector<int> faint = hidden_of(HiddenParts::faint);
    EXPECT_GT(*std::ranges::min_element(faint), 10);
    EXPECT_LT(*std::ranges::max_element(faint), 120);
    EXPECT_LT(*std::ranges::max_element(faint) - *std::ranges::min_element(faint), 8);
    const std::vector<int> nothing = hidden_of(HiddenParts::left_out);
    EXPECT_LE(*std::ranges::max_element(nothing), 1);
}

TEST_F(Curves, ArePickedWhereTheyAreSeen)
{
    hide_the_left();
    Curve curve = curve_through({{-3, 0, 0}, {3, 0, 0}}, {.width_px = 6});
    draw({curve});
    EXPECT_EQ(renderer.pick({110, 60}), 5);
    EXPECT_EQ(renderer.pick({110, 70}), 0);
    EXPECT_EQ(renderer.pick({50, 60}), 9) << "behind the block";
    curve.id = 0;
    draw({curve});
    EXPECT_EQ(renderer.pick({110, 60}), 0);
}

TEST_F(Curves, HideEachOtherByDistanceWhateverTheirOrder)
{
    Curve near = curve_through({{-3, -1, 0}, {3, -1, 0}}, {.width_px = 10});
    Curve far = curve_through({{0, 1, -3}, {0, 1, 3}}, {.width_px = 10});
    near.line = make_ref(Polyline{near.line->points, {{1, 0, 0, 1}}});
    far.line = make_ref(Polyline{far.line->points, {{0, 0, 1, 1}}});
    far.id = 6;
    for (const bool far_first : {false, true}) {
        draw(far_first ? std::vector{far, near} : std::vector{near, far});
        EXPECT_EQ(renderer.pick({80, 60}), 5);
        EXPECT_EQ(rgb_at(image, {80, 60}), glm::ivec3(255, 0, 0));
        EXPECT_EQ(renderer.pick({80, 40}), 6);
    }
}

TEST_F(Curves, HideWhatOneSeesThroughBehindThem)
{
    picture.instances = {
        instance_of(plane_mesh({5, 5}, {1, 1}), glm::rotate(moved(0, 2, 0), 1.57, {1, 0, 0}))};
    picture.instances[0].opacity = 0.5f;
    const Curve curve = curve_through({{-3, 0, 0}, {3, 0, 0}}, {.width_px = 8});
    draw({curve});
    EXPECT_EQ(rgb_at(image, {80, 60}), glm::ivec3(255));
    picture.instances[0].to_world[3].y = -2;
    draw({curve});
    EXPECT_LT(rgb_at(image, {80, 60}).g, 250);
}

TEST_F(Curves, CoverNothingTwiceAtTheirCorners)
{
    std::vector<glm::vec3> zigzag;
    for (int i = 0; i < 9; ++i)
        zigzag.emplace_back(-3 + 0.7f * static_cast<float>(i), 0, i % 2 ? 1.2f : -1.0f);
    Polyline line{zigzag, {{1, 1, 1, 0.25f}}};
    draw({{.line = make_ref(line), .style = {.width_px = 9}}});
    int brightest = 0, full = 0;
    for (int y = 0; y < curve_px.y; ++y)
        for (int x = 0; x < curve_px.x; ++x) {
            const int here = rgb_at(image, {x, y}).g;
            brightest = std::max(brightest, here);
            full += std::abs(linear(here) - 0.25) < 0.01;
        }
    EXPECT_NEAR(linear(brightest), 0.25, 0.01);
    EXPECT_GT(full, 2000);
}

TEST_F(Curves, OnASurfaceShowTheirWholeWidthWhereItTurnsAway)
{
    // A cylinder along X; the curve lies along it, half a right angle above the side that is seen.
    picture.instances = {
        instance_of(cylinder_mesh(1, 8, 96, 1), glm::rotate(glm::dmat4(1), 1.5708, {0, 1, 0}))};
    const float at = std::sqrt(0.5f);
    draw({});
    const double before = white_in(80);
    draw({curve_through({{-3, -at, at}, {3, -at, at}},
                        {.width_px = 5, .hidden = HiddenParts::left_out})});
    double white = 0;
    for (int y = 0; y < curve_px.y; ++y) white += rgb_at(image, {80, y}).g > 250;
    EXPECT_NEAR(white, 5, 1);
    EXPECT_NE(white_in(80), before);
}

TEST_F(Curves, MayBeNowhere)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    Curve placeless = curve_through({{0, 0, 0}, {1, 0, 0}});
    placeless.to_world[3].x = std::numeric_limits<double>::infinity();
    draw({Curve{}, curve_through({}), curve_through({{nan, 0, 0}, {nan, nan, 0}}), placeless});
    EXPECT_EQ(white_in(80), 0);
    draw({curve_through({{-3, 0, 0}, {-1, 0, 0}, {0, nan, 0}, {1, 0, 0}, {3, 0, 0}})});
    EXPECT_GT(white_in(40), 1);
    EXPECT_EQ(white_in(80), 0) << "the gap";
    EXPECT_GT(white_in(120), 1);
}

// Some clippers interpolate badly between ends of very different distances.
TEST_F(Curves, AreNoThinnerWhereTheyGoOnBehindTheEye)
{
    picture.camera.perspective = true;
    for (const CurveStyle& style : {CurveStyle{.width_px = 3}, CurveStyle{.width_world = 0.2f}})
        for (const float end : {-9.9f, -9.99f, -10.1f, -30.0f}) {
            draw({curve_through({{0, 20, -2}, {0.2f, -9, -2}}, style)});
            const double before = white_in(80) + white_in(81) + white_in(82);
            draw({curve_through({{0, 20, -2}, {0.2f * (20 - end) / 29, end, -2}}, style)});
            EXPECT_NEAR(white_in(80) + white_in(81) + white_in(82), before, 0.1);
        }
}

TEST_F(Curves, PassBesideAndBehindTheEye)
{
    picture.camera.perspective = true;
    for (const CurveStyle& style : {CurveStyle{.width_px = 3}, CurveStyle{.width_world = 0.2f}}) {
        draw({curve_through({{0, 20, -2}, {0.2f, -30, -2}, {3, -40, 5}}, style)});
        int bright = 0;
        for (int x = 0; x < curve_px.x; ++x) bright += white_in(x) > 1;
        EXPECT_GT(bright, 1);
        EXPECT_LT(bright, 60) << "it is not smeared over the picture";
    }
}

TEST_F(Curves, AreAsWideInADraftOfHalfTheSize)
{
    picture.draft = true;
    const Curve curve = curve_through({{-3, 0, 0}, {3, 0, 0}}, {.width_px = 6});
    draw({curve});
    EXPECT_NEAR(white_in(80), 6, 0.3);
    picture.scale = 0.5;
    draw({curve});
    EXPECT_NEAR(white_in(40), 3, 0.3);
    EXPECT_EQ(renderer.pick({110, 60}), 5);
}

TEST_F(Curves, HaveAnOutlineWhereTheyAreHighlighted)
{
    Curve curve = curve_through({{-3, 0, 0}, {3, 0, 0}}, {.width_px = 4});
    picture.outline = {.color = {1, 0, 0, 1}, .width_px = 3};
    draw({curve});
    EXPECT_EQ(rgb_at(image, {80, 56}).r, 0);
    curve.highlighted = true;
    draw({curve});
    EXPECT_EQ(rgb_at(image, {80, 60}), glm::ivec3(255));
    EXPECT_GT(rgb_at(image, {80, 56}).r, 200);
    EXPECT_EQ(rgb_at(image, {80, 50}).r, 0);
}

TEST_F(Curves, LookTheSameFarFromTheOrigin)
{
    Curve curve = curve_through({{-3, 0, 0}, {0, 0, 1}, {3, 0, 0}}, {.width_world = 0.3f});
    draw({curve});
    const Image here = image;
    const glm::dvec3 away(0, 0, 1 << 20);
    picture.camera.eye += away;
    picture.camera.target += away;
    curve.to_world = moved(away.x, away.y, away.z);
    draw({curve});
    EXPECT_EQ(image.rgba, here.rgba);
}

TEST_F(Curves, ArePickedAFewPixelsBesideThem)
{
    draw({curve_through({{-3, 0, 0}, {3, 0, 0}}, {.width_px = 1})});
    EXPECT_EQ(renderer.pick({80, 65}), 0);
    EXPECT_EQ(renderer.pick_near({80, 65}, 6), 5);
    EXPECT_EQ(renderer.pick_near({80, 68}, 6), 0);
    EXPECT_EQ(renderer.pick_near({-1, 60}, 6), 0);
    EXPECT_EQ(renderer.pick_in({78, 64}, {82, 70}), std::vector<int>{}) << "a box is exact";
}

TEST_F(Curves, AreNotPickedBesideWhatLiesInFrontOfThem)
{
    hide_the_left();
    const CurveStyle thin{.width_px = 1};
    draw({curve_through({{0.05f, 0, -3}, {0.05f, 0, 3}}, thin)}); // beside the block's edge
    EXPECT_EQ(renderer.pick_near({77, 60}, 6), 9);
    EXPECT_EQ(renderer.pick_near({84, 60}, 6), 5);
    draw({curve_through({{0.05f, -3.5f, -3}, {0.05f, -3.5f, 3}}, thin)}); // at its front
    EXPECT_EQ(renderer.pick_near({77, 60}, 6), 5);
    EXPECT_EQ(renderer.pick_near({70, 60}, 6), 9);
}

} // namespace
} // namespace trivar::gpu::testing
