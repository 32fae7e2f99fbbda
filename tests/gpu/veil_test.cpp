// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gpu/support.h"

#include <algorithm>
#include <limits>

namespace trivar::gpu::testing {

class Veils : public WithContext {
protected:
    Renderer renderer;
};

const glm::vec4 red{0.9f, 0.05f, 0.05f, 0.6f}, green{0.05f, 0.8f, 0.05f, 0.6f};
const glm::ivec2 size_px(48, 48), middle(24, 24);

Picture from(double y)
{
    Picture picture;
    picture.camera.eye = {0, y, 0};
    picture.camera.target = {0, 0, 0};
    picture.samples = 1;
    return picture;
}

// A square across the y axis with its front towards the sign of `facing`.
Translucent sheet(float y, glm::vec4 color, float facing = -1, float half = 0.8f)
{
    Translucent veil;
    veil.points = {{-half, y, -half}, {half, y, -half}, {half, y, half}, {-half, y, half}};
    veil.colors = {color};
    veil.triangles = {0, 1, 2, 0, 2, 3};
    if (facing > 0) std::ranges::reverse(veil.triangles);
    return veil;
}

// Encodes linear light as bytes.
glm::vec3 encoded(glm::vec4 linear)
{
    return 255.0f * (1.055f * glm::pow(glm::vec3(linear), glm::vec3(1 / 2.4f)) - 0.055f);
}

constexpr int rounding = 2; // of half floats, in steps of 8 bits

int largest_difference(const Image& a, const Image& b)
{
    int most = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i)
        most = std::max(most, std::abs(a.rgba[i] - b.rgba[i]));
    return most;
}

TEST_F(Veils, LookTheSameInWhateverOrderTheyAreGiven)
{
    Picture picture = from(-5);
    picture.camera.eye = {2, -4, 3};
    picture.instances = {instance_of(sphere_mesh(0.5, 24, 12))};
    for (int i = 0; i < 12; ++i)
        picture.translucent.push_back(sheet(static_cast<float>(i % 7) * 0.3f - 1,
                                            glm::mix(red, green, i / 11.0f), i % 2 ? 1.0f : -1.0f,
                                            0.4f + 0.05f * static_cast<float>(i)));
    const Image first = renderer.render(picture, {96, 96});
    std::ranges::reverse(picture.translucent);
    EXPECT_LE(largest_difference(first, renderer.render(picture, {96, 96})), rounding);
    // All in one, its triangles mixed.
    Translucent all;
    for (const Translucent& veil : picture.translucent) {
        const auto base = static_cast<std::uint32_t>(all.points.size());
        for (std::uint32_t i : veil.triangles) all.triangles.push_back(base + i);
        all.points.insert(all.points.end(), veil.points.begin(), veil.points.end());
        all.colors.insert(all.colors.end(), 4, veil.colors.front());
    }
    for (std::size_t t = 0; t + 6 <= all.triangles.size(); t += 12)
        std::swap_ranges(all.triangles.begin() + static_cast<std::ptrdiff_t>(t),
                         all.triangles.begin() + static_cast<std::ptrdiff_t>(t) + 3,
                         all.triangles.end() - static_cast<std::ptrdiff_t>(t) - 3);
    picture.translucent = {all};
    EXPECT_LE(largest_difference(first, renderer.render(picture, {96, 96})), rounding);
}

// The exact colour of either order is known; helpers are mixed as encoded colours.
TEST_F(Veils, CoverWhatIsBehindThemFromEitherSide)
{
    for (const double side : {-1.0, 1.0}) {
        Picture picture = from(5 * side);
        const float facing = side < 0 ? -1.0f : 1.0f;
        picture.translucent = {sheet(-1, red, facing), sheet(1, green, facing)};
        const Image image = renderer.render(picture, size_px);
        const glm::vec4 near = side < 0 ? red : green, far = side < 0 ? green : red;
        picture.translucent.clear();
        const auto behind = glm::vec3(rgb_at(renderer.render(picture, size_px), middle));
        const glm::vec3 one = glm::mix(behind, encoded(far), far.a);
        const glm::vec3 both = glm::mix(one, encoded(near), near.a);
        const glm::ivec3 seen = rgb_at(image, middle);
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(seen[k], both[k], 2) << k << " from " << side;
    }
}

