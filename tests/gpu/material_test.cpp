// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gpu/support.h"

#include <cmath>

namespace trivar::gpu::testing {

class Materials : public WithContext {
protected:
    Renderer renderer;

    // The colour in the middle of a picture of one instance, seen from the front.
    glm::ivec3 seen(const Instance& instance)
    {
        return rgb_at(renderer.render(picture_of(instance), {48, 48}), {24, 24});
    }
    static Picture picture_of(const Instance& instance)
    {
        Picture picture;
        picture.camera.eye = {0, -6, 0};
        picture.instances = {instance};
        picture.settings.sun_azimuth = -2;
        picture.settings.ground = false;
        return picture;
    }
};

// A square that faces the camera, 2 wide, texture coordinates from bottom left to top right.
Mesh screen()
{
    Mesh mesh;
    mesh.positions = {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}};
    mesh.normals.assign(4, {0, -1, 0});
    mesh.uvs = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
    mesh.corners = {0, 1, 2, 3};
    mesh.face_begin = {0, 4};
    return mesh;
}

// Two rows: red, green above blue, white.
Ref<Image> four_colors(std::uint8_t alpha_of_red = 255)
{
    Image image;
    image.size_px = {2, 2};
    image.rgba = {255, 0, 0, alpha_of_red, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255};
    return make_ref(std::move(image));
}

TEST_F(Materials, PutTheFirstImageRowWhereVIsOne)
{
    Material material;
    material.base_color = glm::vec4(1);
    material.base_color_texture = {.image = four_colors(), .repeat_u = false, .repeat_v = false};
    const Image image =
        renderer.render(picture_of(instance_of(screen(), glm::dmat4(1), material)), {48, 48});
    const glm::ivec3 red = rgb_at(image, {14, 14}), green = rgb_at(image, {34, 14}),
                     blue = rgb_at(image, {14, 34}), white = rgb_at(image, {34, 34});
    EXPECT_GT(red.r, 2 * red.g);
    EXPECT_GT(green.g, 2 * green.r);
    EXPECT_GT(blue.b, 2 * blue.r);
    EXPECT_NEAR(white.r, white.g, 25);
}

TEST_F(Materials, CutAwayWhatIsBelowTheMask)
{
    Material material;
    material.alpha = Material::Alpha::mask;
    material.base_color_texture = {.image = four_colors(0), .repeat_u = false, .repeat_v = false};
    Picture picture = picture_of(instance_of(screen(), glm::dmat4(1), material));
    picture.instances[0].id = 1;
    renderer.draw(picture, {48, 48});
    EXPECT_EQ(renderer.pick({14, 14}), 0);
    EXPECT_EQ(renderer.pick({34, 14}), 1);
}

TEST_F(Materials, MultiplyVertexColors)
{
    Mesh mesh = screen();
    mesh.colors.assign(4, {1, 0.05f, 0.05f, 1});
    const glm::ivec3 c = seen(instance_of(mesh));
    EXPECT_GT(c.r, 2 * c.g);
}

TEST_F(Materials, GlowWithoutLight)
{
    Material black;
    black.base_color = {0, 0, 0, 1};
    Material glowing = black;
    glowing.emissive = {0, 2, 0};
    EXPECT_LT(seen(instance_of(screen(), glm::dmat4(1), black)).g, 60);
    EXPECT_GT(seen(instance_of(screen(), glm::dmat4(1), glowing)).g, 200);
}

TEST_F(Materials, ShowTheInsideOfSingleSidedMeshesInAnotherColor)
{
    const glm::dmat4 turned = glm::rotate(glm::dmat4(1), 3.14159265358979, glm::dvec3(0, 0, 1));
    Material material;
    material.base_color = {0.1f, 0.2f, 0.4f, 1};
    const glm::ivec3 front = seen(instance_of(screen(), glm::dmat4(1), material));
    const glm::ivec3 back = seen(instance_of(screen(), turned, material));
    material.double_sided = true;
    const glm::ivec3 both = seen(instance_of(screen(), turned, material));
    EXPECT_GT(front.b, front.r);
    EXPECT_GT(back.r, back.b);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(both[c], front[c], 3);
}

// A sphere is its own mirror image, so a mirroring matrix must not change its picture.
TEST_F(Materials, LightMirroredInstancesLikeOthers)
{
    const Mesh ball = sphere_mesh(1, 64, 32);
    const Image plain = renderer.render(picture_of(instance_of(ball)), {64, 64});
    const glm::dmat4 mirror = glm::scale(glm::dmat4(1), glm::dvec3(1, -1, 1));
    const Image mirrored = renderer.render(picture_of(instance_of(ball, mirror)), {64, 64});
    double sum = 0;
    for (std::size_t i = 0; i < plain.rgba.size(); ++i)
        sum += std::abs(plain.rgba[i] - mirrored.rgba[i]);
    EXPECT_LT(sum / static_cast<double>(plain.rgba.size()), 0.5);
}

// Squeezing a ball flat turns its normals towards the short axis, not along with the positions.
TEST_F(Materials, TurnNormalsByTheInverseTranspose)
{
    const glm::dmat4 flat = glm::scale(glm::dmat4(1), glm::dvec3(1, 0.01, 1));
    const glm::ivec3 squeezed = seen(instance_of(sphere_mesh(1, 64, 32), flat));
    const glm::ivec3 plane = seen(instance_of(screen()));
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(squeezed[c], plane[c], 6);
}

TEST_F(Materials, LetWhatIsBehindAGhostShineThroughAndCanBePicked)
{
    Picture picture = picture_of(instance_of(screen()));
    Material red;
    red.base_color = {0.8f, 0, 0, 1};
    picture.instances.push_back(instance_of(screen(), moved(0, 2, 0), red));
    const glm::ivec3 solid = rgb_at(renderer.render(picture, {48, 48}), {24, 24});
    picture.instances[0].opacity = 0.3f;
    picture.instances[0].id = 5;
    picture.instances[1].id = 6;
    const glm::ivec3 ghost = rgb_at(renderer.render(picture, {48, 48}), {24, 24});
    EXPECT_EQ(renderer.pick({24, 24}), 5);
    EXPECT_GT(ghost.r - ghost.g, solid.r - solid.g + 30);
    picture.instances[0].id = 0; // a preview does not stand in the way
    renderer.draw(picture, {48, 48});
    EXPECT_EQ(renderer.pick({24, 24}), 6);
}

TEST_F(Materials, SurviveImagesWithoutPixels)
{
    Image broken;
    broken.size_px = {4, 4};
    Material material;
    material.base_color_texture.image = make_ref(broken);
    material.normal_texture.image = make_ref(Image{});
    EXPECT_EQ(seen(instance_of(screen(), glm::dmat4(1), material)), seen(instance_of(screen())));
}

} // namespace trivar::gpu::testing
