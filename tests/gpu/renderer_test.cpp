// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/rejected.h"
#include "gpu/texture.h"
#include "tests/gpu/support.h"

#include <epoxy/gl.h>
#include <limits>
#include <utility>

namespace trivar::gpu::testing {

class TheRenderer : public WithContext {
protected:
    Renderer renderer;
};

Camera looking_at_origin(double distance)
{
    Camera camera;
    camera.eye = {0, -distance, 0};
    camera.target = {0, 0, 0};
    camera.fov_y = 0.6;
    return camera;
}

TEST_F(TheRenderer, DrawsAnEmptyPictureAsABackdropWithoutStructure)
{
    const Image image = renderer.render({}, {64, 48});
    ASSERT_EQ(image.rgba.size(), 64u * 48 * 4);
    for (int y = 0; y < 48; ++y)
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(rgb_at(image, {3, y})[c], rgb_at(image, {60, y})[c], 2); // dither
    EXPECT_NE(rgb_at(image, {0, 0}), rgb_at(image, {0, 47}));
    EXPECT_EQ(image.rgba[3], 255);
}

TEST_F(TheRenderer, DrawsOnPaperAndOnBlackWithoutAnyShade)
{
    for (const auto& [look, level] : {std::pair("paper", 255), std::pair("black", 0)}) {
        Picture picture;
        picture.settings.look = look;
        const Image image = renderer.render(picture, {64, 48});
        for (const glm::ivec2 at : {glm::ivec2(0, 0), glm::ivec2(32, 24), glm::ivec2(63, 47)})
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(rgb_at(image, at)[c], level, 1) << look;
    }
}

TEST(Texture, SaysWhereTheCardHasNoRoom)
{
    const HeadlessContext context;
    EXPECT_THROW(Texture2D(GL_RGBA8, glm::ivec2(1 << 20)), Rejected);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
    EXPECT_EQ(Texture2D(GL_RGBA8, {64, 48}).size_px(), glm::ivec2(64, 48));
}

// A sphere of radius r seen from distance d covers the angle asin(r / d).
TEST_F(TheRenderer, TellsTheTimeOfThePassesThatThePictureNeeds)
{
    Picture picture;
    picture.camera = looking_at_origin(4);
    picture.instances = {instance_of(sphere_mesh(1, 24, 12))};
    picture.samples = 1;
    const auto passes = [&] {
        renderer.draw(picture, {64, 48});
        std::vector<std::string> names;
        for (const auto& stage : renderer.timings().stages) names.push_back(stage.name);
        return names;
    };
    using Names = std::vector<std::string>;
    EXPECT_EQ(passes(), (Names{"upload", "shadow map", "contact map", "surfaces", "occlusion",
                               "light", "backdrop"}));
    picture.curves = {{.line = make_ref(Polyline{{{-1, 0, 0}, {1, 0, 0}}, {}})}};
    picture.instances[0].highlighted = true;
    EXPECT_EQ(passes(),
              (Names{"upload", "surfaces", "occlusion", "light", "backdrop", "curves", "outline"}));
}

TEST_F(TheRenderer, PutsASphereWhereTheCameraProjectsIt)
{
    Picture picture;
    picture.camera = looking_at_origin(5);
    picture.instances = {instance_of(sphere_mesh(1, 128, 64))};
    picture.instances[0].id = 7;
    picture.samples = 1;
    const glm::ivec2 size(200, 160);
    renderer.draw(picture, size);
    const double radius_px = std::tan(std::asin(1.0 / 5)) / std::tan(0.3) * size.y / 2;
    for (int y = 0; y < size.y; y += 3)
        for (int x = 0; x < size.x; x += 3) {
            const double r = glm::length(glm::dvec2(x + 0.5, y + 0.5) - glm::dvec2(size) / 2.0);
            if (std::abs(r - radius_px) < 1) continue;
            EXPECT_EQ(renderer.pick({x, y}), r < radius_px ? 7 : 0) << x << ' ' << y;
        }
}

TEST_F(TheRenderer, PicksWhatTheCameraProjectsThere)
{
    for (const bool perspective : {true, false}) {
        Picture picture;
        picture.camera.perspective = perspective;
        picture.camera.height_world = 6;
        const glm::ivec2 size(160, 120);
        picture.camera.size_px = size;
        for (int i = 0; i < 3; ++i) {
            picture.instances.push_back(instance_of(sphere_mesh(0.3, 24, 12), moved(i - 1, 0, i)));
            picture.instances.back().id = i + 1;
        }
        renderer.draw(picture, size);
        for (int i = 0; i < 3; ++i) {
            const glm::ivec2 p(project(picture.camera, glm::dvec3(i - 1, 0, i)).p_px);
            EXPECT_EQ(renderer.pick(p), i + 1);
        }
        EXPECT_EQ(renderer.pick({0, 0}), 0);
        EXPECT_EQ(renderer.pick({-1, 500}), 0);
    }
}

TEST_F(TheRenderer, DrawsTheSamePictureTwiceBitByBit)
{
    Picture picture;
    picture.camera = looking_at_origin(4);
    picture.instances = {instance_of(torus_mesh(0.8, 0.3, {48, 24}))};
    const Image first = renderer.render(picture, {96, 64});
    Renderer another;
    EXPECT_EQ(first.rgba, another.render(picture, {96, 64}).rgba);
    EXPECT_EQ(first.rgba, renderer.render(picture, {96, 64}).rgba);
}

std::vector<std::uint8_t> texels(unsigned texture, glm::ivec2 size_px)
{
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(size_px.x * size_px.y) * 4);
    glBindTexture(GL_TEXTURE_2D, texture);
    glGetTexImage(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, bytes.data());
    return bytes;
}

