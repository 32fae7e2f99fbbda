// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/golden/pictures.h"
#include "tests/gpu/support.h"

#include <cmath>
#include <glm/gtc/constants.hpp>

namespace trivar::gpu::testing {

using trivar::testing::matches_picture;

class GoldenPictures : public WithContext {
protected:
    Renderer renderer;
};

Material painted(glm::vec3 color, float roughness, float metallic = 0)
{
    Material material;
    material.base_color = glm::vec4(color, 1);
    material.roughness = roughness;
    material.metallic = metallic;
    return material;
}

// A teapot among a ball, a brass ring, a block and a band.
Picture still_life()
{
    Picture picture;
    Material both_sides = painted({0.13f, 0.22f, 0.39f}, 0.4f);
    both_sides.double_sided = true;
    const auto turned = [](double x, double y, double z, double angle) {
        return glm::rotate(moved(x, y, z), angle, glm::dvec3(0, 0, 1));
    };
    picture.instances = {
        instance_of(teapot_mesh(1, 10), glm::dmat4(1), painted({0.093f, 0.30f, 0.32f}, 0.22f)),
        instance_of(sphere_mesh(0.55, 64, 32), moved(1.9, 0.3, 0.55),
                    painted({0.47f, 0.18f, 0.12f}, 0.42f)),
        instance_of(torus_mesh(0.55, 0.2, {64, 32}), moved(-1.9, 0.1, 0.2),
                    painted({0.62f, 0.41f, 0.15f}, 0.25f, 1)),
        instance_of(box_mesh({0.85, 0.85, 0.85}, {1, 1, 1}), turned(0.7, 1.9, 0.425, 0.5),
                    painted({0.71f, 0.65f, 0.55f}, 0.5f)),
        instance_of(moebius_mesh(0.55, 0.4, {96, 8}), moved(-1.0, 2.0, 0.6), both_sides)};
    picture.camera.eye = {1.2, -6.4, 2.9};
    picture.camera.target = {0, 0.6, 0.45};
    picture.camera.fov_y = 0.46;
    picture.settings.sun_azimuth = -2.1;
    picture.settings.sun_elevation = 0.84;
    return picture;
}

TEST_F(GoldenPictures, OfAStillLifeInTheStudio)
{
    EXPECT_TRUE(matches_picture(renderer.render(still_life(), {480, 270}),
                                "tests/golden/still_life_studio.png"));
}

TEST_F(GoldenPictures, OfAStillLifeInClay)
{
    Picture picture = still_life();
    picture.settings.look = "clay";
    EXPECT_TRUE(
        matches_picture(renderer.render(picture, {480, 270}), "tests/golden/still_life_clay.png"));
}

TEST_F(GoldenPictures, OfAStillLifeInTheDark)
{
    Picture picture = still_life();
    picture.settings.look = "dark";
    EXPECT_TRUE(
        matches_picture(renderer.render(picture, {480, 270}), "tests/golden/still_life_dark.png"));
}

// While something is dragged: a draft with grid, a ghost, an outline and a line that dives.
TEST_F(GoldenPictures, OfWorkInProgress)
{
    Picture picture = still_life();
    picture.draft = picture.grid = true;
    picture.instances[0].highlighted = true;
    picture.instances[1].opacity = 0.45f;
    Line line;
    for (int i = 0; i <= 64; ++i) {
        const double a = i * 0.1;
        line.points.emplace_back(2.2 * std::cos(a), 0.8 + 1.5 * std::sin(a),
                                 0.5 + 0.3 * std::sin(3 * a));
    }
    line.color = {0.01f, 0.58f, 0.81f, 1};
    picture.lines = {line};
    EXPECT_TRUE(
        matches_picture(renderer.render(picture, {480, 270}), "tests/golden/work_in_progress.png"));
}

// How far from its axis a vase is at a height from 0 to 1.
double of_vase(double height)
{
    return 0.24 + 0.16 * std::sin(5.2 * height + 0.1) * (1 - 0.35 * height);
}

glm::vec3 on_vase(double turn, double height)
{
    const double angle = 2 * glm::pi<double>() * turn, r = of_vase(height);
    return {r * std::cos(angle), r * std::sin(angle), height};
}

// The wires round a ball are rings in one colour and ribs in another.
TEST_F(GoldenPictures, OfAVaseOfWire)
{
    Picture picture;
    picture.instances = {instance_of(sphere_mesh(0.22, 48, 24), moved(0, 0, 0.4),
                                     painted({0.55f, 0.53f, 0.5f}, 0.5f)),
                         instance_of(plane_mesh({8, 8}, {1, 1}), moved(0, 0, 0),
                                     painted({0.3f, 0.29f, 0.28f}, 0.85f))};
    const auto add = [&](int count, const glm::vec4& color, const auto& line_of) {
        for (int i = 0; i < count; ++i) {
            Polyline line{{}, {color}};
            for (int k = 0; k <= 48; ++k) line.points.push_back(line_of(i, k / 48.0));
            picture.curves.push_back({.line = make_ref(std::move(line)),
                                      .style = {.width_px = 1.6f, .hidden = HiddenParts::left_out},
                                      .id = 3});
        }
    };
    add(13, {0.75f, 0.2f, 0.05f, 1}, [](int i, double t) { return on_vase(t, i / 12.0); });
    add(16, {0.03f, 0.1f, 0.3f, 1}, [](int i, double t) { return on_vase(i / 16.0, t); });
    picture.camera.eye = {0.7, -3.2, 1.4};
    picture.camera.target = {0, 0, 0.47};
    picture.camera.fov_y = 0.4;
    picture.settings.sun_azimuth = -2.1;
    EXPECT_TRUE(
        matches_picture(renderer.render(picture, {480, 270}), "tests/golden/wire_vase.png"));
}

} // namespace trivar::gpu::testing
