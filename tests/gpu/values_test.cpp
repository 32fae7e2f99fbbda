// SPDX-License-Identifier: GPL-3.0-or-later
#include "gpu/color_map.h"
#include "tests/gpu/support.h"

#include <cmath>

namespace trivar::gpu::testing {

class Values : public WithContext {
protected:
    Renderer renderer;
};

float lightness(glm::vec3 c) // of OKLab
{
    const float l = std::cbrt(0.4122214708f * c.r + 0.5363325363f * c.g + 0.0514459929f * c.b);
    const float m = std::cbrt(0.2119034982f * c.r + 0.6806995451f * c.g + 0.1073969566f * c.b);
    const float s = std::cbrt(0.0883024619f * c.r + 0.2817188376f * c.g + 0.6299787005f * c.b);
    return 0.2104542553f * l + 0.7936177850f * m - 0.0040720468f * s;
}

TEST(ColorMap, IsOrderedByLightnessInEvenSteps)
{
    for (int i = 0; i < 32; ++i) {
        const float t = static_cast<float>(i) / 32, next = t + 1.0f / 32;
        EXPECT_NEAR(lightness(sequential_color(next)) - lightness(sequential_color(t)), 0.63f / 32,
                    0.012f);
        for (const float side : {-1.0f, 1.0f})
            EXPECT_LT(lightness(diverging_color(side * next)),
                      lightness(diverging_color(side * t)));
        EXPECT_NEAR(lightness(diverging_color(t)), lightness(diverging_color(-t)), 0.03f);
    }
}

// The colours differ to an eye without one kind of cones: blue and rust stay apart, for they differ
// along the axis that red-green blindness leaves, and the fold's magenta is neither.
TEST(ColorMap, KeepsItsSidesApartByMoreThanRedAndGreen)
{
    const glm::vec3 less = diverging_color(-1), more = diverging_color(1);
    EXPECT_GT(less.b - (less.r + less.g) / 2, 0.1f);
    EXPECT_LT(more.b - (more.r + more.g) / 2, -0.05f);
    for (const bool stripe : {false, true})
        for (int i = -16; i <= 16; ++i)
            EXPECT_GT(
                glm::distance(diverging_color(static_cast<float>(i) / 16), folded_color(stripe)),
                0.25f);
}

glm::vec3 linear(glm::ivec3 bytes)
{
    glm::vec3 out;
    for (int k = 0; k < 3; ++k) {
        const float x = static_cast<float>(bytes[k]) / 255;
        out[k] = x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
    }
    return out;
}

// A square that faces the camera, all with one value.
Picture square(float value)
{
    Mesh mesh;
    mesh.positions = {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}};
    add_face(mesh, std::array<std::uint32_t, 4>{0, 1, 2, 3});
    Picture picture;
    picture.camera.eye = {0, -3, 0};
    picture.instances = {instance_of(std::move(mesh))};
    picture.instances[0].values = make_ref(std::vector<float>(4, value));
    picture.value_colors = ValueColors{};
    return picture;
}

TEST_F(Values, ShowTheirColorAtMoreThanThreeFifthsOfItsLightAndNeverMore)
{
    const auto seen = [&](float value) {
        return linear(rgb_at(renderer.render(square(value), {32, 32}), {16, 16}));
    };
    for (const float stops : {-1.0f, -0.4f, 0.0f, 0.7f, 1.0f}) {
        const glm::vec3 color = diverging_color(stops), shown = seen(std::exp2(stops));
        const float share = shown.g / color.g;
        EXPECT_GT(share, 0.61f);
        EXPECT_LT(share, 1.02f);
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(shown[k], color[k] * share, 0.02f) << stops;
    }
    EXPECT_LT(glm::distance(seen(2), seen(64)), 0.01f) << "beyond the range as at its end";
}

TEST_F(Values, AreHatchedWhereSpaceIsFolded)
{
    for (const float value : {0.0f, -0.7f}) {
        const Image image = renderer.render(square(value), {48, 48});
        int stripes = 0;
        for (int x = 9; x < 39; ++x) {
            const glm::ivec3 c = rgb_at(image, {x, 24});
            EXPECT_GT(c.r, c.g + 20); // magenta
            EXPECT_GT(c.b, c.g + 20);
            stripes += std::abs(c.g - rgb_at(image, {x - 1, 24}).g) > 25 ? 1 : 0;
        }
        EXPECT_GE(stripes, 4);
    }
}

TEST_F(Values, OfAnotherNumberOfVerticesAreNotShownAndWhatHasNoneIsGrey)
{
    Picture picture = square(1);
    picture.instances[0].values = nullptr;
    const Image plain = renderer.render(picture, {32, 32});
    picture.instances[0].values = make_ref(std::vector<float>(3, 1.0f));
    EXPECT_EQ(renderer.render(picture, {32, 32}).rgba, plain.rgba);
    const glm::vec3 grey = linear(rgb_at(plain, {16, 16}));
    EXPECT_LT(std::abs(grey.r - grey.b), 0.06f);
    picture.value_colors.reset();
    EXPECT_NE(renderer.render(picture, {32, 32}).rgba, plain.rgba);
}

TEST_F(Values, SolidStuffsStretchWithTheBodyThatTheyFill)
{
    const auto slab = [](float width) {
        Mesh mesh;
        mesh.positions = {{-width, 0, -1}, {width, 0, -1}, {width, 0, 1}, {-width, 0, 1}};
        add_face(mesh, std::array<std::uint32_t, 4>{0, 1, 2, 3});
        return mesh;
    };
    for (const Filling filling : {Filling::wood, Filling::flesh, Filling::metal}) {
        Material material;
        material.filling = filling;
        Picture picture;
        picture.settings.shadows = picture.settings.ambient_occlusion = false;
        picture.settings.ground = false;
        picture.camera.eye = {0, -9, 0};
        picture.camera.perspective = false;
        const glm::ivec2 size(640, 320);
        const auto drawn = [&](const Mesh& mesh, Ref<Mesh> rest) {
            picture.instances = {instance_of(mesh, glm::dmat4(1), material)};
            picture.instances[0].rest = std::move(rest);
            return renderer.render(picture, size);
        };
        const Ref<Mesh> rest = make_ref(slab(1));
        const Image before = drawn(*rest, nullptr), after = drawn(slab(2), rest),
                    apart = drawn(slab(2), nullptr);
        int differs = 0, differ_by = 0, apart_differ_by = 0, varies = 0;
        for (int x = -60; x <= 60; x += 4)
            for (int z = -60; z <= 60; z += 20) {
                const glm::ivec3 here = rgb_at(before, {320 + x, 160 + z});
                const auto away = [&](const Image& image) {
                    return std::abs(here.g - rgb_at(image, {320 + 2 * x, 160 + z}).g);
                };
                differs += away(after) > 24 ? 1 : 0;
                differ_by += away(after);
                apart_differ_by += away(apart);
                varies += std::abs(here.g - rgb_at(before, {320, 160}).g) > 4 ? 1 : 0;
            }
        EXPECT_LT(differs, 20) << "of 217, where a pixel is half as wide";
        EXPECT_GT(varies, 50);
        EXPECT_GT(apart_differ_by, differ_by);
    }
}

} // namespace trivar::gpu::testing