TEST_F(TheRenderer, DrawsInPiecesWhatItDrawsAtOnceAndShowsTheLastPictureMeanwhile)
{
    const glm::ivec2 size(96, 64);
    Picture picture;
    picture.camera = looking_at_origin(4);
    picture.instances = {instance_of(torus_mesh(0.8, 0.3, {48, 24}))};
    const auto whole = texels(Renderer().draw(picture, size), size);
    Picture draft = picture;
    draft.draft = true;
    draft.camera = looking_at_origin(5);
    const auto before = texels(renderer.draw(draft, size), size);
    renderer.begin(picture, size);
    int pieces = 1;
    for (; !renderer.advance(0); ++pieces)
        ASSERT_EQ(texels(renderer.texture(), size), before) << "after piece " << pieces;
    EXPECT_GT(pieces, 4 * picture.samples);
    EXPECT_EQ(texels(renderer.texture(), size), whole);

    renderer.begin(draft, size); // a picture that is begun anew does not disturb the next
    renderer.advance(0);
    EXPECT_EQ(texels(renderer.draw(picture, size), size), whole);
}

// The frames of a sequence are drawn in any order: shadows on the ground, and glass.
TEST_F(TheRenderer, DrawsInPiecesWithNothingLeftOfThePictureBefore)
{
    const glm::ivec2 size(96, 64);
    for (const bool draft : {true, false}) {
        Picture picture;
        picture.draft = draft;
        picture.samples = 1;
        picture.camera = looking_at_origin(6);
        picture.camera.eye.z = 3;
        picture.instances = {instance_of(torus_mesh(0.8, 0.3, {48, 24})),
                             instance_of(sphere_mesh(0.5, 24, 12))};
        picture.instances[1].opacity = 0.5f;
        Picture before = picture;
        before.instances[0].to_world[3].x = 1;
        Renderer alone;
        const auto drawn = [&](Renderer& by, const Picture& wanted) {
            by.begin(wanted, size);
            while (!by.advance(1e9)) continue;
            return texels(by.texture(), size);
        };
        const auto first = drawn(alone, picture);
        EXPECT_EQ(drawn(alone, picture), first) << draft;
        EXPECT_NE(drawn(alone, before), first) << draft;
        EXPECT_EQ(drawn(alone, picture), first) << draft;
    }
}

