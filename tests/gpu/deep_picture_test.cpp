// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/gpu/support.h"

#include <set>

namespace trivar::gpu::testing {
namespace {

class DeepPictures : public WithContext {
protected:
    Renderer renderer;
    // A sphere behind a see-through sheet and a line, on the ground.
    static Picture picture()
    {
        Picture picture;
        picture.camera.eye = {0, -5, 1};
        picture.camera.target = {0, 0, 0};
        picture.instances = {instance_of(sphere_mesh(1, 64, 32))};
        Translucent veil;
        veil.points = {{-1, -2, -0.5f}, {0.5f, -2, -0.5f}, {0.5f, -2, 0.5f}, {-1, -2, 0.5f}};
        veil.colors = {{0.1f, 0.2f, 0.9f, 0.5f}};
        veil.triangles = {0, 1, 2, 0, 2, 3};
        picture.translucent = {veil};
        picture.lines = {{{{-1, -2, 0.8f}, {1, -2, 0.8f}}, {0.9f, 0.1f, 0.1f, 1}, 3}};
        return picture;
    }
};

TEST_F(DeepPictures, ShowTheSameAsOthers)
{
    const glm::ivec2 size(160, 120);
    for (const int samples : {1, 4}) {
        Picture shown = picture();
        shown.samples = samples;
        const Image image = renderer.render(shown, size);
        shown.deep = true;
        renderer.draw(shown, size);
        const DeepImage deep = renderer.deep_image();
        ASSERT_EQ(deep.rgba.size(), image.rgba.size());
        for (std::size_t i = 0; i < image.rgba.size(); ++i) // dithered, and rounded at each sample
            ASSERT_NEAR(image.rgba[i], deep.rgba[i] / 257.0, 4) << samples << ' ' << i;
    }
}

TEST_F(DeepPictures, HaveFinerSteps)
{
    Picture shown;
    shown.deep = true;
    renderer.draw(shown, {64, 480});
    const DeepImage deep = renderer.deep_image();
    std::set<int> steps; // of a backdrop, whose colours go from one to another
    for (std::size_t y = 0; y < 480; ++y) steps.insert(deep.rgba[4 * (y * 64 + 32)]);
    const auto [least, most] = std::pair(*steps.begin(), *steps.rbegin());
    EXPECT_GT(static_cast<int>(steps.size()), 2 * (most - least) / 257);
}

} // namespace
} // namespace trivar::gpu::testing