TEST_F(Veils, AreFainterFromBehindAndFainterStillBehindWhatIsSolid)
{
    Picture picture = from(-5);
    const auto red_of = [&](float facing, bool hidden) {
        picture.translucent = {sheet(1, {1, 0, 0, 0.5f}, facing)};
        picture.instances.clear();
        if (hidden) picture.instances = {instance_of(sphere_mesh(0.6, 48, 24))};
        const glm::ivec3 with = rgb_at(renderer.render(picture, size_px), middle);
        picture.translucent.clear();
        return with.g - rgb_at(renderer.render(picture, size_px), middle).g; // red takes green away
    };
    EXPECT_LT(red_of(-1, false), red_of(1, false));
    EXPECT_LT(red_of(1, false), 0);
    EXPECT_LT(red_of(-1, false), red_of(-1, true) - 20);
    EXPECT_LT(red_of(-1, true), 0);
}

TEST_F(Veils, LeaveTheRestOfThePictureAlone)
{
    Picture picture = from(-5);
    picture.instances = {instance_of(sphere_mesh(0.5, 24, 12))};
    picture.instances[0].id = 4;
    const Image before = renderer.render(picture, size_px);
    const float nowhere = std::numeric_limits<float>::quiet_NaN();
    Translucent broken = sheet(0, red);
    broken.points[2].x = nowhere;
    broken.triangles.insert(broken.triangles.end(), {0, 1, 900, 7});
    picture.translucent = {broken, Translucent{}};
    EXPECT_EQ(renderer.render(picture, size_px).rgba, before.rgba);
    picture.translucent = {sheet(-1, red, -1, 0.2f)};
    const Image after = renderer.render(picture, size_px);
    EXPECT_NE(rgb_at(after, middle), rgb_at(before, middle));
    EXPECT_EQ(rgb_at(after, {2, 2}), rgb_at(before, {2, 2}));
    EXPECT_EQ(renderer.pick(middle), 4);
}

Instance pane(float y, glm::vec3 color, float opacity)
{
    const Translucent square = sheet(y, red);
    Mesh mesh;
    mesh.positions = square.points;
    mesh.corners = {0, 1, 2, 3};
    mesh.face_begin = {0, 4};
    Material glass;
    glass.base_color = glm::vec4(color, opacity);
    glass.alpha = Material::Alpha::blend;
    glass.double_sided = true;
    return instance_of(std::move(mesh), glm::dmat4(1), glass);
}

TEST_F(Veils, ShowEveryLayerOfABlendedMaterialInOrder)
{
    // Two panes, one behind the other, given in either order.
    const auto seen = [&](double side, bool swapped) {
        Picture picture = from(5 * side);
        picture.settings.shadows = false;
        picture.instances = {pane(-0.5f, red, 0.5f), pane(0.5f, green, 0.5f)};
        if (swapped) std::swap(picture.instances[0], picture.instances[1]);
        return rgb_at(renderer.render(picture, size_px), middle);
    };
    for (const double side : {-1.0, 1.0})
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(seen(side, false)[c], seen(side, true)[c], 1);
    EXPECT_GT(seen(-1, false).r, seen(-1, false).g + 10); // the nearer one counts for more
    EXPECT_GT(seen(1, false).g, seen(1, false).r + 10);
    EXPECT_GT(seen(-1, false).g, seen(-1, false).b + 10); // but both are there
    EXPECT_GT(seen(1, false).r, seen(1, false).b + 10);
}

} // namespace trivar::gpu::testing