TEST_F(TheRenderer, DrawsADraftSmallerAndStillPicksByThePlaceItIsShownAt)
{
    Picture picture;
    picture.camera = looking_at_origin(4);
    picture.instances = {instance_of(sphere_mesh(1, 48, 24))};
    picture.instances[0].id = 3;
    picture.draft = true;
    picture.scale = 0.5;
    const glm::ivec2 size(96, 64);
    EXPECT_EQ(renderer.render(picture, size).size_px, size / 2);
    EXPECT_EQ(renderer.pick({48, 32}), 3);
    EXPECT_EQ(renderer.pick({95, 63}), 0);
    EXPECT_EQ(renderer.pick({96, 32}), 0);
    // A full picture follows in its own size, and the draft shows until it is there.
    Picture full = picture;
    full.draft = false;
    full.scale = 1;
    const unsigned draft = renderer.texture();
    renderer.begin(full, size);
    while (!renderer.advance(0)) ASSERT_EQ(renderer.texture(), draft);
    EXPECT_EQ(texels(renderer.texture(), size), texels(Renderer().draw(full, size), size));
}

TEST_F(TheRenderer, RefusesSizesThatCannotBeDrawn)
{
    EXPECT_THROW(renderer.draw({}, {0, 10}), Rejected);
    EXPECT_THROW(renderer.draw({}, {10, 1 << 20}), Rejected);
}

TEST_F(TheRenderer, RefusesACameraThatLooksNowhere)
{
    Picture picture;
    picture.camera.target = picture.camera.eye;
    EXPECT_THROW(renderer.draw(picture, {32, 32}), Rejected);
    picture.camera.target.x = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(renderer.draw(picture, {32, 32}), Rejected);
}

TEST_F(TheRenderer, ShowsWhatIsNearHoweverFarTheSceneReaches)
{
    Picture picture;
    picture.camera = looking_at_origin(4);
    picture.instances = {instance_of(sphere_mesh(1, 16, 8)),
                         instance_of(sphere_mesh(1, 16, 8), moved(0, 1e6, 0))};
    picture.instances[0].id = 1;
    picture.lines = {{.points = {{0, 0, 0}, {0, 1e30f, 0}}}};
    renderer.draw(picture, {32, 32});
    EXPECT_EQ(renderer.pick({16, 16}), 1);
}

TEST_F(TheRenderer, DrawsFarFromTheOriginAsItDoesThere)
{
    Picture picture;
    picture.camera = looking_at_origin(4);
    picture.instances = {instance_of(torus_mesh(0.8, 0.3, {48, 24}))};
    const Image here = renderer.render(picture, {96, 64});
    const glm::dvec3 away(0, 0, 1 << 20); // exact in both
    picture.camera.eye += away;
    picture.camera.target += away;
    picture.instances[0].to_world = moved(away.x, away.y, away.z);
    EXPECT_EQ(renderer.render(picture, {96, 64}).rgba, here.rgba);
}

TEST_F(TheRenderer, LeavesOutInstancesThatAreNowhere)
{
    Picture picture;
    picture.camera = looking_at_origin(4);
    picture.instances = {instance_of(sphere_mesh(1, 16, 8)), Instance{}, instance_of(Mesh{}),
                         instance_of(sphere_mesh(1, 16, 8), glm::dmat4(0.0 / 0.0))};
    picture.instances[0].id = 1;
    picture.instances[3].id = 2;
    renderer.draw(picture, {32, 32});
    EXPECT_EQ(renderer.pick({16, 16}), 1);
}

TEST_F(TheRenderer, KeepsTheGridWhereItIsWhenTheSceneGrows)
{
    // A small thing far below moves the scene's middle, not the lines under the big one.
    Picture picture;
    picture.camera.eye = {0, -3, 9};
    picture.settings.shadows = false;
    picture.instances = {instance_of(sphere_mesh(0.9, 48, 24), moved(0, 0, 0.9))};
    picture.grid = true;
    picture.samples = 1;
    Backdrop backdrop;
    backdrop.top = backdrop.middle = backdrop.bottom = glm::vec3(0.2f);
    backdrop.corners = 0;
    backdrop.grid = backdrop.grid_major = {0, 0, 0, 0};
    backdrop.axis_x = {1, 0, 0, 1};
    backdrop.axis_y = {0, 1, 0, 1};
    picture.backdrop = backdrop;
    const glm::ivec2 size(200, 200);
    picture.camera.size_px = size;
    const auto color_at = [&](double x, double y) {
        const auto p = project(picture.camera, {x, y, 0}).p_px;
        return rgb_at(renderer.render(picture, size), glm::ivec2(p));
    };
    for (const double more : {0.0, 0.37}) {
        picture.instances.resize(1);
        if (more > 0)
            picture.instances.push_back(
                instance_of(sphere_mesh(0.05, 8, 4), moved(more, 1.2 * more, 0.05)));
        EXPECT_GT(color_at(1.3, 0).r, color_at(1.3, 0).g + 60) << "x is red";
        EXPECT_GT(color_at(0, -1.3).g, color_at(0, -1.3).r + 60) << "y is green";
        EXPECT_LT(glm::length(glm::vec3(color_at(1.3, 0.3) - color_at(-1.3, -0.3))), 20);
    }
}

TEST_F(TheRenderer, DrawsTheGridAtHeightZeroWhateverStandsThere)
{
    Picture picture;
    picture.settings.shadows = false;
    picture.grid = true;
    picture.samples = 1;
    Backdrop backdrop;
    backdrop.top = backdrop.middle = backdrop.bottom = glm::vec3(0.2f);
    backdrop.corners = 0;
    backdrop.grid = backdrop.grid_major = {0, 0, 0, 0};
    backdrop.axis_x = {1, 0, 0, 1};
    backdrop.axis_z = {0, 0, 1, 1};
    picture.backdrop = backdrop;
    const glm::ivec2 size(200, 200);
    picture.camera.size_px = size;
    const auto color_at = [&](const glm::dvec3& p) {
        return rgb_at(renderer.render(picture, size), glm::ivec2(project(picture.camera, p).p_px));
    };
    for (const double z : {-0.5, 0.0, 2.0}) { // sunk into it, half in it, above it
        picture.instances = {instance_of(sphere_mesh(0.4, 24, 12), moved(0, 0, z))};
        picture.camera.eye = {0, -7, 5};
        picture.camera.perspective = true;
        EXPECT_GT(color_at({1.3, 0, 0}).r, color_at({1.3, 0, 0}).g + 60) << z;
        // The grid seen from the front is the upright plane of X and Z.
        picture.camera.eye = {0, -7, 0};
        picture.camera.perspective = false;
        picture.camera.height_world = 6;
        EXPECT_GT(color_at({1.3, 0, 0}).r, color_at({1.3, 0, 0}).g + 60) << z;
        EXPECT_GT(color_at({0, 0, 1.3}).b, color_at({0, 0, 1.3}).g + 60) << z;
    }
}

// The edges of a ball alone, white on black, as they are shown in place of its surface.
Picture edges_of_a_ball(int segments)
{
    Picture picture;
    picture.camera = looking_at_origin(5);
    picture.settings.wire = true;
    picture.settings.ground = false;
    picture.backdrop = Backdrop{};
    picture.edges = {glm::vec3(1), true};
    picture.instances = {instance_of(sphere_mesh(1, segments, segments / 2))};
    picture.instances[0].opacity = 0.003f;
    return picture;
}

// Bytes a pixel of that square that the ball adds to the picture.
double added(const Image& with, const Image& without, glm::ivec2 middle, int half)
{
    double sum = 0;
    for (int y = -half; y < half; ++y)
        for (int x = -half; x < half; ++x) {
            const glm::ivec2 p = middle + glm::ivec2(x, y);
            sum += rgb_at(with, p).g - rgb_at(without, p).g;
        }
    return sum / (4.0 * half * half);
}

TEST_F(TheRenderer, ShowsTheFormOfADenseBallByItsEdgesAlone)
{
    const glm::ivec2 size(160, 160), middle = size / 2;
    Picture picture = edges_of_a_ball(400);
    const Image ball = renderer.render(picture, size);
    picture.instances.clear();
    const Image nothing = renderer.render(picture, size);
    const double lit = added(ball, nothing, middle + glm::ivec2(-18, -18), 8);
    const double dark = added(ball, nothing, middle + glm::ivec2(24, 24), 8);
    EXPECT_GT(lit, 1.3 * dark);
    EXPECT_GT(dark, 2);
    EXPECT_LT(lit, 180) << "it is no white disc";
}

} // namespace trivar::gpu::testing
